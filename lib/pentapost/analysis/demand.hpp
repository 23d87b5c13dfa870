#pragma once

#include "pentapost/kinematics/joint_motion.hpp"
#include "pentapost/kinematics/model.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace pentapost::analysis {

/// Axes in the order of a Model: three linear joints (mm), the first rotary joint, the second
/// (rad).
inline constexpr std::size_t axis_count = 5;
inline constexpr std::size_t first_axis = 3, second_axis = 4;
using PerAxis = std::array<double, axis_count>;

/// What one place of a move asks of the axes. Rates per unit of the move's fraction, signed.
struct Demand {
  PerAxis rate{};
  PerAxis joints{};  ///< values of the joints: mm, rad
  /// |sin B| of the triangle: the singularity multiplies the rotary rates by its inverse. 1 where
  /// there is no triangle, 0 at a singularity.
  double opening_sine = 1.0;
  Vec3 tip_mm = Vec3::Zero();  ///< frame of the tool path
  Vec3 axis = Vec3::UnitZ();   ///< tool axis, table frame
};

/// Values of all joints in the order of the axes.
PerAxis per_axis(const kinematics::Joints& joints);
PerAxis per_axis(const kinematics::JointRates& rates);
kinematics::JointRates joint_rates(const PerAxis& rates);

/// What the singularity multiplies the rate of a rotary joint by, at a tool axis (table frame).
///
/// The first joint's is 1 / |sin B|. The second one's is sin(gamma) / (sin(lambda) |sin B|), by the
/// sine rule the inverse sine of the triangle's angle at the tool: 1 at a pole, where only the
/// first joint races, and without bound where the reach ends. At least 1; infinite at a singularity
/// of that joint; 1 without a triangle.
double amplification(const kinematics::Model& model, std::size_t axis, double opening_sine,
                     const Vec3& tool_axis);

/// Rates of all axes where the rotary joints have these.
/// @return nullopt where the linear axes do not span space.
std::optional<PerAxis> rates_of(const kinematics::JointMotion& motion, const Vec3& tip_rate_mm,
                                double first_rad, double second_rad);

/// Limits of the axes; nullopt: no source gives one, and none is held.
using SpeedLimits = std::array<std::optional<double>, axis_count>;

/// A demand against the limits, for a move that takes `time_s` at the programmed feed.
struct Load {
  PerAxis ratio{};  ///< speed over limit; 0 where there is no limit
  /// The same of what the tool's motion asks for: the rotary rates divided by their amplification,
  /// and the linear rates that go with those. 0 where no axis is over its share.
  PerAxis asked_ratio{};
  double largest() const;
  /// Whether an axis is over `share` of its limit, and would not be without the amplification.
  bool is_singular(std::size_t axis, double share) const {
    return ratio[axis] > share && asked_ratio[axis] <= share;
  }
  bool is_singular(double share) const;
  /// Whether an axis is over `share` of its limit by what the tool's motion asks for alone.
  bool is_plainly_over(std::size_t axis, double share) const { return asked_ratio[axis] > share; }
  bool is_plainly_over(double share) const;
};
/// What the load is held against.
struct Allowance {
  Allowance(const SpeedLimits& limits, double allowed_share);
  PerAxis time_per_way_s{};  ///< least, by the speed limits, per mm or rad; 0: no limit
  double share;              ///< of a limit, from which a stretch counts as a zone
};

/// Rates over limits.
PerAxis ratios_of(const PerAxis& rate, double time_s, const Allowance& allowance);

}  // namespace pentapost::analysis
