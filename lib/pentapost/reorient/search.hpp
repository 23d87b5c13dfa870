#pragma once

#include "pentapost/reorient/setup_domain.hpp"
#include "pentapost/reorient/setup_values.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace pentapost::reorient {

/// A setup with its value.
struct Trial {
  SetupPoint setup;
  double value = 0.0;
};

struct SearchResult {
  std::optional<Trial> best;  ///< nullopt: none is possible
  /// No setup of the domain has a lower value; infinite: none is possible.
  double least_value = 0.0;
  std::uint64_t evaluated = 0;
};

struct SearchOptions {
  std::size_t most_cells = 3000;
  double fine_share = 0.005;  ///< of the value, below which a better setup is not searched for
  std::size_t most_confirmed = 24;
  bool goes_downhill = true;    ///< from the best setup of the cells
  double steps_per_unit = 0.0;  ///< of deg and mm, to which setups are rounded; 0: they are not
};

/// What the bounds by the rates of the axes don't know.
struct SetupChecks {
  /// Whether nothing collides.
  std::function<bool(const SetupPoint& setup)> is_clear;
  /// The value by the analysis of the path, where `value` is the one by the rates; nullopt: the
  /// setup is not possible.
  std::function<std::optional<double>(const SetupPoint& setup, double value)> confirm;
};

/// Finds the best of all setups: by bounds over whole cells of setups, which are halved where they
/// may yet hold a better one (lib/README.md section 7).
///
/// @param first  setups that are tried before any other, in order, with values that may be coarse.
SearchResult find_best(const SetupValues& values, const SetupDomain& domain,
                       const std::vector<Trial>& first, const SetupChecks& checks,
                       const SearchOptions& options);

/// The setup of the least |theta_x| whose peak ratio is at most 1, to `fine_deg`. Its value, and
/// the least one, are that angle in degrees.
/// @param values  of Goal::peak_ratio.
SearchResult find_smallest_tilt(const SetupValues& values, const SetupDomain& domain,
                                double fine_deg, const SetupChecks& checks,
                                const SearchOptions& options);

}  // namespace pentapost::reorient
