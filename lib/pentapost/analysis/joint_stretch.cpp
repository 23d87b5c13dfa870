#include "pentapost/analysis/joint_stretch.hpp"

#include "pentapost/kinematics/forward.hpp"
#include "pentapost/kinematics/singularity.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pentapost::analysis {

using kinematics::JointMotion;
using kinematics::Joints;

JointStretch::JointStretch(const kinematics::Model& model, const path::Segment* tip,
                           const Ends& ends, const Frame& frame, double resolved_turn_rad,
                           const JointMotion* at_start)
    : model_{model},
      tip_{tip},
      ends_{ends},
      change_{ends.to.linear_mm - ends.from.linear_mm, ends.to.first_rad - ends.from.first_rad,
              ends.to.second_rad - ends.from.second_rad},
      frame_{frame},
      turn_rad_{std::min(turn_rad(tip, ends), resolved_turn_rad)},
      at_start_{at_start} {}

// The part that is asked for by itself turns with |sin B| as well, hence the second joint twice.
double JointStretch::turn_rad(const path::Segment* tip, const Ends& ends) {
  return std::abs(ends.to.first_rad - ends.from.first_rad) +
         2.0 * std::abs(ends.to.second_rad - ends.from.second_rad) +
         (tip != nullptr ? tip->sweep_rad() : 0.0);
}

Joints JointStretch::joints_by_words(double fraction) const {
  if (fraction == 0.0) return ends_.from;
  if (fraction == 1.0) return ends_.to;
  return {ends_.from.linear_mm + fraction * change_.linear_mm,
          ends_.from.first_rad + fraction * change_.first_rad,
          ends_.from.second_rad + fraction * change_.second_rad};
}

const JointMotion* JointStretch::motion(double fraction) const {
  if (at_start_ != nullptr && fraction == 0.0) return at_start_;
  const bool is_end = fraction == 1.0;
  if (is_end && at_end_) return &*at_end_;
  if (inside_ && inside_fraction_ == fraction) return &*inside_;
  std::optional<JointMotion>& place = is_end ? at_end_ : inside_;
  const Joints there = joints_by_words(fraction);
  if (tip_ == nullptr) {
    place.emplace(model_, there, frame_.gauge_length_mm);
  } else {
    place.emplace(model_, there.first_rad, there.second_rad, frame_.gauge_length_mm);
    if (!place->reach(tip_->tip_mm(fraction) + frame_.origin_mm)) {
      place.reset();
      return nullptr;
    }
  }
  if (!is_end) inside_fraction_ = fraction;
  return &*place;
}

Vec3 JointStretch::tip_rate_mm(const JointMotion& motion, double fraction) const {
  if (tip_ != nullptr) return tip_->tip_rate_mm(fraction);
  Eigen::Matrix<double, 5, 1> rates;
  rates << change_.linear_mm, change_.first_rad, change_.second_rad;
  return motion.jacobian().topRows<3>() * rates;
}

std::optional<Demand> JointStretch::at(double fraction) const {
  const JointMotion* const found = motion(fraction);
  if (found == nullptr) return std::nullopt;
  Demand demand{.joints = per_axis(found->joints()),
                .opening_sine = std::abs(found->opening_sine()),
                .tip_mm = tip_mm(fraction),
                .axis = found->axis()};
  if (tip_ == nullptr) {
    demand.rate = per_axis(change_);
    return demand;
  }
  const auto rate =
      rates_of(*found, tip_->tip_rate_mm(fraction), change_.first_rad, change_.second_rad);
  if (!rate) return std::nullopt;
  demand.rate = *rate;
  return demand;
}

PerAxis JointStretch::asked(double fraction, const Demand& demand) const {
  const JointMotion* const found = motion(fraction);
  if (found == nullptr) return demand.rate;
  const auto asked_rad = [&](std::size_t axis) {
    return demand.rate[axis] / amplification(model_, axis, demand.opening_sine, demand.axis);
  };
  const auto rates = rates_of(*found, tip_rate_mm(*found, fraction), asked_rad(first_axis),
                              asked_rad(second_axis));
  return rates ? *rates : demand.rate;
}

std::optional<PerAxis> JointStretch::acceleration(double fraction, const Demand& demand) const {
  if (tip_ == nullptr) return PerAxis{};
  const JointMotion* const found = motion(fraction);
  if (found == nullptr) return std::nullopt;
  const auto linear = found->linear_accelerations_mm(tip_->tip_acceleration_mm(fraction),
                                                     joint_rates(demand.rate), 0.0, 0.0);
  return linear ? std::optional{per_axis(kinematics::JointRates{.linear_mm = *linear})}
                : std::nullopt;
}

Vec3 JointStretch::axis(double fraction) const {
  const Joints there = joints_by_words(fraction);
  return kinematics::forward_axis(model_, there.first_rad, there.second_rad);
}

Vec3 JointStretch::tip_mm(double fraction) const {
  if (tip_ != nullptr) return tip_->tip_mm(fraction);
  const Joints there = joints_by_words(fraction);
  const kinematics::Turns turn{model_, there.first_rad, there.second_rad};
  return kinematics::forward_tip_mm(model_, turn, there.linear_mm, frame_.gauge_length_mm) -
         frame_.origin_mm;
}

double JointStretch::relative_change(const Demand& from, const Demand& to, double length) const {
  if (turn_rad_ == 0.0) return 0.0;
  const auto volume = [&](const Demand& demand) {
    return kinematics::linear_volume_ratio(model_, demand.joints[first_axis],
                                           demand.joints[second_axis]);
  };
  return length * turn_rad_ / std::min(1.0, std::min(volume(from), volume(to)));
}

// The triangle opens by 0 or pi where the second joint stands at beta_zero or half a turn off it.
std::vector<double> JointStretch::turning_places() const {
  std::vector<double> places;
  if (model_.rotary_count < 2 || change_.second_rad == 0.0) return places;
  const double lower_rad = std::min(ends_.from.second_rad, ends_.to.second_rad);
  const double upper_rad = std::max(ends_.from.second_rad, ends_.to.second_rad);
  const double most_passes = turn_rad_ / pi + 1.0;
  double pass = std::ceil((lower_rad - model_.beta_zero_rad) / pi);
  for (double count = 0.0; count <= most_passes; ++count, ++pass) {
    const double second_rad = model_.beta_zero_rad + pass * pi;
    if (!(second_rad <= upper_rad)) break;
    const double place = (second_rad - ends_.from.second_rad) / change_.second_rad;
    if (place > 0.0 && place < 1.0) places.push_back(place);
  }
  if (change_.second_rad < 0.0) std::reverse(places.begin(), places.end());
  return places;
}

double JointStretch::length_mm() const {
  if (tip_ != nullptr) return tip_->length_mm();
  if (change_.first_rad == 0.0 && change_.second_rad == 0.0)
    return (tip_mm(1.0) - tip_mm(0.0)).norm();
  // Gauss-Legendre of four places on parts of so small a turn.
  constexpr double part_turn_rad = 0.4;
  constexpr std::array<double, 2> node{0.33998104358485626, 0.86113631159405258};
  constexpr std::array<double, 2> weight{0.65214515486254614, 0.34785484513745386};
  const double parts = std::ceil(std::max(1.0, turn_rad_ / part_turn_rad));
  double sum_mm = 0.0;
  for (double part = 0.0; part < parts; ++part)
    for (const double side : {-1.0, 1.0})
      for (std::size_t i = 0; i < node.size(); ++i) {
        const double fraction = (part + 0.5 + 0.5 * side * node[i]) / parts;
        const JointMotion there{model_, joints_by_words(fraction), frame_.gauge_length_mm};
        sum_mm += 0.5 / parts * weight[i] * tip_rate_mm(there, fraction).norm();
      }
  return sum_mm;
}

}  // namespace pentapost::analysis
