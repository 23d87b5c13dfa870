#pragma once

#include "pentapost/core/codes.hpp"
#include "pentapost/core/units.hpp"
#include "pentapost/json/strict_reader.hpp"

#include <string_view>

namespace pentapost::json {

/// The direction of `key`, of unit length but for the rounding of its digits (1e-6), and
/// normalised; the z axis after a failure.
/// @param not_unit  the code of another length.
UnitVector direction_of(const Object& object, std::string_view key, Code not_unit);

}  // namespace pentapost::json
