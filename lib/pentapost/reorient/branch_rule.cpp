#include "pentapost/reorient/branch_rule.hpp"

#include "pentapost/path/turn.hpp"
#include "pentapost/plan/choice_costs.hpp"
#include "pentapost/plan/state_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pentapost::reorient {
namespace {

constexpr double turn_rad = 2.0 * pi;
constexpr double least_margin_rad = 1e-3;

/// It starts in the window of the preferences, or less than a turn beside it.
double reach_of_first_rad(const std::optional<Range<double>>& range,
                          const machine::Preferences& preferences) {
  if (!range) return std::numeric_limits<double>::infinity();
  const Range<double> window = plan::start_window_rad(preferences);
  return std::min(window.lower - range->lower, range->upper - window.upper) - turn_rad;
}

}  // namespace

BranchRule::BranchRule(const kinematics::Model& model, const plan::JointRanges& ranges,
                       const plan::Settings& settings, const path::ToolPath& tool_path)
    : is_there_{model.rotary_count == 2 && model.fixed.linear_place >= 0 &&
                settings.preferences.tilt && ranges.rotary_rad[1]} {
  if (!is_there_) return;
  first_reach_rad_ = reach_of_first_rad(ranges.rotary_rad[0], settings.preferences);
  wants_negative_ = settings.preferences.tilt == machine::Preferences::Tilt::negative;
  second_range_rad_ = *ranges.rotary_rad[1];
  beta_zero_rad_ = model.beta_zero_rad;
  sin_lambda_ = std::sin(model.lambda_rad);
  sin_mu_ = std::sin(model.mu_rad);
  const double freedom_rad = plan::axis_freedom_rad(settings.axis_tolerance_rad, settings.flank);
  constexpr double widths = 8.0;
  margin_rad_ = std::max(
      least_margin_rad,
      widths * plan::pole_zone(model, tool_path.axis_rounding_rad, freedom_rad).radius_rad);
  for (std::size_t i = 0; i < tool_path.size(); ++i) {
    farthest_tip_mm_ = std::max(farthest_tip_mm_, tool_path.tip_wp_mm[i].norm());
    if (i == 0) continue;
    turn_rad_ += angle_between_rad(tool_path.axis_wp[i - 1], tool_path.axis_wp[i]);
    way_mm_ += (tool_path.tip_wp_mm[i] - tool_path.tip_wp_mm[i - 1]).norm();
  }
  place_ = model.fixed.linear_place;
  b_from_a_mm_ = (model.b_point_mm - model.a_point_mm).norm();
  double longest_mm = 0.0;
  for (const auto& [number, gauge_mm] : settings.gauge_length_mm)
    longest_mm = std::max(longest_mm, std::abs(gauge_mm));
  tool_mm_ = model.b_point_mm.norm() + longest_mm;
  const plan::OrderingSpeeds speeds = plan::ordering_speeds(model, settings);
  first_s_per_rad_ = 1.0 / speeds.rotary_rad_s[0];
  linear_s_per_mm_ = model.fixed.linear_inverse.norm() / speeds.linear_mm_s.minCoeff();
}

std::optional<int> BranchRule::settled(const AxisRates& rates, const Range<double>& gamma_rad,
                                       double origin_mm) const {
  if (!is_there_ || rates.has_singularity_between(gamma_rad) ||
      !(rates.singularity_distance_rad(gamma_rad.lower) > margin_rad_) ||
      !(rates.singularity_distance_rad(gamma_rad.upper) > margin_rad_))
    return std::nullopt;
  const auto least = rates.opening_rad(gamma_rad.lower), most = rates.opening_rad(gamma_rad.upper);
  if (!least || !most) return std::nullopt;
  const auto branch = of_tilt({*least, *most});
  return branch && is_settled_by_cost(gamma_rad, {*least, *most}, origin_mm) ? branch
                                                                             : std::nullopt;
}

/// The one branch that is of the right tilt and within range at all of these openings, where the
/// other is nowhere both.
std::optional<int> BranchRule::of_tilt(const Range<double>& opening_rad) const {
  constexpr double sure_rad = 1e-9;
  constexpr double most_turns = 4.0;
  std::optional<int> found;
  for (const int branch : {0, 1}) {
    const double lower = beta_zero_rad_ + (branch == 0 ? opening_rad.lower : -opening_rad.upper);
    const double upper = beta_zero_rad_ + (branch == 0 ? opening_rad.upper : -opening_rad.lower);
    const double first = std::ceil((second_range_rad_.lower - sure_rad - upper) / turn_rad);
    const double last = std::floor((second_range_rad_.upper + sure_rad - lower) / turn_rad);
    if (last - first > most_turns) return std::nullopt;
    for (double turns = first; turns <= last; ++turns) {
      const double low = lower + turn_rad * turns, high = upper + turn_rad * turns;
      if (wants_negative_ ? low > sure_rad : high < -sure_rad) continue;
      const bool is_right = wants_negative_ ? high < -sure_rad : low > sure_rad;
      const bool is_within =
          low >= second_range_rad_.lower + sure_rad && high <= second_range_rad_.upper - sure_rad;
      if (!is_right || !is_within || found) return std::nullopt;
      found = branch;
    }
  }
  return found;
}

/// By what a path costs at most beside the second axis, which both branches turn alike: all turns
/// of the tool axis at the rates that they have nearest to a singularity.
bool BranchRule::is_settled_by_cost(const Range<double>& gamma_rad,
                                    const Range<double>& opening_rad, double origin_mm) const {
  const double least_volume =
      sin_lambda_ * sin_mu_ * std::min(std::sin(opening_rad.lower), std::sin(opening_rad.upper));
  const double least_sin_gamma = std::min(std::sin(gamma_rad.lower), std::sin(gamma_rad.upper));
  // Between two points an azimuth changes by at most 2 asin( sin(turn / 2) / sin(gamma) ).
  const double first_rad = turn_rad_ * (0.5 * pi / least_sin_gamma + sin_mu_ / least_volume);
  const double second_rad = turn_rad_ / least_volume;
  const double tip_mm = farthest_tip_mm_ + origin_mm;
  const double first_arm_mm = place_ > 0 ? tip_mm : b_from_a_mm_ + tool_mm_;
  const double second_arm_mm = place_ > 1 ? tip_mm + b_from_a_mm_ : tool_mm_;
  const double rest_s =
      first_rad * first_s_per_rad_ +
      (way_mm_ + first_rad * first_arm_mm + second_rad * second_arm_mm) * linear_s_per_mm_;
  // A start outside the window of the first axis costs no more than a turn of it.
  constexpr double most_s = 0.99 * (plan::wrong_tilt_s - plan::outside_window_s);
  return first_rad < first_reach_rad_ && rest_s < most_s;
}

}  // namespace pentapost::reorient
