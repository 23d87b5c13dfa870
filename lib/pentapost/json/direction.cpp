#include "pentapost/json/direction.hpp"

#include "pentapost/core/number_text.hpp"

#include <cmath>

namespace pentapost::json {

UnitVector direction_of(const Object& object, std::string_view key, Code not_unit) {
  constexpr double slack = 1e-6;  // what rounding of printed digits explains
  const Vec3 direction = object.vector3(key);
  const double length = direction.stableNorm();
  if (std::abs(length - 1.0) <= slack) return UnitVector::normalised(direction);
  object.fail_at(key, not_unit,
                 "the direction has the length " + number_text(length) + "; expected 1");
  return UnitVector::normalised(Vec3::UnitZ());
}

}  // namespace pentapost::json
