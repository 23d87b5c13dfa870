#include "pentapost/reorient/search.hpp"

#include "pentapost/reorient/search_cell.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pentapost::reorient {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// Of the best value, below which a setup takes its place.
constexpr double gain_share = 0.9995;

/// Cells in order of their least values, and the best that has been found in them.
class Search {
 public:
  Search(const SetupValues& values, const SetupDomain& domain, const SetupChecks& checks,
         const SearchOptions& options)
      : values_{values}, domain_{domain}, checks_{checks}, options_{options} {}

  /// @param coarse_value  at most a little too low.
  void offer(const SetupPoint& setup, double coarse_value, double share) {
    if (!(coarse_value < wanted(share)) || confirmed_ >= options_.most_confirmed) return;
    const SetupPoint answer = rounded(setup);
    if (!domain_.allows(answer)) return;
    const double value = evaluate(answer, exact_tolerance).value;
    if (!(value < wanted(share)) || !checks_.is_clear(answer)) return;
    ++confirmed_;
    const auto exact = checks_.confirm(answer, value);
    if (exact && (!result_.best || *exact < result_.best->value))
      result_.best = Trial{answer, *exact};
  }

  void begin() { take(whole(domain_), 0.0, Hints{hints_}); }

  void take(const SetupCell& cell, double least_value, const Hints& hints) {
    if (is_forbidden(domain_, cell)) return;
    hints_ = hints;
    const SetupPoint middle_setup = middle(domain_, cell);
    const SetupValue at = evaluate(middle_setup, coarse_tolerance);
    if (domain_.allows(middle_setup)) offer(middle_setup, at.value, gain_share);
    if (at.place && values_.accuracy_rad() == 0.0 && values_.goal() == Goal::peak_ratio)
      for (const SetupPoint& edge : values_.knife_edges(domain_, cell, *at.place))
        offer(edge, 0.0, gain_share);
    if (values_.is_impossible(domain_, cell, at)) return;
    SearchCell next{.cell = cell,
                    .least_value = least_value,
                    .hints = hints_,
                    .widest = values_.widest(domain_, cell, at)};
    next.least_value =
        std::max(next.least_value, values_.least_value(domain_, cell, at, next.hints.places));
    waiting_.push(std::move(next));
  }

  /// Goes downhill from the best setup so far: the best one often lies on the edge of what is
  /// allowed, where no cell has its middle.
  void polish() {
    constexpr double first_step_deg = 4.0, first_step_mm = 64.0, last_share = 1.0 / 2048.0;
    if (!result_.best || !options_.goes_downhill) return;
    Trial at{result_.best->setup, evaluate(result_.best->setup, exact_tolerance).value};
    for (double share = 1.0; share >= last_share;)
      if (!step(at, share * first_step_deg, share * first_step_mm)) share *= 0.5;
    offer(at.setup, at.value, 1.0);
  }

  SearchResult run() {
    double least = infinite;
    for (std::size_t cells = 0; !waiting_.empty() && cells < options_.most_cells; cells += 2) {
      if (result_.best && waiting_.top().least_value >= wanted(fine_share())) break;
      const SearchCell cell = waiting_.top();
      waiting_.pop();
      if (cell.widest == SetupDomain::dimensions) {
        least = std::min(least, cell.least_value);
        continue;
      }
      for (const auto& half :
           domain_.coordinates[cell.widest].split(cell.cell.parts[cell.widest])) {
        SetupCell part = cell.cell;
        part.parts[cell.widest] = half;
        take(part, cell.least_value, cell.hints);
      }
    }
    polish();
    if (!waiting_.empty()) least = std::min(least, waiting_.top().least_value);
    if (result_.best) least = std::min(least, result_.best->value);
    result_.least_value = least;
    return result_;
  }

 private:
  double fine_share() const { return 1.0 - options_.fine_share; }
  double wanted(double share) const {
    return result_.best ? share * result_.best->value : infinite;
  }

  SetupValue evaluate(const SetupPoint& setup, double tolerance) {
    ++result_.evaluated;
    return values_.evaluate(setup, hints_, tolerance);
  }

  /// Moves one number of the setup so that its value falls.
  bool step(Trial& at, double step_deg, double step_mm) {
    for (std::size_t i = 0; i < SetupDomain::dimensions; ++i)
      for (const double sign : {-1.0, 1.0}) {
        const SetupPoint next = moved_by(at.setup, i, sign * (i < 2 ? step_deg : step_mm));
        if (next == at.setup || !domain_.allows(next)) continue;
        const double value = evaluate(next, exact_tolerance).value;
        if (!(value < at.value) || !checks_.is_clear(next)) continue;
        at = {next, value};
        return true;
      }
    return false;
  }

  SetupPoint moved_by(const SetupPoint& setup, std::size_t dimension, double by) const {
    const Coordinate& coordinate = domain_.coordinates[dimension];
    SetupPoint moved = setup;
    double& number = moved[dimension];
    number = coordinate.nearest(coordinate.whole(), number + by);
    return rounded(moved);
  }

  /// No finer than anybody can clamp a part.
  SetupPoint rounded(const SetupPoint& setup) const {
    const double steps = options_.steps_per_unit;
    SetupPoint near = setup;
    for (std::size_t i = 0; i < SetupDomain::dimensions && steps > 0.0; ++i) {
      const Coordinate& coordinate = domain_.coordinates[i];
      if (!coordinate.is_list())
        near[i] = coordinate.nearest(coordinate.whole(), std::round(near[i] * steps) / steps);
    }
    return near;
  }

  const SetupValues& values_;
  const SetupDomain& domain_;
  const SetupChecks& checks_;
  const SearchOptions& options_;
  SearchResult result_;
  Hints hints_;
  std::size_t confirmed_ = 0;
  SearchQueue waiting_;
};

}  // namespace

SearchResult find_best(const SetupValues& values, const SetupDomain& domain,
                       const std::vector<Trial>& first, const SetupChecks& checks,
                       const SearchOptions& options) {
  Search search{values, domain, checks, options};
  for (const Trial& each : first)
    if (domain.allows(each.setup)) search.offer(each.setup, each.value, gain_share);
  search.polish();
  search.begin();
  return search.run();
}

}  // namespace pentapost::reorient
