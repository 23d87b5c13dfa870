#include "pentapost/analysis/survey.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::analysis {

using kinematics::Singularity;

double slowing(const Place& from, const Place& to) {
  return 0.5 * (std::max(1.0, from.load.largest()) + std::max(1.0, to.load.largest()));
}

Survey::Survey(const std::vector<Singularity>& singularities, const Allowance& allowance)
    : allowance_{allowance} {
  for (const Singularity& each : singularities) watched_.push_back({.singularity = each});
}

void Survey::take(const SurveyedMove& move, const std::vector<Place>& places) {
  if (places.empty()) return interrupt();
  take_place(move, places.front());
  for (std::size_t i = 1; i < places.size(); ++i) {
    const Place &from = places[i - 1], &to = places[i];
    take_place(move, to);
    const double time_s = (to.fraction - from.fraction) * move.time_s;
    const Step step{from, to, time_s, time_s * (slowing(from, to) - 1.0)};
    predicted_time_s_ += step.time_s + step.lost_s;
    const auto both = [&](auto side) { return side(from.load) && side(to.load); };
    const double allowed = allowance_.share;
    extend(singular_, both([&](const Load& load) { return load.is_singular(allowed); }), move,
           step);
    extend(plain_, both([&](const Load& load) { return load.is_plainly_over(allowed); }), move,
           step);
  }
}

void Survey::pass(const SurveyedMove& move) {
  interrupt();
  predicted_time_s_ += move.time_s;
}

void Survey::interrupt() { singular_.is_open = plain_.is_open = false; }

void Survey::take_place(const SurveyedMove& move, const Place& place) {
  for (std::size_t i = 0; i < axis_count; ++i) {
    const double speed = std::abs(place.demand.rate[i]) / move.time_s;
    if (speed > peaks_[i].speed)
      peaks_[i] = {speed, place.load.ratio[i], place.demand.opening_sine, place.demand.axis,
                   move.place(place)};
  }
  if (place.acceleration) {
    if (!peak_accelerations_) peak_accelerations_.emplace();
    for (std::size_t i = 0; i < axis_count; ++i)
      (*peak_accelerations_)[i] =
          std::max((*peak_accelerations_)[i],
                   std::abs((*place.acceleration)[i]) / (move.time_s * move.time_s));
  }
  approach(move, place);
}

// Nearly all places are told by one product to be no nearer than the nearest so far.
void Survey::approach(const SurveyedMove& move, const Place& place) {
  constexpr double rounding = 1e-15;
  for (Watched& each : watched_) {
    const double cosine = each.singularity.centre.dot(place.demand.axis);
    if (!(cosine > each.least_cosine && cosine < each.most_cosine)) continue;
    const double distance = kinematics::distance_rad(each.singularity, place.demand.axis);
    if (each.closest && distance >= each.closest->distance_rad) continue;
    each.closest = Approach{distance, each.singularity.kind, move.place(place)};
    const double half = each.singularity.half_angle_rad;
    each.least_cosine = half + distance < pi ? std::cos(half + distance) - rounding : -2.0;
    each.most_cosine = half > distance ? std::cos(half - distance) + rounding : 2.0;
  }
}

std::vector<std::optional<Approach>> Survey::approaches() const {
  std::vector<std::optional<Approach>> approaches;
  for (const Watched& each : watched_) approaches.push_back(each.closest);
  return approaches;
}

void Survey::extend(Zones& zones, bool is_inside, const SurveyedMove& move,
                    const Step& step) const {
  if (!is_inside) {
    zones.is_open = false;
    return;
  }
  if (!zones.is_open) {
    zones.zones.emplace_back();
    zones.zones.back().from = move.place(step.from);
    zones.is_open = true;
    raise(zones, move, step.from);
  }
  Zone& zone = zones.zones.back();
  zone.to = move.place(step.to);
  zone.programmed_time_s += step.time_s;
  zone.time_lost_s += step.lost_s;
  raise(zones, move, step.to);
}

void Survey::raise(Zones& zones, const SurveyedMove& move, const Place& place) const {
  Zone& zone = zones.zones.back();
  for (std::size_t axis = 0; axis < axis_count; ++axis) {
    const double ratio = place.load.ratio[axis];
    if (!(ratio > zone.peak_ratio) || !(place.load.*zones.is_over)(axis, allowance_.share))
      continue;
    zone.axis = axis;
    zone.peak_ratio = ratio;
    zone.peak_speed = std::abs(place.demand.rate[axis]) / move.time_s;
    zone.opening_sine = place.demand.opening_sine;
    zone.tool_axis = place.demand.axis;
  }
  const double feed = move.feed_mm_min() / std::max(1.0, place.load.largest());
  if (zone.lowest_feed_mm_min == 0.0 || feed < zone.lowest_feed_mm_min)
    zone.lowest_feed_mm_min = feed;
  for (const Watched& each : watched_) {
    const double distance = kinematics::distance_rad(each.singularity, place.demand.axis);
    if (!zone.closest || distance < zone.closest->distance_rad)
      zone.closest = Approach{distance, each.singularity.kind, move.place(place)};
  }
}

}  // namespace pentapost::analysis
