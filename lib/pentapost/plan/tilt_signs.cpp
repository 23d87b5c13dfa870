#include "pentapost/plan/tilt_signs.hpp"

#include "pentapost/kinematics/inverse.hpp"
#include "pentapost/plan/state_space.hpp"

#include <algorithm>

namespace pentapost::plan {
namespace {

/// Index of a sign of tilt (0: plus, 1: minus) and whole turns from -2 to 2.
std::size_t way_of(int branch, int turns) {
  const int way = 2 * (turns + 2) + branch;
  return static_cast<std::size_t>(way);
}

}  // namespace

TiltSigns::Ways TiltSigns::allowed(PointRange points) const {
  Ways ways;
  ways.set();
  const auto& range = ranges_.rotary_rad[1];
  if (!range || points.begin >= points.end) return ways;
  double least = pi, most = 0.0;
  for (std::uint32_t point = points.begin; point < points.end; ++point) {
    if (point > points.begin && tool_path_.axis_wp[point] == tool_path_.axis_wp[point - 1])
      continue;
    const double opening_rad =
        kinematics::inverse_rotary_inside(model_, tool_path_.axis_wp[point], 0).opening_rad;
    least = std::min(least, opening_rad);
    most = std::max(most, opening_rad);
  }
  for (int turns = -most_turns; turns <= most_turns; ++turns)
    for (const int branch : {0, 1}) {
      const double sign = branch == 0 ? 1.0 : -1.0;
      const double zero_rad = model_.beta_zero_rad + 2.0 * pi * turns;
      ways[way_of(branch, turns)] =
          in_range(range, zero_rad + sign * least) && in_range(range, zero_rad + sign * most);
    }
  return ways;
}

void TiltSigns::start(PointRange points) { ways_ = allowed(points); }

void TiltSigns::go_on(PointRange points) {
  const Ways next = allowed(points);
  ways_ &= next;
  // A retract lies between.
  if (ways_.none()) ways_ = next;
}

bool TiltSigns::pass(std::uint8_t pole, PointRange points) {
  Ways passed;
  for (int turns = -most_turns; turns <= most_turns; ++turns)
    for (const int branch : {0, 1}) {
      if (!ways_[way_of(branch, turns)]) continue;
      // At gamma = pi the second joint goes on beyond half a turn.
      const int next = pole == 1 ? turns : branch == 0 ? turns + 1 : turns - 1;
      if (next >= -most_turns && next <= most_turns) passed.set(way_of(1 - branch, next));
    }
  passed &= allowed(points);
  if (passed.none()) return false;
  ways_ = passed;
  return true;
}

}  // namespace pentapost::plan
