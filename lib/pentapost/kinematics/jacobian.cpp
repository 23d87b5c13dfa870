#include "pentapost/kinematics/jacobian.hpp"

#include "pentapost/kinematics/linear_solve.hpp"
#include "pentapost/kinematics/turns.hpp"

#include <cmath>

namespace pentapost::kinematics {
namespace {

/// Sine of the opening below which rounding decides the rates.
constexpr double smallest_opening_sine = 1e-12;
/// Share of an axis velocity that one rotary joint, or none, may fail to follow.
constexpr double follow_ratio = 1e-6;

/// Directions and levers of the rotary joints in a posture, table frame.
struct Posture {
  Mat3 linear;         ///< tip per linear joint
  Vec3 b;              ///< direction of the second joint
  Vec3 axis;           ///< tool axis
  Vec3 tip_first_mm;   ///< tip per rad of the first joint
  Vec3 tip_second_mm;  ///< tip per rad of the second joint
};

Posture posture(const Model& model, const Joints& joints, double gauge_length_mm) {
  const Turns turn{model, joints.first_rad, joints.second_rad};
  const Vec3& linear = joints.linear_mm;
  const Vec3 lever_b_mm =
      turn.second(-model.b_point_mm - gauge_length_mm * model.t + model.linear_columns[2] * linear);
  const Vec3 lever_a_mm = turn.first(model.b_point_mm - model.a_point_mm +
                                     model.linear_columns[1] * linear + lever_b_mm);
  return {.linear = turn.linear_matrix(),
          .b = turn.first(model.b),
          .axis = turn.tool_axis(),
          .tip_first_mm = model.a.cross(lever_a_mm),
          .tip_second_mm = turn.first(model.b.cross(lever_b_mm))};
}

/// Rates of the rotary joints; nullopt as joint_rates().
std::optional<Eigen::Vector2d> rotary_rates(const Model& model, const Posture& at,
                                            double second_rad, const Vec3& axis_rate) {
  if (model.rotary_count == 2) {
    // [a, o, b'] by the angle itself: as a product of vectors it would lose its digits near the
    // pole.
    const double opening_sine = std::sin(second_rad - model.beta_zero_rad);
    if (!(std::abs(opening_sine) >= smallest_opening_sine)) return std::nullopt;
    const double triple =
        (model.a_flipped ? -1.0 : 1.0) * model.fixed.sin_lambda_sin_mu * opening_sine;
    return Eigen::Vector2d{axis_rate.dot(at.b), -axis_rate.dot(model.a)} / triple;
  }
  const Vec3 sweep = model.rotary_count == 1 ? Vec3{model.a.cross(at.axis)} : Vec3{Vec3::Zero()};
  const double first =
      sweep.isZero(smallest_opening_sine) ? 0.0 : axis_rate.dot(sweep) / sweep.squaredNorm();
  if (!((axis_rate - first * sweep).norm() <= follow_ratio * axis_rate.norm())) return std::nullopt;
  return Eigen::Vector2d{first, 0.0};
}

}  // namespace

Jacobian jacobian(const Model& model, const Joints& joints, double gauge_length_mm) {
  const Posture at = posture(model, joints, gauge_length_mm);
  Jacobian matrix = Jacobian::Zero();
  matrix.topLeftCorner<3, 3>() = at.linear;
  if (model.rotary_count >= 1) {
    matrix.block<3, 1>(0, 3) = at.tip_first_mm;
    matrix.block<3, 1>(3, 3) = model.a.cross(at.axis);
  }
  if (model.rotary_count >= 2) {
    matrix.block<3, 1>(0, 4) = at.tip_second_mm;
    matrix.block<3, 1>(3, 4) = at.b.cross(at.axis);
  }
  return matrix;
}

std::optional<JointRates> joint_rates(const Model& model, const Joints& joints,
                                      double gauge_length_mm, const Vec3& tip_rate_mm,
                                      const Vec3& axis_rate) {
  const Posture at = posture(model, joints, gauge_length_mm);
  const auto rotary = rotary_rates(model, at, joints.second_rad, axis_rate);
  if (!rotary) return std::nullopt;
  const Vec3 carried = rotary->x() * at.tip_first_mm + rotary->y() * at.tip_second_mm;
  const auto linear = solve_linear(model, at.linear, tip_rate_mm - carried);
  if (!linear) return std::nullopt;
  return JointRates{*linear, rotary->x(), rotary->y()};
}

}  // namespace pentapost::kinematics
