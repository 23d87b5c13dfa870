#pragma once

#include "pentapost/core/units.hpp"
#include "pentapost/reorient/axis_rates.hpp"

namespace pentapost::reorient {

/// The rotary axes and what they do, CL coordinates; b as the triangle is drawn.
struct AxisRates::Posture {
  double gamma_rad, cos_gamma, sin_gamma;
  double volume;  ///< of pole, tool axis and b: 0 at a singularity
  Vec3 b;
  Frame of_rotary, of_tool;  ///< pole and b; tool axis and b
  Frame of_table;
  Vec3 axis_rate;
  double first_rate, second_rate;  ///< rad/s, signed, of the axes as drawn
  Vec3 b_from_a_mm, tool_mm, tip_from_a_mm;
  Vec3 first_arm_mm, second_arm_mm;
  Vec3 linear_rate_mm_s;  ///< of the tip by the linear axes
};

/// How far a posture may be from the one given.
struct AxisRates::Freedom {
  bool may_be_reached = true;
  double smallest_volume = 0.0, largest_volume = 0.0;
  double b_rad = pi;         ///< of b
  double rotary_rad = pi;    ///< of the frame of_rotary
  double tool_rad = pi;      ///< of the frame of_tool
  double least_sin_a = 0.0;  ///< of the triangle's angle at the pole
  double largest_sin_gamma = 1.0;
};

/// The angle of a cosine that may be beyond 1 by rounding.
double angle_of_cosine_rad(double cosine);

}  // namespace pentapost::reorient
