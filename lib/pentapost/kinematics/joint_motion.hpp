#pragma once

#include "pentapost/kinematics/model.hpp"

#include <Eigen/Dense>

#include <optional>

namespace pentapost::kinematics {

/// Tool velocity in the table frame per joint velocity: rows tip x y z (mm), axis x y z; columns
/// linear joints (per mm), then first and second rotary joint (per rad).
using Jacobian = Eigen::Matrix<double, 6, 5>;

/// Derivatives of the joints by the path parameter, of first or second order.
struct JointRates {
  Vec3 linear_mm = Vec3::Zero();
  double first_rad = 0.0;
  double second_rad = 0.0;
};

/// Derivatives of the tool's way by the path parameter, table frame.
struct ToolRates {
  Vec3 tip_mm = Vec3::Zero();
  Vec3 axis = Vec3::Zero();  ///< first order: tangent to the sphere at the tool axis
};

/// Directions and levers of all joints in one posture, from which the rates and accelerations of
/// the joints follow. Table frame. Refers to the model.
/// Source: lib/README.md section 3, which contains Cripps et al. 2017 eq. (5) and (6).
class JointMotion {
 public:
  JointMotion(const Model& model, const Joints& joints, double gauge_length_mm);
  /// The linear joints are still to be placed.
  JointMotion(const Model& model, double first_rad, double second_rad, double gauge_length_mm);
  /// Places the linear joints so that they bring the tip there.
  /// @return false where the linear directions do not span space.
  bool reach(const Vec3& tip_mm);

  Jacobian jacobian() const;

  /// The derivative of the inverse: joint rates for tool rates.
  /// @return nullopt at a singularity (the triangle or the linear directions degenerate), or where
  ///         fewer than two rotary joints cannot follow the axis (to 1e-6 of its velocity).
  std::optional<JointRates> rates(const ToolRates& tool) const;

  /// Rates of the linear joints for tip rates while the rotary joints have theirs.
  std::optional<Vec3> linear_rates_mm(const Vec3& tip_rate_mm, double first_rad,
                                      double second_rad) const;

  /// The second derivative of the inverse.
  /// @param tool  second derivatives of the tool's way.
  /// @param axis_rate  first derivative of the tool axis; `rates` are the joints'.
  /// @return nullopt as rates().
  std::optional<JointRates> accelerations(const ToolRates& tool, const Vec3& axis_rate,
                                          const JointRates& rates) const;

  /// Accelerations of the linear joints for a tip acceleration, while the rotary joints have these
  /// accelerations; `rates` are the joints'.
  std::optional<Vec3> linear_accelerations_mm(const Vec3& tip_acceleration_mm,
                                              const JointRates& rates, double first_rad,
                                              double second_rad) const;

  const Joints& joints() const { return joints_; }
  const Vec3& axis() const { return axis_; }
  /// Sine of the triangle's angle at b, signed: 0 at a singularity. 1 where there is no triangle.
  double opening_sine() const { return opening_sine_; }

 private:
  void place_linear_mm(const Vec3& linear_mm);
  std::optional<Vec3> solve_linear_mm(const Vec3& target_mm) const;
  std::optional<Eigen::Vector2d> rotary_rates(const Vec3& axis_rate) const;

  const Model* model_;
  Joints joints_;
  /// Of linear_ that which stands between the rotary joints, and beyond both; used only where the
  /// model has any.
  const Mat3& between() const { return model_->fixed.linear_place == 1 ? linear_ : between_; }
  const Mat3& beyond() const { return model_->fixed.linear_place == 2 ? linear_ : beyond_; }

  Mat3 linear_;            ///< tip per linear joint
  Mat3 between_, beyond_;  ///< set where the linear joints stand in several places
  Mat3 solution_;          ///< inverse of linear_ but for the volume
  double volume_;          ///< determinant of linear_
  Vec3 b_, axis_;
  Vec3 b_from_a_mm_, tool_from_b_mm_;  ///< with the linear joints at zero
  Vec3 first_arm_mm_, second_arm_mm_;  ///< from the rotary axes to the tip
  double opening_sine_ = 1.0;
};

}  // namespace pentapost::kinematics
