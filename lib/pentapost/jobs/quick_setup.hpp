#pragma once

#include "pentapost/jobs/analyse.hpp"
#include "pentapost/jobs/prepared_job.hpp"
#include "pentapost/reorient/setup_domain.hpp"

#include <optional>

namespace pentapost::jobs {

/// A setup with a low peak ratio, as reorient() looks for it with its defaults, but by a short
/// search: the best one may be a little better.
///
/// @param in_cl  of the job, its tool path in CL coordinates, holes as single moves.
/// @return nullopt: the machine has no two rotary axes or no speed limit, the path is long, or no
///         setup is known to be possible and clear.
std::optional<reorient::SetupPoint> quick_setup(const AnalyseJob& job, const PreparedJob& in_cl);

}  // namespace pentapost::jobs
