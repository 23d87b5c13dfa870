#pragma once

#include "pentapost/clearance/check.hpp"
#include "pentapost/clearance/model.hpp"
#include "pentapost/core/diagnostics.hpp"
#include "pentapost/core/result.hpp"
#include "pentapost/jobs/post.hpp"
#include "pentapost/jobs/prepared_job.hpp"

#include <optional>

namespace pentapost::jobs {

/// The check for collisions that a job asks for, or that its machine definition has figures for.
/// Parts that `requested` has replace those of the definition.
///
/// What the definition alone has is checked where origin and gauge lengths are known; where they
/// are not, a warning clearance_unchecked says so.
///
/// @param prepared  of the job, its path turned by the job's setup; holes may be in it.
/// @param origin_bounded  the place of the CL origin is known though job.setup has none.
/// @return to be asked by the turn of a setup, turn_of(), and the place of the CL origin; nullopt:
///         nothing to check. Problem out_of_domain; missing_key where `requested` and the
///         definition together have nothing that could collide; origin_missing;
///         gauge_length_missing.
Result<std::optional<clearance::Check>> clearance_check(
    const PostJob& job, const PreparedJob& prepared,
    const std::optional<clearance::Model>& requested, bool origin_bounded,
    Diagnostics& diagnostics);

}  // namespace pentapost::jobs
