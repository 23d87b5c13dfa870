#pragma once

#include "pentapost/jobs/prepared_job.hpp"
#include "pentapost/reorient/path_loads.hpp"

namespace pentapost::jobs {

/// What the path of a job asks of the axes in any clamping, by the limits and ranges of the job.
///
/// @param prepared  its tool path in CL coordinates, holes as single moves; two rotary axes.
/// @param check_linear  the place of the CL origin and the gauge lengths are known.
reorient::PathLoads path_loads(const PreparedJob& prepared, bool check_linear);

/// Whether any axis has a speed limit to measure by.
bool has_speed_limit(const PreparedJob& prepared);

}  // namespace pentapost::jobs
