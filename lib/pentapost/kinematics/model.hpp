#pragma once

#include "pentapost/core/units.hpp"
#include "pentapost/machine/chain.hpp"

#include <array>
#include <string>

namespace pentapost::kinematics {

/// Values of all joints. A joint that the chain lacks stays 0.
struct Joints {
  Vec3 linear_mm = Vec3::Zero();  ///< in the order of Model::linear_names
  double first_rad = 0.0;         ///< rotary joint nearest the workpiece
  double second_rad = 0.0;        ///< the other one
};

/// Tool as seen from the table: in the frame of a part that is set up in the table frame's origin
/// without a turn. The "table frame" is carried by the table; with all joints at zero it is the
/// base frame.
struct Pose {
  Vec3 tip_mm;
  Vec3 axis;  ///< unit, tip towards spindle
};

/// A chain made ready for fast evaluation (lib/README.md section 1): with the directions of the
/// joints that carry the workpiece negated, the tool in the table frame is one product of joint
/// motions from the workpiece to the tool. Immutable.
struct Model {
  explicit Model(const machine::Chain& chain);

  int rotary_count = 0;
  std::array<std::string, 3> linear_names;  ///< A to Z
  std::array<std::string, 2> rotary_names;  ///< nearest the workpiece first
  bool head_turns = false;

  Vec3 a = Vec3::UnitZ();  ///< direction of the first rotary joint, table frame, all at zero
  Vec3 b = Vec3::UnitX();  ///< of the second
  Vec3 t = Vec3::UnitZ();  ///< tool axis, all at zero
  Vec3 a_point_mm = Vec3::Zero(), b_point_mm = Vec3::Zero();

  /// Linear directions by their place in the chain: [0] before a, [1] between a and b, [2] after b.
  /// Columns in the order of linear_names; a joint's column is zero in the places where it is not.
  std::array<Mat3, 3> linear_columns{Mat3::Zero(), Mat3::Zero(), Mat3::Zero()};
  std::array<bool, 3> has_linear{};  ///< whether linear_columns[i] is not zero

  // The spherical triangle of section 2, flipped so that lambda and mu are at most 90 degrees.
  double lambda_rad = 0.0;  ///< angle between a and b; one rotary joint: angle between a and t
  double mu_rad = 0.0;      ///< angle between b and t
  bool a_flipped = false;   ///< the triangle is drawn with -a
  bool b_flipped = false;   ///< the triangle is drawn with -b
  /// Value of the second joint, as commanded, at which t lies in the plane of a and b, as near to a
  /// (as drawn) as it gets.
  double beta_zero_rad = 0.0;

  /// What the evaluation needs at every pose and the chain alone decides (lib/README.md section 2).
  struct Fixed {
    Vec3 p = Vec3::UnitX(), q = Vec3::UnitY();  ///< a, p, q: right-handed and orthonormal
    Vec3 a_drawn = Vec3::UnitZ();               ///< a as the triangle has it
    double sin_half_difference = 0.0, cos_half_difference = 1.0;  ///< of (mu - lambda) / 2
    double sin_half_sum = 0.0, cos_half_sum = 1.0;                ///< of (lambda + mu) / 2
    double sin_lambda_sin_mu = 0.0;
    /// The tool axis at second = beta_zero + d and first = 0, seen along a, on p and q:
    /// start + (1 - cos d) * turned_half + sin d * turned_quarter.
    Eigen::Vector2d start{0.0, 0.0}, turned_half{0.0, 0.0}, turned_quarter{0.0, 0.0};
    int linear_place = -1;       ///< the one place of all linear joints; -1: several places
    double linear_volume = 1.0;  ///< determinant of the linear directions, all at zero
    Mat3 linear_inverse = Mat3::Identity();  ///< of the matrix of linear directions, all at zero
  } fixed;
};

/// Rotation by `angle_rad` right-handed about the unit vector `axis`.
Mat3 rotation(const Vec3& axis, double angle_rad);

}  // namespace pentapost::kinematics
