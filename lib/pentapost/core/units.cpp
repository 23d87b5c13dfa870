#include "pentapost/core/units.hpp"

#include <stdexcept>

namespace pentapost {
namespace {

/// `direction` times the power of two that brings its largest component to [1, 2): exact, so that
/// the length of vectors next to the ends of the number range can be taken.
Vec3 brought_to_one(const Vec3& direction) {
  const int exponent = std::ilogb(direction.cwiseAbs().maxCoeff());
  return direction.unaryExpr(
      [exponent](double component) { return std::scalbn(component, -exponent); });
}

}  // namespace

UnitVector UnitVector::normalised(const Vec3& direction) {
  const double squared = direction.squaredNorm();
  if (squared > 1e-200 && squared < 1e200) return UnitVector{direction / std::sqrt(squared)};
  if (!direction.allFinite() || direction.isZero(0.0))
    throw std::logic_error{"UnitVector: the direction is zero or not finite"};
  return UnitVector{brought_to_one(direction).normalized()};
}

}  // namespace pentapost
