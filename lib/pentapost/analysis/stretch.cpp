#include "pentapost/analysis/stretch.hpp"

#include "pentapost/kinematics/inverse.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::analysis {

using kinematics::JointMotion;

namespace {

double nearest_turn(double value_rad, double reference_rad) {
  constexpr double turn_rad = 2.0 * pi;
  return value_rad + turn_rad * std::round((reference_rad - value_rad) / turn_rad);
}

}  // namespace

ClStretch::ClStretch(const kinematics::Model& model, const path::Segment& segment, Follows follows,
                     int branch, const Ends& ends, double gauge_length_mm, const Vec3& origin_mm,
                     double slack_rad, std::optional<JointMotion>& at_end,
                     const JointMotion* at_start)
    : model_{model},
      segment_{segment},
      follows_{follows},
      branch_{branch},
      ends_{ends},
      gauge_length_mm_{gauge_length_mm},
      origin_mm_{origin_mm},
      slack_rad_{slack_rad},
      at_end_{at_end},
      at_start_{at_start} {
  at_end_.reset();
  if (rests_on_singularity()) follows_ = Follows::even;
}

// The reach may end on a great circle, and any tool axis may stand still on its end: there is no
// inverse to follow, and the second joint rests.
bool ClStretch::rests_on_singularity() const {
  constexpr double smallest_opening_sine = 1e-12;
  const auto is_singular = [&](double second_rad) {
    return std::abs(std::sin(second_rad - model_.beta_zero_rad)) < smallest_opening_sine;
  };
  if (follows_ == Follows::even || model_.rotary_count != 2 ||
      ends_.second_from_rad != ends_.second_to_rad || !is_singular(ends_.second_from_rad))
    return false;
  const auto middle = rotary(0.5 * (ends_.fraction_from + ends_.fraction_to));
  return !middle || is_singular(middle->second_rad);
}

std::optional<ClStretch::Rotary> ClStretch::rotary(double fraction) const {
  if (fraction == ends_.fraction_from) return Rotary{ends_.first_from_rad, ends_.second_from_rad};
  if (fraction == ends_.fraction_to) return Rotary{ends_.first_to_rad, ends_.second_to_rad};
  if (follows_ == Follows::even)
    return Rotary{
        ends_.first_from_rad + (fraction - ends_.fraction_from) * even_rates().first_rad,
        ends_.second_from_rad + (fraction - ends_.fraction_from) * even_rates().second_rad};
  const auto found = kinematics::inverse_rotary(model_, segment_.axis(fraction), slack_rad_);
  if (found.count == 0) return std::nullopt;
  const auto& solution = found.branch[static_cast<std::size_t>(branch_)];
  return Rotary{
      nearest_turn(solution.first_rad, 0.5 * (ends_.first_from_rad + ends_.first_to_rad)),
      nearest_turn(solution.second_rad, 0.5 * (ends_.second_from_rad + ends_.second_to_rad))};
}

ClStretch::Rotary ClStretch::even_rates() const {
  const double length = ends_.fraction_to - ends_.fraction_from;
  return {(ends_.first_to_rad - ends_.first_from_rad) / length,
          (ends_.second_to_rad - ends_.second_from_rad) / length};
}

const JointMotion* ClStretch::motion(double fraction) const {
  if (at_start_ != nullptr && fraction == ends_.fraction_from) return at_start_;
  const bool is_end = fraction == ends_.fraction_to;
  if (is_end && at_end_) return &*at_end_;
  if (inside_ && inside_fraction_ == fraction) return &*inside_;
  const auto at = rotary(fraction);
  if (!at) return nullptr;
  auto& place = is_end ? at_end_ : inside_;
  place.emplace(model_, at->first_rad, at->second_rad, gauge_length_mm_);
  if (!place->reach(segment_.tip_mm(fraction) + origin_mm_)) {
    place.reset();
    return nullptr;
  }
  if (!is_end) inside_fraction_ = fraction;
  return &*place;
}

std::optional<Demand> ClStretch::at(double fraction) const {
  const JointMotion* const found = motion(fraction);
  if (found == nullptr) return std::nullopt;
  const JointMotion& motion = *found;
  Demand demand{.joints = per_axis(motion.joints()),
                .opening_sine = std::abs(motion.opening_sine()),
                .tip_mm = segment_.tip_mm(fraction),
                .axis = motion.axis()};
  const Vec3 tip_rate_mm = segment_.tip_rate_mm(fraction);
  if (follows_ == Follows::even) {
    const auto rate =
        rates_of(motion, tip_rate_mm, even_rates().first_rad, even_rates().second_rad);
    if (!rate) return std::nullopt;
    demand.rate = *rate;
    return demand;
  }
  // Nearer to a singularity the last digits of the first joint would be taken for its speed.
  constexpr double smallest_opening_sine = 1e-8;
  const Vec3 axis_rate = segment_.axis_rate(fraction);
  if (demand.opening_sine < smallest_opening_sine && !axis_rate.isZero(0.0)) return std::nullopt;
  const auto rates = motion.rates({tip_rate_mm, axis_rate});
  if (!rates) return std::nullopt;
  demand.rate = per_axis(*rates);
  return demand;
}

std::optional<PerAxis> ClStretch::acceleration(double fraction, const Demand& demand) const {
  const JointMotion* const found = motion(fraction);
  if (found == nullptr) return std::nullopt;
  const kinematics::JointRates rates = joint_rates(demand.rate);
  const Vec3 tip_mm = segment_.tip_acceleration_mm(fraction);
  if (follows_ == Follows::even) {
    const auto linear = found->linear_accelerations_mm(tip_mm, rates, 0.0, 0.0);
    return linear ? std::optional{per_axis(kinematics::JointRates{.linear_mm = *linear})}
                  : std::nullopt;
  }
  const auto accelerations = found->accelerations({tip_mm, segment_.axis_acceleration(fraction)},
                                                  segment_.axis_rate(fraction), rates);
  return accelerations ? std::optional{per_axis(*accelerations)} : std::nullopt;
}

PerAxis ClStretch::asked(double fraction, const Demand& demand) const {
  const JointMotion* const found = motion(fraction);
  if (found == nullptr) return demand.rate;
  const auto asked_rad = [&](std::size_t axis) {
    return demand.rate[axis] / amplification(model_, axis, demand.opening_sine, demand.axis);
  };
  const auto rates = rates_of(*found, segment_.tip_rate_mm(fraction), asked_rad(first_axis),
                              asked_rad(second_axis));
  return rates ? *rates : demand.rate;
}

double ClStretch::relative_change(const Demand& from, const Demand& to, double length) const {
  if (follows_ == Follows::even)
    return length * (std::abs(from.rate[first_axis]) + std::abs(from.rate[second_axis]));
  const double sweep_rad = length * segment_.sweep_rad();
  const double turn_rad = length * segment_.axis_angle_rad();
  if (turn_rad == 0.0) return sweep_rad;
  return sweep_rad + turn_rad / std::min(from.opening_sine, to.opening_sine);
}

// On the great circle cos(gamma) = c.o0 cos(x) + c.u sin(x) has its ends at x and x + pi.
std::vector<double> ClStretch::turning_places() const {
  std::vector<double> places;
  const double turn = segment_.axis_angle_rad();
  if (follows_ == Follows::even || turn == 0.0 || model_.rotary_count < 2) return places;
  // Of less than half a turn, one whose ends are approached in the same sense has none.
  const Vec3 normal = segment_.axis_from().cross(segment_.axis_to());
  const bool comes_nearer = model_.a.dot(normal.cross(segment_.axis_from())) > 0.0;
  if (comes_nearer == (model_.a.dot(normal.cross(segment_.axis_to())) > 0.0)) return places;
  const Vec3 along = segment_.axis_rate(0.0) / turn;
  const double nearest = std::atan2(model_.a.dot(along), model_.a.dot(segment_.axis_from()));
  for (const double angle : {nearest, nearest + pi, nearest - pi})
    if (const double place = angle / turn; place > ends_.fraction_from && place < ends_.fraction_to)
      places.push_back(place);
  return places;
}

}  // namespace pentapost::analysis
