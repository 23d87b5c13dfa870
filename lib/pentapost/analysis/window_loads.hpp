#pragma once

#include "pentapost/analysis/survey.hpp"

#include <cstddef>
#include <vector>

namespace pentapost::analysis {

/// A part of a path, by the length of the tip's path from the first point.
struct Window {
  double from_mm = 0.0, to_mm = 0.0;
};

/// What a path asks of the axes within a window.
struct WindowLoad {
  double peak_ratio = 0.0;
  double time_lost_s = 0.0;  ///< against the programmed feed, by the speed limits
};

/// Measures a path within windows, which are in order and do not overlap.
class WindowLoads {
 public:
  explicit WindowLoads(std::vector<Window> windows);

  /// The places of one stretch, as a Grid gives them.
  void take(const SurveyedMove& move, const std::vector<Place>& places);
  /// Whether no window holds any of the way of a move that goes on from those taken.
  bool is_outside(const SurveyedMove& move);
  /// One for each window.
  const std::vector<WindowLoad>& loads() const { return loads_; }

 private:
  void leave_behind(const SurveyedMove& move);

  std::vector<Window> windows_;
  std::vector<WindowLoad> loads_;
  std::size_t next_ = 0;  ///< first window that is not behind the path
};

}  // namespace pentapost::analysis
