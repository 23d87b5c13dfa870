#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/jobs/prepared_job.hpp"
#include "pentapost/jobs/reorient.hpp"
#include "pentapost/reorient/setup_domain.hpp"

namespace pentapost::jobs {

/// The setups that a job allows. Angles that are the same setup by another name are left out.
///
/// @return Problem out_of_domain or conflicting_keys with the pointer, or where none is left.
Result<reorient::SetupDomain> setup_choices(const ReorientJob& job, const PreparedJob& prepared);

}  // namespace pentapost::jobs
