#pragma once

#include "pentapost/analysis/grid.hpp"
#include "pentapost/core/units.hpp"

#include <array>
#include <optional>
#include <vector>

namespace pentapost::analysis {

/// How far the joints go, and which way they make. mm, rad.
class Spans {
 public:
  /// The places of one stretch, as a Grid gives them.
  void take(const std::vector<Place>& places);
  /// Values between the stretches.
  void take(const PerAxis& joints);

  /// The way of each along the stretches. mm, rad.
  const PerAxis& travel() const { return travel_; }
  /// nullopt: nothing was taken.
  const std::optional<std::array<Range<double>, axis_count>>& of_axes() const { return spans_; }

 private:
  void widen(std::size_t axis, double joint);

  std::optional<std::array<Range<double>, axis_count>> spans_;
  PerAxis travel_{};
};

}  // namespace pentapost::analysis
