#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/verify/proof.hpp"

#include <cstdint>

namespace pentapost::verify {

/// Whether the claim says that the tool axis at an end of the move to `point` was changed.
bool has_changed_axis(const Claim& claim, std::uint32_t point);

/// Holds the changed axes of a claim to what may be changed: no more than pole_axis_rad, on
/// straight feed moves alone, and both ends of each such move near a pole.
///
/// @return Problem proof_failed with the CL line.
Status check_pole_allowance(const Claim& claim);

}  // namespace pentapost::verify
