#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/jobs/analyse.hpp"

namespace pentapost::jobs {

/// analyse() of a job whose path is a finished NC program. Its places count motion blocks and lines
/// of the program; its workpiece coordinates are the program's.
///
/// @return Problem as analyse_nc(), or conflicting_keys: the program contains the turn of the setup
///         already.
Result<AnalyseReport> analyse_program(const AnalyseJob& job);

}  // namespace pentapost::jobs
