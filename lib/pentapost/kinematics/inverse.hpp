#pragma once

#include "pentapost/kinematics/model.hpp"
#include "pentapost/kinematics/turns.hpp"

#include <array>
#include <optional>

namespace pentapost::kinematics {

/// One way to reach a tool axis.
struct RotaryBranch {
  double first_rad = 0.0;   ///< in [-pi, pi]
  double second_rad = 0.0;  ///< beta_zero +- opening, not wrapped: continuous along a path
};

/// All rotary joint values that bring the tool axis to a direction, less whole turns. Each of two
/// branches is continuous along a path that keeps off the poles and the boundaries of the reach.
struct RotarySolutions {
  int count = 0;  ///< 0: out of reach; 1: one rotary joint, or none; 2: +opening and -opening
  std::array<RotaryBranch, 2> branch{};
  /// Tool axis parallel to the first rotary axis: any value of it serves, 0 is given.
  bool first_is_free = false;
  /// Angle at b in the triangle, 0 to pi, singular at both ends; pi/2 where there is no triangle.
  double opening_rad = 0.0;
  /// Angle between the first rotary axis (as the triangle has it) and the tool axis.
  double gamma_rad = 0.0;
  /// How far gamma lies beyond the nearest boundary of the reach; <= 0: inside.
  double beyond_rad = 0.0;
};

/// Rotary joint values for the tool axis `axis` (unit, table frame).
///
/// @param slack_rad  a tool axis that lies beyond the reach by no more than this is taken as on the
///                   boundary. Rounding of the arithmetic itself (1e-14 rad) is always forgiven.
/// @return count 0 where the axis is out of reach: a value, not a Problem, since only the caller
///         knows the CL line.
/// @note Accuracy: forward_axis of every branch is within 1e-13 of `axis` (slack aside), next to
///       poles and boundaries too; a tilt of 1e-9 rad off the pole comes back as 1e-9 rad.
/// Source: lib/README.md section 2; Cripps et al. 2017 Table 1 is lambda = mu = 90 deg.
RotarySolutions inverse_rotary(const Model& model, const Vec3& axis, double slack_rad = 0.0);

/// One branch of inverse_rotary() alone, at half its cost; the values are the same to the last bit.
struct RotaryInside {
  double first_rad = 0.0;    ///< of the branch, in [-pi, pi]
  double opening_rad = 0.0;  ///< 0 or pi, too, where the axis is beyond the reach
  double sin_gamma = 0.0;    ///< of the angle to the first rotary axis; 0 at a pole
};
/// For two rotary joints and a tool axis that is within reach and not at a pole, which the opening
/// and sin_gamma of the answer tell; otherwise inverse_rotary() is to be asked.
RotaryInside inverse_rotary_inside(const Model& model, const Vec3& axis, int branch);

/// Linear joint values that bring the tool tip to `tip_mm` (table frame) at given rotary values.
/// @return nullopt where the linear directions lose rank: where the volume that they span is below
///         1e-6 of that at zero (a quill on a head that lies down).
std::optional<Vec3> inverse_linear(const Model& model, const Vec3& tip_mm, double first_rad,
                                   double second_rad, double gauge_length_mm);
std::optional<Vec3> inverse_linear(const Model& model, const Vec3& tip_mm, const Turns& turn,
                                   double gauge_length_mm);

}  // namespace pentapost::kinematics
