#include "pentapost/analysis/demand.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::analysis {

std::optional<Demand> demand_of(const kinematics::JointMotion& motion, const Vec3& tip_rate_mm,
                                double first_rad, double second_rad) {
  const auto linear = motion.linear_rates_mm(tip_rate_mm, first_rad, second_rad);
  if (!linear) return std::nullopt;
  const double sine = std::abs(motion.opening_sine());
  const double asked_first = sine * first_rad, asked_second = sine * second_rad;
  const auto asked = motion.linear_rates_mm(tip_rate_mm, asked_first, asked_second);
  if (!asked) return std::nullopt;
  return Demand{.rate = {linear->x(), linear->y(), linear->z(), first_rad, second_rad},
                .asked = {asked->x(), asked->y(), asked->z(), asked_first, asked_second},
                .opening_sine = sine,
                .axis = motion.axis()};
}

double Load::largest() const { return *std::max_element(ratio.begin(), ratio.end()); }

std::size_t Load::largest_axis() const {
  return static_cast<std::size_t>(std::max_element(ratio.begin(), ratio.end()) - ratio.begin());
}

bool Load::is_singular(double share) const {
  for (std::size_t i = 0; i < axis_count; ++i)
    if (ratio[i] > share && asked_ratio[i] <= share) return true;
  return false;
}

bool Load::is_plainly_over(double share) const {
  return std::any_of(asked_ratio.begin(), asked_ratio.end(),
                     [share](double each) { return each > share; });
}

Load load_of(const Demand& demand, double time_s, const SpeedLimits& limits) {
  Load load;
  for (std::size_t i = 0; i < axis_count; ++i) {
    if (!limits[i]) continue;
    load.ratio[i] = std::abs(demand.rate[i]) / (time_s * *limits[i]);
    load.asked_ratio[i] = std::abs(demand.asked[i]) / (time_s * *limits[i]);
  }
  return load;
}

}  // namespace pentapost::analysis
