#include "pentapost/reorient/search.hpp"

#include "pentapost/reorient/search_cell.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pentapost::reorient {
namespace {

/// Cells in order of their least tilt.
class TiltSearch {
 public:
  TiltSearch(const SetupValues& values, const SetupDomain& domain, double fine_deg,
             const SetupChecks& checks, const SearchOptions& options)
      : values_{values}, domain_{domain}, fine_deg_{fine_deg}, checks_{checks}, options_{options} {
    result_.least_value = std::numeric_limits<double>::infinity();
  }

  void take(const SetupCell& cell, const Hints& hints) {
    if (is_forbidden(domain_, cell)) return;
    const Coordinate& tilts = domain_.coordinates[0];
    SearchCell next{.cell = cell,
                    .least_value = std::abs(tilts.nearest(cell.parts[0], 0.0)),
                    .hints = hints,
                    .widest = 0};
    if (!(next.least_value <= wanted_deg())) return;
    const SetupPoint setup = middle(domain_, cell);
    SetupPoint flattest = setup;
    flattest.theta_x_deg = tilts.nearest(cell.parts[0], 0.0);
    const SetupValue at_flattest = evaluate(flattest, next.hints);
    const SetupValue at = evaluate(setup, next.hints);
    offer(flattest, at_flattest.value);
    offer(setup, at.value);
    if (at.place && values_.accuracy_rad() == 0.0)
      for (const SetupPoint& edge : values_.knife_edges(domain_, cell, *at.place)) offer(edge, 0.0);
    if (values_.is_impossible(domain_, cell, at)) return;
    if (values_.least_ratio(domain_, cell, at, next.hints.places) > 1.0) return;
    next.widest = values_.widest(domain_, cell, at);
    waiting_.push(std::move(next));
  }

  SearchResult run() {
    for (std::size_t cells = 0; !waiting_.empty() && cells < options_.most_cells; cells += 2) {
      const SearchCell cell = waiting_.top();
      if (!(cell.least_value <= wanted_deg())) break;
      waiting_.pop();
      if (cell.widest == SetupDomain::dimensions) continue;
      for (const auto& half :
           domain_.coordinates[cell.widest].split(cell.cell.parts[cell.widest])) {
        SetupCell part = cell.cell;
        part.parts[cell.widest] = half;
        take(part, cell.hints);
      }
    }
    if (!waiting_.empty()) result_.least_value = waiting_.top().least_value;
    lower();
    if (result_.best) result_.least_value = std::min(result_.least_value, result_.best->value);
    return result_;
  }

 private:
  /// Tries less tilt in directions all round, and then in those next to the best one: where the
  /// cells have come to their number, theirs is seldom the least.
  void lower() {
    constexpr int directions = 72;
    constexpr double finest_deg = 0.01;
    confirmed_ = 0;
    const Coordinate& turns = domain_.coordinates[1];
    const auto all = turns.whole();
    const double step_deg = (all.upper - all.lower) / directions;
    for (int i = 0; i <= directions; ++i) lower_at(turns.nearest(all, all.lower + step_deg * i));
    for (double aside_deg = 0.5 * step_deg; aside_deg > finest_deg && result_.best;
         aside_deg *= 0.5) {
      const double turn_deg = result_.best->setup.theta_z_deg;
      for (const double sign : {-1.0, 1.0})
        lower_at(turns.nearest(all, turn_deg + sign * aside_deg));
    }
  }

  /// Halves the tilt at a turn between one that is too small and one that is not.
  void lower_at(double theta_z_deg) {
    constexpr int halvings = 14;
    const Coordinate& tilts = domain_.coordinates[0];
    const auto all = tilts.whole();
    for (const double sign : {-1.0, 1.0}) {
      const auto at = [&](double tilt_deg) {
        SetupPoint setup = middle(domain_, whole(domain_));
        setup.theta_x_deg = tilts.nearest(all, sign * tilt_deg);
        setup.theta_z_deg = theta_z_deg;
        return setup;
      };
      const auto serves = [&](double tilt_deg) {
        return domain_.allows(at(tilt_deg)) && evaluate(at(tilt_deg), hints_).value <= 1.0;
      };
      double high = std::min(wanted_deg(), std::max(std::abs(all.lower), std::abs(all.upper)));
      if (!(high >= 0.0) || !serves(high)) continue;
      double low = 0.0;
      for (int i = 0; i < halvings; ++i) {
        const double half = 0.5 * (low + high);
        (serves(half) ? high : low) = half;
      }
      // A coarse value is a little low: a little more tilt makes up for it.
      for (double tilt_deg = high; tilt_deg <= wanted_deg();
           tilt_deg += std::max(fine_deg_, 0.01 * tilt_deg)) {
        const double before_deg = wanted_deg();
        offer(at(tilt_deg), 0.0);
        if (wanted_deg() < before_deg || confirmed_ >= options_.most_confirmed) break;
      }
    }
  }

  double wanted_deg() const {
    return result_.best ? result_.best->value - fine_deg_ : std::numeric_limits<double>::infinity();
  }

  SetupValue evaluate(const SetupPoint& setup, Hints& hints) {
    ++result_.evaluated;
    return values_.evaluate(setup, hints, coarse_tolerance);
  }

  /// @param coarse_ratio  at most a little too low.
  void offer(const SetupPoint& wanted, double coarse_ratio) {
    const SetupPoint setup = rounded(wanted);
    const double tilt_deg = std::abs(setup.theta_x_deg);
    if (!(coarse_ratio <= 1.0) || !(tilt_deg <= wanted_deg()) || !domain_.allows(setup) ||
        confirmed_ >= options_.most_confirmed)
      return;
    Hints none;
    const double ratio = values_.evaluate(setup, none, exact_tolerance).value;
    if (!(ratio <= 1.0) || !checks_.is_clear(setup)) return;
    ++confirmed_;
    const auto exact = checks_.confirm(setup, ratio);
    if (exact && *exact <= 1.0) result_.best = Trial{setup, tilt_deg};
  }

  /// No finer than anybody can clamp a part, with no less tilt.
  SetupPoint rounded(const SetupPoint& setup) const {
    constexpr double rounding = 1e-6;
    const double steps = options_.steps_per_unit;
    SetupPoint near = setup;
    for (std::size_t i = 0; i < SetupDomain::dimensions && steps > 0.0; ++i) {
      const Coordinate& coordinate = domain_.coordinates[i];
      if (coordinate.is_list()) continue;
      const double units = setup[i] * steps;
      const double whole_units =
          i == 0 ? std::copysign(std::ceil(std::abs(units) - rounding), units) : std::round(units);
      near[i] = coordinate.nearest(coordinate.whole(), whole_units / steps);
    }
    return near;
  }

  const SetupValues& values_;
  const SetupDomain& domain_;
  const double fine_deg_;
  const SetupChecks& checks_;
  const SearchOptions& options_;
  SearchResult result_;
  std::size_t confirmed_ = 0;
  Hints hints_;
  SearchQueue waiting_;
};

}  // namespace

SearchResult find_smallest_tilt(const SetupValues& values, const SetupDomain& domain,
                                double fine_deg, const SetupChecks& checks,
                                const SearchOptions& options) {
  TiltSearch search{values, domain, fine_deg, checks, options};
  search.take(whole(domain), {});
  return search.run();
}

}  // namespace pentapost::reorient
