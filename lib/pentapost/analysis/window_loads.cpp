#include "pentapost/analysis/window_loads.hpp"

#include <algorithm>
#include <utility>

namespace pentapost::analysis {

WindowLoads::WindowLoads(std::vector<Window> windows)
    : windows_{std::move(windows)}, loads_(windows_.size()) {}

void WindowLoads::leave_behind(const SurveyedMove& move) {
  while (next_ < windows_.size() && windows_[next_].to_mm < move.s_from_mm) ++next_;
}

bool WindowLoads::is_outside(const SurveyedMove& move) {
  leave_behind(move);
  return next_ == windows_.size() || windows_[next_].from_mm > move.s_from_mm + move.length_mm;
}

void WindowLoads::take(const SurveyedMove& move, const std::vector<Place>& places) {
  leave_behind(move);
  for (std::size_t i = next_; i < windows_.size(); ++i) {
    const Window& window = windows_[i];
    if (window.from_mm > move.s_from_mm + move.length_mm) return;
    for (std::size_t k = 1; k < places.size(); ++k) {
      const Place &from = places[k - 1], &to = places[k];
      const double length_mm = (to.fraction - from.fraction) * move.length_mm;
      const double from_mm = move.s_from_mm + from.fraction * move.length_mm;
      const double inside_mm =
          std::min(from_mm + length_mm, window.to_mm) - std::max(from_mm, window.from_mm);
      if (!(inside_mm > 0.0)) continue;
      loads_[i].peak_ratio =
          std::max({loads_[i].peak_ratio, from.load.largest(), to.load.largest()});
      loads_[i].time_lost_s += inside_mm / move.length_mm * move.time_s * (slowing(from, to) - 1.0);
    }
  }
}

}  // namespace pentapost::analysis
