#pragma once

#include "pentapost/core/units.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/plan/branches.hpp"

#include <cmath>
#include <cstddef>

namespace pentapost::reorient {

/// How the workpiece lies on the table, as the tool path sees it.
struct Clamping {
  Mat3 to_table = Mat3::Identity();  ///< CL coordinates to the table's orientation
  Vec3 pole = Vec3::UnitZ();  ///< first rotary axis, as the triangle is drawn, CL coordinates
  Vec3 origin_from_a_mm = Vec3::Zero();  ///< CL origin from the first rotary axis, CL coordinates
};

/// @param to_table  see path::setup_turn().
/// @param origin_mm  CL origin in the table frame.
inline Clamping clamping_of(const kinematics::Model& model, const Mat3& to_table,
                            const Vec3& origin_mm) {
  return {to_table, to_table.transpose() * model.fixed.a_drawn,
          to_table.transpose() * (origin_mm - model.a_point_mm)};
}

/// Whether (theta_x, theta_z) and (-theta_x, theta_z + 180 deg) are one setup: the same but for
/// half a turn about an endless first rotary axis, with the CL origin on it.
inline bool has_twins(const kinematics::Model& model, const plan::JointRanges& ranges,
                      const Vec3& origin_mm) {
  constexpr double parallel_sine = 1e-12, same_place_mm = 1e-9;
  // A linear axis next to the workpiece is not turned with it: half a turn leaves the magnitude of
  // its speed only where it runs along or across the axis, and across it mirrors its range.
  const auto keeps_speed = [&](Eigen::Index joint) {
    const Vec3 direction = model.linear_columns[0].col(joint);
    if (model.a.cross(direction).norm() < parallel_sine) return true;
    return std::abs(model.a.dot(direction)) < parallel_sine &&
           !ranges.linear_mm[static_cast<std::size_t>(joint)];
  };
  return model.rotary_count == 2 && !ranges.rotary_rad[0] &&
         model.a.cross(Vec3::UnitZ()).norm() < parallel_sine &&
         model.a.cross(origin_mm - model.a_point_mm).norm() < same_place_mm && keeps_speed(0) &&
         keeps_speed(1) && keeps_speed(2);
}

}  // namespace pentapost::reorient
