#pragma once

#include "pentapost/jobs/post.hpp"
#include "pentapost/jobs/prepared_job.hpp"
#include "pentapost/plan/program.hpp"

namespace pentapost::jobs {

/// Reports where the axes of a planned program are over their speed limits, and the time that
/// follows.
///
/// @param planned  the tool path of the program.
void report_zones(const PostJob& job, const PreparedJob& prepared, const path::ToolPath& planned,
                  const plan::Program& program, PostReport& report);

/// Writes a warning into the program where each zone of the report begins.
void comment_zones(const PostReport& report, const path::ToolPath& planned, path::Motion& motion);

}  // namespace pentapost::jobs
