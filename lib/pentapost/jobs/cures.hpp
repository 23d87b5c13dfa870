#pragma once

#include "pentapost/jobs/analyse.hpp"
#include "pentapost/jobs/analysis_report.hpp"
#include "pentapost/jobs/prepared_job.hpp"

namespace pentapost::jobs {

/// Finds what else can be done about each zone that is over a limit, by analysing the path again
/// with the other tilt, with the tool axis led through the poles and in another setup. Cures that
/// leave the load as it is are not named; the least time lost comes first.
///
/// @param prepared  its tool path not led through any pole.
/// @param analysed  the tool path that has the zones.
void find_cures(const AnalyseJob& job, const PreparedJob& prepared, const path::ToolPath& analysed,
                ZonesReport& zones);

}  // namespace pentapost::jobs
