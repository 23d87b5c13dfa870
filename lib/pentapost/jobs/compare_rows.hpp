#pragma once

#include "pentapost/jobs/compare.hpp"

#include <functional>
#include <vector>

namespace pentapost::jobs {

/// What is worked out for a machine, with its Problem or an exception where that fails.
struct RowWork {
  std::function<Result<CompareFigures>(const machine::Definition&)> figures;
  /// Empty: no setups are asked for.
  std::function<Result<CompareReorientation>(const machine::Definition&)> reorientation = {};
};

/// A row a machine. An exception becomes its row's Code::defect.
///
/// The order, each where those before are equal: possible before not possible; known to be within
/// limits before over one or without a known limit; all limits known, some, none; less predicted
/// time, to 1 ms; fewer retracts; a smaller largest ratio, to 1e-6, none last; name; version; order
/// of the job.
std::vector<CompareRow> compare_rows(const CompareJob& job, const RowWork& work);

}  // namespace pentapost::jobs
