#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/jobs/post.hpp"

namespace pentapost::jobs {

/// Whether the numbers of a job that stand for themselves are within their domains.
///
/// @return Problem out_of_domain with value, limit and pointer, or conflicting_keys.
Status check_domain(const PostJob& job);

/// @return Problem out_of_domain unless the share of a speed limit is above 0.
Status check_zone_share(double share);

}  // namespace pentapost::jobs
