#pragma once

#include "pentapost/kinematics/model.hpp"
#include "pentapost/kinematics/turns.hpp"

namespace pentapost::kinematics {

/// Tool tip and tool axis in the table frame for joint values.
/// @param gauge_length_mm  spindle reference to tool tip, along the tool axis.
Pose forward(const Model& model, const Joints& joints, double gauge_length_mm);

/// The tool tip alone, at rotary values whose sines are taken already.
Vec3 forward_tip_mm(const Model& model, const Turns& turn, const Vec3& linear_mm,
                    double gauge_length_mm);

/// The tool axis alone; the linear joints have no part in it.
Vec3 forward_axis(const Model& model, double first_rad, double second_rad);

/// The tool tip as an affine function of the linear joints at fixed rotary values:
/// tip = matrix * linear + offset (lib/README.md section 1).
struct LinearMap {
  Mat3 matrix;
  Vec3 offset_mm;
};
LinearMap linear_map(const Model& model, double first_rad, double second_rad,
                     double gauge_length_mm);

/// How the linear joints move when the tool goes by 1 mm along its axis, all rotary joints at zero:
/// the direction in which a control adds a tool length.
Vec3 length_direction(const Model& model);

}  // namespace pentapost::kinematics
