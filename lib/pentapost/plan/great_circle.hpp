#pragma once

#include "pentapost/core/units.hpp"

#include <cmath>

namespace pentapost::plan {

/// The great circle between two tool axes that are neither equal nor opposite, run evenly.
struct GreatCircle {
  GreatCircle(const Vec3& axis_from, const Vec3& axis_to)
      : from{axis_from},
        across{(axis_from.cross(axis_to)).cross(axis_from).normalized()},
        angle_rad{angle_between_rad(axis_from, axis_to)} {}

  Vec3 at(double turned_rad) const {
    return std::cos(turned_rad) * from + std::sin(turned_rad) * across;
  }
  Vec3 axis(double fraction) const { return at(fraction * angle_rad); }
  /// Turn at which the circle is nearest to `direction`, in [-pi, pi].
  double nearest_rad(const Vec3& direction) const {
    return std::atan2(direction.dot(across), direction.dot(from));
  }
  double nearest_fraction(const Vec3& direction) const {
    return nearest_rad(direction) / angle_rad;
  }

  Vec3 from, across;
  double angle_rad;
};

}  // namespace pentapost::plan
