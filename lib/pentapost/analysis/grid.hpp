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

/// What the load is held against.
struct Allowance {
  SpeedLimits limits;
  double share = 1.0;  ///< of a limit, from which a stretch counts as a zone
};

/// Places of one stretch, so dense that between neighbours no rate leaves the line between them by
/// more than 0.1 percent of itself, and that no place between them changes sides of the allowance.
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
    std::vector<double> stops{stretch_.from()};
    for (const double place : stretch_.turning_places()) stops.push_back(place);
    stops.push_back(stretch_.to());
    std::sort(stops.begin(), stops.end());
    std::optional<Place> last = at(stops.front());
    if (!last) return;
    places.push_back(*last);
    for (std::size_t i = 1; i < stops.size(); ++i) {
      const std::optional<Place> next = at(stops[i]);
      if (!next) return places.clear();
      divide(*last, *next, 0, places);
      last = next;
    }
  }

 private:
  static constexpr double largest_change = 0.03;
  static constexpr int most_levels = 24;
  static constexpr int crossing_levels = 40;
  /// So far inside a stretch its rates stand for those at a singularity on its end.
  static constexpr double inside_share = 1e-6;

  std::optional<Place> at(double fraction) const {
    const double length = stretch_.to() - stretch_.from();
    const double middle = 0.5 * (stretch_.from() + stretch_.to());
    for (const double there : {fraction, fraction + inside_share * (middle - fraction),
                               fraction - inside_share * length}) {
      const auto demand = stretch_.at(there);
      if (!demand) continue;
      Place place{fraction, *demand, {}, {}};
      if (there != fraction) {
        place.demand.axis = stretch_.axis(fraction);
        place.demand.tip_mm = stretch_.tip_mm(fraction);
      }
      place.load.ratio = ratios_of(demand->rate, time_s_, allowance_.limits);
      if (place.load.largest() > allowance_.share)
        place.load.asked_ratio =
            ratios_of(stretch_.asked(there, *demand), time_s_, allowance_.limits);
      if (with_accelerations_) place.acceleration = stretch_.acceleration(there, *demand);
      return place;
    }
    return std::nullopt;
  }

  void divide(const Place& from, const Place& to, int level, std::vector<Place>& places) const {
    const double change =
        stretch_.relative_change(from.demand, to.demand, to.fraction - from.fraction);
    if (change > largest_change && level < most_levels) {
      if (const auto middle = at(0.5 * (from.fraction + to.fraction))) {
        divide(from, *middle, level + 1, places);
        divide(*middle, to, level + 1, places);
        return;
      }
    }
    add_crossings(from, to, places);
    places.push_back(to);
  }

  /// The places where the load passes the allowance, or the share of 1 that costs time.
  void add_crossings(const Place& from, const Place& to, std::vector<Place>& places) const {
    const auto begin = static_cast<std::ptrdiff_t>(places.size());
    add_crossing(from, to, places,
                 [&](const Load& load) { return load.is_singular(allowance_.share); });
    add_crossing(from, to, places,
                 [&](const Load& load) { return load.is_plainly_over(allowance_.share); });
    add_crossing(from, to, places, [&](const Load& load) { return load.largest() > 1.0; });
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
      const auto middle = at(0.5 * (near.fraction + far.fraction));
      if (!middle) break;
      (side(middle->load) == at_from ? near : far) = *middle;
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
