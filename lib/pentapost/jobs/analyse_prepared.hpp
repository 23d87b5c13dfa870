#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/jobs/analyse.hpp"
#include "pentapost/jobs/prepared_job.hpp"

namespace pentapost::jobs {

enum class CureSearch { none, all };

/// analyse() of CL data that are prepared. The holes of the prepared path become single moves; its
/// diagnostics move into the report.
///
/// @param cures  none: zones have the lower feed alone, which costs no further analysis.
Result<AnalyseReport> analyse_prepared(const AnalyseJob& job, PreparedJob& prepared,
                                       CureSearch cures);

}  // namespace pentapost::jobs
