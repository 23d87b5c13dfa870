#include "pentapost/analysis/demand.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::analysis {
namespace {

/// A feed that was lowered to a limit is not over it.
constexpr double rounding = 1e-9;

}  // namespace

PerAxis per_axis(const kinematics::Joints& joints) {
  const Vec3& linear = joints.linear_mm;
  return {linear.x(), linear.y(), linear.z(), joints.first_rad, joints.second_rad};
}

PerAxis per_axis(const kinematics::JointRates& rates) {
  const Vec3& linear = rates.linear_mm;
  return {linear.x(), linear.y(), linear.z(), rates.first_rad, rates.second_rad};
}

kinematics::JointRates joint_rates(const PerAxis& rates) {
  return {{rates[0], rates[1], rates[2]}, rates[first_axis], rates[second_axis]};
}

double amplification(const kinematics::Model& model, std::size_t axis, double opening_sine,
                     const Vec3& tool_axis) {
  if (model.rotary_count < 2) return 1.0;
  if (axis == first_axis) return 1.0 / opening_sine;
  // Nearer to a pole rounding decides both sines.
  constexpr double smallest_sine = 1e-9;
  const double sin_gamma = model.a.cross(tool_axis).norm();
  if (sin_gamma <= smallest_sine) return 1.0;
  return std::max(1.0, sin_gamma / (std::sin(model.lambda_rad) * opening_sine));
}

std::optional<PerAxis> rates_of(const kinematics::JointMotion& motion, const Vec3& tip_rate_mm,
                                double first_rad, double second_rad) {
  const auto linear = motion.linear_rates_mm(tip_rate_mm, first_rad, second_rad);
  if (!linear) return std::nullopt;
  return PerAxis{linear->x(), linear->y(), linear->z(), first_rad, second_rad};
}

double Load::largest() const {
  double largest = 0.0;
  for (const double each : ratio) largest = std::max(largest, each);
  return largest;
}

bool Load::is_singular(double share) const {
  for (std::size_t i = 0; i < axis_count; ++i)
    if (is_singular(i, share)) return true;
  return false;
}

bool Load::is_plainly_over(double share) const {
  for (std::size_t i = 0; i < axis_count; ++i)
    if (is_plainly_over(i, share)) return true;
  return false;
}

Allowance::Allowance(const SpeedLimits& limits, double allowed_share)
    : share{allowed_share * (1.0 + rounding)} {
  for (std::size_t i = 0; i < axis_count; ++i)
    if (limits[i]) time_per_way_s[i] = 1.0 / *limits[i];
}

PerAxis ratios_of(const PerAxis& rate, double time_s, const Allowance& allowance) {
  const double moves_per_s = 1.0 / time_s;
  PerAxis ratios{};
  for (std::size_t i = 0; i < axis_count; ++i)
    ratios[i] = std::abs(rate[i]) * moves_per_s * allowance.time_per_way_s[i];
  return ratios;
}

}  // namespace pentapost::analysis
