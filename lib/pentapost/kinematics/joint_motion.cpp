#include "pentapost/kinematics/joint_motion.hpp"

#include "pentapost/kinematics/turns.hpp"

#include <cmath>

namespace pentapost::kinematics {
namespace {

/// Sine of the opening below which rounding decides the rates.
constexpr double smallest_opening_sine = 1e-12;
/// Share of an axis velocity that one rotary joint, or none, may fail to follow.
constexpr double follow_ratio = 1e-6;

/// Share of the volume at zero below which the linear directions have lost rank.
constexpr double smallest_volume_ratio = 1e-6;
/// Volume of unit directions above which they are far from dependent.
constexpr double plain_volume = 0.5;

/// The columns of `matrix` turned.
template <class Turn>
Mat3 turned(const Mat3& matrix, const Turn& turn) {
  Mat3 result;
  for (Eigen::Index i = 0; i < 3; ++i) result.col(i) = turn(Vec3{matrix.col(i)});
  return result;
}

}  // namespace

JointMotion::JointMotion(const Model& model, double first_rad, double second_rad,
                         double gauge_length_mm)
    : model_{&model},
      joints_{.first_rad = first_rad, .second_rad = second_rad},
      linear_{model.linear_columns[0]} {
  const Turns turn{model, first_rad, second_rad};
  const auto turn_first = [&](const Vec3& vector) { return turn.first(vector); };
  const auto turn_both = [&](const Vec3& vector) { return turn.first(turn.second(vector)); };
  if (model.fixed.linear_place == 1) {
    linear_ = turned(model.linear_columns[1], turn_first);
  } else if (model.fixed.linear_place == 2) {
    linear_ = turned(model.linear_columns[2], turn_both);
  } else if (model.fixed.linear_place < 0) {
    between_ = turned(model.linear_columns[1], turn_first);
    beyond_ = turned(model.linear_columns[2], turn_both);
    linear_ += between_ + beyond_;
  }
  const Vec3 x = linear_.col(0), y = linear_.col(1), z = linear_.col(2);
  solution_.row(0) = y.cross(z);
  solution_.row(1) = z.cross(x);
  solution_.row(2) = x.cross(y);
  volume_ = solution_.row(0).dot(x);
  b_ = turn.first(model.b);
  axis_ = turn.tool_axis();
  b_from_a_mm_ = turn.first(model.b_point_mm - model.a_point_mm);
  tool_from_b_mm_ = turn.first(turn.second(-model.b_point_mm - gauge_length_mm * model.t));
  // By the angle itself: a product of vectors would lose its digits near the pole.
  if (model.rotary_count == 2) opening_sine_ = std::sin(second_rad - model.beta_zero_rad);
}

JointMotion::JointMotion(const Model& model, const Joints& joints, double gauge_length_mm)
    : JointMotion{model, joints.first_rad, joints.second_rad, gauge_length_mm} {
  place_linear_mm(joints.linear_mm);
}

bool JointMotion::reach(const Vec3& tip_mm) {
  const auto linear_mm =
      solve_linear_mm(tip_mm - model_->a_point_mm - b_from_a_mm_ - tool_from_b_mm_);
  if (linear_mm) place_linear_mm(*linear_mm);
  return linear_mm.has_value();
}

void JointMotion::place_linear_mm(const Vec3& linear_mm) {
  joints_.linear_mm = linear_mm;
  second_arm_mm_ = tool_from_b_mm_;
  if (model_->has_linear[2]) second_arm_mm_ += beyond() * linear_mm;
  first_arm_mm_ = b_from_a_mm_ + second_arm_mm_;
  if (model_->has_linear[1]) first_arm_mm_ += between() * linear_mm;
}

std::optional<Vec3> JointMotion::solve_linear_mm(const Vec3& target_mm) const {
  if (!(std::abs(volume_) >= smallest_volume_ratio * std::abs(model_->fixed.linear_volume)))
    return std::nullopt;
  const Vec3 found = solution_ * target_mm / volume_;
  if (std::abs(volume_) >= plain_volume) return found;
  // A second pass takes out what the first leaves where the directions are nearly dependent.
  return found + Vec3{solution_ * (target_mm - linear_ * found) / volume_};
}

Jacobian JointMotion::jacobian() const {
  Jacobian matrix = Jacobian::Zero();
  matrix.topLeftCorner<3, 3>() = linear_;
  if (model_->rotary_count >= 1) {
    matrix.block<3, 1>(0, 3) = model_->a.cross(first_arm_mm_);
    matrix.block<3, 1>(3, 3) = model_->a.cross(axis_);
  }
  if (model_->rotary_count >= 2) {
    matrix.block<3, 1>(0, 4) = b_.cross(second_arm_mm_);
    matrix.block<3, 1>(3, 4) = b_.cross(axis_);
  }
  return matrix;
}

std::optional<Eigen::Vector2d> JointMotion::rotary_rates(const Vec3& axis_rate) const {
  if (model_->rotary_count == 2) {
    if (!(std::abs(opening_sine_) >= smallest_opening_sine)) return std::nullopt;
    const double triple =
        (model_->a_flipped ? -1.0 : 1.0) * model_->fixed.sin_lambda_sin_mu * opening_sine_;
    return Eigen::Vector2d{axis_rate.dot(b_), -axis_rate.dot(model_->a)} / triple;
  }
  const Vec3 sweep = model_->rotary_count == 1 ? Vec3{model_->a.cross(axis_)} : Vec3{Vec3::Zero()};
  const double first =
      sweep.isZero(smallest_opening_sine) ? 0.0 : axis_rate.dot(sweep) / sweep.squaredNorm();
  if (!((axis_rate - first * sweep).norm() <= follow_ratio * axis_rate.norm())) return std::nullopt;
  return Eigen::Vector2d{first, 0.0};
}

std::optional<Vec3> JointMotion::linear_rates_mm(const Vec3& tip_rate_mm, double first_rad,
                                                 double second_rad) const {
  const Vec3 carried =
      first_rad * model_->a.cross(first_arm_mm_) + second_rad * b_.cross(second_arm_mm_);
  return solve_linear_mm(tip_rate_mm - carried);
}

std::optional<JointRates> JointMotion::rates(const ToolRates& tool) const {
  const auto rotary = rotary_rates(tool.axis);
  if (!rotary) return std::nullopt;
  const auto linear = linear_rates_mm(tool.tip_mm, rotary->x(), rotary->y());
  if (!linear) return std::nullopt;
  return JointRates{*linear, rotary->x(), rotary->y()};
}

// Differentiating
//   o' = alpha' a x o + beta' b x o,    tip' = M l' + alpha' a x A + beta' b x B
// once more, with b' = alpha' a x b, leaves the same matrix for the second derivatives.
std::optional<JointRates> JointMotion::accelerations(const ToolRates& tool, const Vec3& axis_rate,
                                                     const JointRates& rates) const {
  const Vec3& a = model_->a;
  const double alpha = rates.first_rad, beta = rates.second_rad;
  const Vec3 axis_rest =
      alpha * a.cross(axis_rate) + beta * (alpha * a.cross(b_).cross(axis_) + b_.cross(axis_rate));
  // The part along the tool axis is the sphere's own; without two joints it must not count.
  Vec3 axis_left = tool.axis - axis_rest;
  axis_left -= axis_left.dot(axis_) * axis_;
  const auto rotary = rotary_rates(axis_left);
  if (!rotary) return std::nullopt;
  const auto linear = linear_accelerations_mm(tool.tip_mm, rates, rotary->x(), rotary->y());
  if (!linear) return std::nullopt;
  return JointRates{*linear, rotary->x(), rotary->y()};
}

std::optional<Vec3> JointMotion::linear_accelerations_mm(const Vec3& tip_acceleration_mm,
                                                         const JointRates& rates, double first_rad,
                                                         double second_rad) const {
  const Vec3& a = model_->a;
  const double alpha = rates.first_rad, beta = rates.second_rad;
  const Vec3 b_rate = alpha * a.cross(b_);
  Vec3 between_way = Vec3::Zero(), beyond_way = Vec3::Zero();
  if (model_->has_linear[1]) between_way = between() * rates.linear_mm;
  if (model_->has_linear[2]) beyond_way = beyond() * rates.linear_mm;
  const Vec3 second_arm_rate =
      alpha * a.cross(second_arm_mm_) + beta * b_.cross(second_arm_mm_) + beyond_way;
  const Vec3 first_arm_rate =
      alpha * a.cross(first_arm_mm_) + beta * b_.cross(second_arm_mm_) + between_way + beyond_way;
  const Vec3 tip_rest = alpha * a.cross(between_way + beyond_way) + beta * b_.cross(beyond_way) +
                        alpha * a.cross(first_arm_rate) + beta * b_rate.cross(second_arm_mm_) +
                        beta * b_.cross(second_arm_rate);
  return linear_rates_mm(tip_acceleration_mm - tip_rest, first_rad, second_rad);
}

}  // namespace pentapost::kinematics
