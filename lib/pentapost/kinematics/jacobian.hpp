#pragma once

#include "pentapost/kinematics/model.hpp"

#include <Eigen/Dense>

#include <optional>

namespace pentapost::kinematics {

/// Tool velocity in the table frame per joint velocity: rows tip x y z (mm), axis x y z; columns
/// linear joints (per mm), then first and second rotary joint (per rad).
using Jacobian = Eigen::Matrix<double, 6, 5>;
Jacobian jacobian(const Model& model, const Joints& joints, double gauge_length_mm);

/// Joint velocities that give the tool a velocity: the derivative of the inverse.
struct JointRates {
  Vec3 linear_mm = Vec3::Zero();  ///< per unit of the path parameter
  double first_rad = 0.0;
  double second_rad = 0.0;
};

/// Joint velocities for a tool velocity.
///
/// @param tip_rate_mm  velocity of the tool tip, table frame, per unit of any path parameter.
/// @param axis_rate  velocity of the tool axis, tangent to the sphere at the axis.
/// @return nullopt at a singularity (the triangle or the linear directions degenerate), or where
///         fewer than two rotary joints cannot follow the axis (to 1e-6 of its velocity).
/// Source: lib/README.md section 3, which contains Cripps et al. 2017 eq. (5) and (6).
std::optional<JointRates> joint_rates(const Model& model, const Joints& joints,
                                      double gauge_length_mm, const Vec3& tip_rate_mm,
                                      const Vec3& axis_rate);

}  // namespace pentapost::kinematics
