#pragma once

#include "pentapost/core/units.hpp"

#include <cmath>

namespace pentapost::kinematics {

/// Sine and cosine of one angle.
struct SineCosine {
  explicit SineCosine(double angle_rad) : sine{std::sin(angle_rad)}, cosine{std::cos(angle_rad)} {}
  SineCosine(double sine_given, double cosine_given) : sine{sine_given}, cosine{cosine_given} {}
  SineCosine operator-() const { return {-sine, cosine}; }
  double sine, cosine;
};

/// `vector` turned right-handed about the unit vector `axis` (Rodrigues' formula).
inline Vec3 rotated(const Vec3& axis, const SineCosine& angle, const Vec3& vector) {
  return angle.cosine * vector + angle.sine * axis.cross(vector) +
         (1.0 - angle.cosine) * axis.dot(vector) * axis;
}

}  // namespace pentapost::kinematics
