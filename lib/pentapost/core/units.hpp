#pragma once

#include <Eigen/Dense>

#include <cmath>
#include <compare>
#include <numbers>

namespace pentapost {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

inline constexpr double pi = std::numbers::pi;
inline constexpr double rad_per_deg = pi / 180.0;
inline constexpr double deg_per_rad = 180.0 / pi;
inline constexpr double mm_per_inch = 25.4;

/// An angle that crosses an interface. Inside a kernel: double with _rad in its name.
class Angle {
 public:
  constexpr Angle() = default;
  static constexpr Angle radians(double angle_rad) { return Angle{angle_rad}; }
  static constexpr Angle degrees(double angle_deg) { return Angle{angle_deg * rad_per_deg}; }
  constexpr double rad() const { return rad_; }
  constexpr double deg() const { return rad_ * deg_per_rad; }
  constexpr auto operator<=>(const Angle&) const = default;
  constexpr Angle operator-() const { return Angle{-rad_}; }

 private:
  explicit constexpr Angle(double angle_rad) : rad_{angle_rad} {}
  double rad_ = 0.0;
};

/// A closed interval.
template <class T>
struct Range {
  T lower;  ///< included
  T upper;  ///< included, >= lower
  constexpr bool contains(const T& value) const { return lower <= value && value <= upper; }
  constexpr bool operator==(const Range&) const = default;
};

/// A direction of length 1, normalised on construction.
class UnitVector {
 public:
  /// @param direction  finite and not zero, of any size, otherwise std::logic_error.
  static UnitVector normalised(const Vec3& direction);
  const Vec3& vec() const noexcept { return vec_; }
  UnitVector operator-() const { return UnitVector{-vec_}; }

 private:
  explicit UnitVector(const Vec3& unit) : vec_{unit} {}
  Vec3 vec_;
};

/// Angle between two vectors, 0 to pi; keeps its digits near 0 and pi, where acos loses half.
/// Lengths must lie within 1e-150 and 1e150, so that their products are numbers.
inline double angle_between_rad(const Vec3& x, const Vec3& y) {
  return std::atan2(x.cross(y).norm(), x.dot(y));
}

/// `angle_rad` (finite) less whole turns, in [-pi, pi].
inline double wrapped_rad(double angle_rad) { return std::remainder(angle_rad, 2.0 * pi); }

}  // namespace pentapost
