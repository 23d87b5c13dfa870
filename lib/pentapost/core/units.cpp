#include "pentapost/core/units.hpp"

#include <stdexcept>

namespace pentapost {

UnitVector UnitVector::normalised(const Vec3& direction) {
  const double length = direction.stableNorm();
  if (!(length > 0.0) || !std::isfinite(length))
    throw std::logic_error{"UnitVector: the direction is zero or not finite"};
  return UnitVector{direction / length};
}

}  // namespace pentapost
