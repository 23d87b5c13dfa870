#pragma once

#include "pentapost/jobs/prepared_job.hpp"
#include "pentapost/plan/pole_bend.hpp"
#include "pentapost/plan/settings.hpp"

namespace pentapost::jobs {

/// The path of a job led through the poles that it passes within settings.pole_axis_rad; after
/// expand_holes(). None at all where the bends together would cost a retract, time, or a higher
/// load of the axes than the CL's own path.
plan::PoleBends bend_at_poles(const PreparedJob& prepared, const plan::Settings& settings);

}  // namespace pentapost::jobs
