#pragma once

#include "pentapost/analysis/demand.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace pentapost::analysis {

/// One place of a stretch.
struct Place {
  double fraction = 0.0;
  Demand demand;
  Load load;
  /// Per unit of the fraction squared, at an even feed; only where it was asked for, and the joints
  /// have accelerations.
  std::optional<PerAxis> acceleration = {};
};

/// Places of one stretch, whose turning_places() are in order, so dense that between neighbours no
/// rate leaves the line between them by more than 0.1 percent of itself, and that no place between
/// them changes sides of the allowance.
template <class Stretch>
class Grid {
 public:
  /// @param time_s  of a unit of the fraction at the programmed feed.
  Grid(const Stretch& stretch, double time_s, const Allowance& allowance, bool with_accelerations)
      : stretch_{stretch},
        time_s_{time_s},
        allowance_{allowance},
        with_accelerations_{with_accelerations} {}

  /// Fills `places`, in order; empty where the stretch has no rates anywhere.
  void fill(std::vector<Place>& places) const {
    places.clear();
    places.emplace_back();
    if (!at(stretch_.from(), places.back())) return places.clear();
    for (const double fraction : stretch_.turning_places())
      if (!go_to(fraction, places)) return places.clear();
    if (!go_to(stretch_.to(), places)) places.clear();
  }

 private:
  static constexpr double largest_change = 0.03;
  static constexpr int most_levels = 24;
  /// Beyond so many places a stretch all along a singularity is divided no further than this.
  static constexpr std::size_t many_places = 20'000;
  static constexpr int few_levels = 8;
  /// From this level on a stretch is not divided whose rates are seen to run straight, twice: all
  /// along a singularity the bound of their change is far too large.
  static constexpr int straight_level = 4;
  static constexpr int crossing_levels = 40;
  /// So far inside a stretch its rates stand for those at a singularity on its end.
  static constexpr double inside_share = 1e-6;

  /// @return false where the stretch has no rates there.
  bool at(double fraction, Place& place) const {
    const double length = stretch_.to() - stretch_.from();
    const double middle = 0.5 * (stretch_.from() + stretch_.to());
    for (const double there : {fraction, fraction + inside_share * (middle - fraction),
                               fraction - inside_share * length}) {
      const auto demand = stretch_.at(there);
      if (!demand) continue;
      place.fraction = fraction;
      place.demand = *demand;
      if (there != fraction) {
        place.demand.axis = stretch_.axis(fraction);
        place.demand.tip_mm = stretch_.tip_mm(fraction);
      }
      place.load.ratio = ratios_of(demand->rate, time_s_, allowance_);
      place.load.asked_ratio = place.load.largest() > allowance_.share
                                   ? ratios_of(stretch_.asked(there, *demand), time_s_, allowance_)
                                   : PerAxis{};
      if (with_accelerations_) place.acceleration = stretch_.acceleration(there, *demand);
      return true;
    }
    return false;
  }

  /// Goes on from the last place. Most moves need none in between, and cost no copy.
  bool go_to(double fraction, std::vector<Place>& places) const {
    places.emplace_back();
    if (!at(fraction, places.back())) return false;
    const Place &from = places[places.size() - 2], &to = places.back();
    if (!is_too_far(from, to) && !has_crossing(from, to)) return true;
    const Place last = to;
    places.pop_back();
    divide(last, 0, false, places);
    return true;
  }

  bool is_too_far(const Place& from, const Place& to) const {
    return stretch_.relative_change(from.demand, to.demand, to.fraction - from.fraction) >
           largest_change;
  }

  /// Whether the rates in the middle are those half way between the ends.
  static bool are_straight(const Place& from, const Place& middle, const Place& to) {
    constexpr double straight_share = 1e-3, noise_share = 1e-6;
    const auto rate = [](const Place& place, std::size_t i) { return place.demand.rate[i]; };
    const auto scale = [&](std::size_t i) {
      return std::max({std::abs(rate(from, i)), std::abs(rate(middle, i)), std::abs(rate(to, i))});
    };
    const auto are_straight_within = [&](std::size_t begin, std::size_t end) {
      double largest = 0.0;
      for (std::size_t i = begin; i < end; ++i) largest = std::max(largest, scale(i));
      for (std::size_t i = begin; i < end; ++i)
        if (!(std::abs(rate(middle, i) - 0.5 * (rate(from, i) + rate(to, i))) <=
              straight_share * scale(i) + noise_share * largest))
          return false;
      return true;
    };
    return are_straight_within(0, first_axis) && are_straight_within(first_axis, axis_count);
  }

  /// Goes on from the last place.
  /// @param was_straight  the stretch that this is a half of.
  void divide(const Place& to, int level, bool was_straight, std::vector<Place>& places) const {
    const int levels = places.size() < many_places ? most_levels : few_levels;
    if (level < levels && is_too_far(places.back(), to)) {
      Place middle;
      if (at(0.5 * (places.back().fraction + to.fraction), middle)) {
        const bool straight = level >= straight_level && are_straight(places.back(), middle, to);
        const int next_level = straight && was_straight ? most_levels : level + 1;
        divide(middle, next_level, straight, places);
        divide(to, next_level, straight, places);
        return;
      }
    }
    const Place from = places.back();
    if (has_crossing(from, to)) add_crossings(from, to, places);
    places.push_back(to);
  }

  // What a load is on one side of: the allowance by a singularity or plainly, or the share of 1
  // that costs time.
  bool is_singular(const Load& load) const { return load.is_singular(allowance_.share); }
  bool is_plainly_over(const Load& load) const { return load.is_plainly_over(allowance_.share); }
  static bool costs_time(const Load& load) { return load.largest() > 1.0; }

  bool has_crossing(const Place& from, const Place& to) const {
    return is_singular(from.load) != is_singular(to.load) ||
           is_plainly_over(from.load) != is_plainly_over(to.load) ||
           costs_time(from.load) != costs_time(to.load);
  }

  void add_crossings(const Place& from, const Place& to, std::vector<Place>& places) const {
    const auto begin = static_cast<std::ptrdiff_t>(places.size());
    add_crossing(from, to, places, [&](const Load& load) { return is_singular(load); });
    add_crossing(from, to, places, [&](const Load& load) { return is_plainly_over(load); });
    add_crossing(from, to, places, [&](const Load& load) { return costs_time(load); });
    std::sort(places.begin() + begin, places.end(),
              [](const Place& x, const Place& y) { return x.fraction < y.fraction; });
  }

  /// Adds the last place on one side and the first on the other.
  template <class Side>
  void add_crossing(const Place& from, const Place& to, std::vector<Place>& places,
                    const Side& side) const {
    const bool at_from = side(from.load);
    if (at_from == side(to.load)) return;
    Place near = from, far = to;
    for (int i = 0; i < crossing_levels; ++i) {
      Place middle;
      if (!at(0.5 * (near.fraction + far.fraction), middle)) break;
      (side(middle.load) == at_from ? near : far) = middle;
    }
    places.push_back(near);
    places.push_back(far);
  }

  const Stretch& stretch_;
  double time_s_;
  const Allowance& allowance_;
  bool with_accelerations_;
};

}  // namespace pentapost::analysis
