#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/jobs/analysis_report.hpp"
#include "pentapost/jobs/nc_program.hpp"
#include "pentapost/jobs/post.hpp"

#include <cstddef>
#include <optional>

namespace pentapost::jobs {

struct AnalyseJob {
  static constexpr std::size_t most_samples = 100'000;

  PostJob job;
  std::optional<NcProgram> nc = {};  ///< takes the place of job.path, which is not read then
  double zone_share = 1.0;  ///< of a speed limit, from which a stretch counts as a zone; > 0
  /// Most samples, Samples::fewest to most_samples; nullopt: none, and no accelerations.
  std::optional<std::size_t> samples = {};
};

/// Where and why the path of a job is singular on its machine, and what it asks of the axes.
///
/// @return Problem: CL data, NC program or a number of the job (400), or this machine can't (422).
Result<AnalyseReport> analyse(const AnalyseJob& job);

}  // namespace pentapost::jobs
