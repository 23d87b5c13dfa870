#pragma once

#include "pentapost/kinematics/model.hpp"
#include "pentapost/reorient/path_loads.hpp"
#include "pentapost/reorient/setup_domain.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace pentapost::reorient {

/// What a setup is chosen by; the smaller the better.
enum class Goal {
  peak_ratio,  ///< largest ratio of an axis to its speed limit
  time,        ///< of the cutting path, s
  travel,      ///< of both rotary axes over the cutting path, rad
};

/// The value of one setup by the rates of the axes alone, without an analysis of the path.
struct SetupValue {
  double value = 0.0;  ///< infinite: not possible, or without bound
  Clampings clampings;
  std::optional<PeakPlace> place;  ///< that decides a peak ratio
  Extremes extremes = {};
};

/// How exact a value must be, as a share of it.
inline constexpr double exact_tolerance = 5e-4, coarse_tolerance = 0.03;

/// What is known of setups nearby: good hints save most of the search for a value.
struct Hints {
  std::vector<PeakPlace> places;  ///< of the path with high ratios, the latest first
  Extremes extremes = {};

  /// Puts a place before the others; keeps the latest ones.
  void remember(const PeakPlace& place);
};

/// Values of setups, and least values over whole cells of them.
class SetupValues {
 public:
  /// @param accuracy_rad  the peak ratio of a setup is the largest over so much about it.
  SetupValues(const kinematics::Model& model, const PathLoads& loads, Goal goal,
              double accuracy_rad)
      : model_{model}, loads_{loads}, goal_{goal}, accuracy_rad_{accuracy_rad} {}

  Goal goal() const { return goal_; }
  double accuracy_rad() const { return accuracy_rad_; }

  /// @param hints  are used and brought up to date.
  /// @param tolerance  by which the value may be too low.
  SetupValue evaluate(const SetupPoint& setup, Hints& hints, double tolerance) const;

  /// Whether no setup of a cell is possible.
  /// @param middle  of the cell.
  bool is_impossible(const SetupDomain& domain, const SetupCell& cell,
                     const SetupValue& middle) const;
  /// No setup of the cell has a lower value.
  double least_value(const SetupDomain& domain, const SetupCell& cell, const SetupValue& middle,
                     std::span<const PeakPlace> places) const;
  double least_ratio(const SetupDomain& domain, const SetupCell& cell, const SetupValue& middle,
                     std::span<const PeakPlace> places) const;

  /// The dimension in which the setups of a cell differ most; SetupDomain::dimensions: in none.
  std::size_t widest(const SetupDomain& domain, const SetupCell& cell,
                     const SetupValue& middle) const;
  /// Setups of the cell in which a move turns the tool axis straight through the pole: there the
  /// first rotary axis rests.
  std::vector<SetupPoint> knife_edges(const SetupDomain& domain, const SetupCell& cell,
                                      const PeakPlace& place) const;

 private:
  Spread about_spread(Spread spread) const;
  Spread spread_of(const SetupDomain& domain, const SetupCell& cell, const Clamping& middle) const;
  double least_ratio(const SetupValue& middle, const Spread& spread,
                     std::span<const PeakPlace> places) const;

  const kinematics::Model& model_;
  const PathLoads& loads_;
  Goal goal_;
  double accuracy_rad_;
};

}  // namespace pentapost::reorient
