#include "pentapost/plan/state_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pentapost::plan {
namespace {

/// Rounding that a range or a window forgives; far below the digits any control reads.
constexpr double forgiven_rad = 1e-7;
/// Turns followed where the whole path fits into several.
constexpr int kept_turns = 3;
/// Remainders followed where it does not.
constexpr int kept_remainders = 12;
/// Ranges beyond this are endless in all but name.
constexpr double largest_turns = 1e6;
constexpr double turn_rad = 2.0 * pi;

struct Span {
  double lower = std::numeric_limits<double>::infinity();
  double upper = -std::numeric_limits<double>::infinity();
  void take(double value) {
    lower = std::min(lower, value);
    upper = std::max(upper, value);
  }
};

/// Whole turns with which `span` and `range` have something in common, or all of `span` lies in it.
struct Turns {
  double lowest, highest;
};
Turns common_turns(const Span& span, const Range<double>& range) {
  return {std::ceil((range.lower - forgiven_rad - span.upper) / turn_rad),
          std::floor((range.upper + forgiven_rad - span.lower) / turn_rad)};
}
Turns whole_turns(const Span& span, const Range<double>& range) {
  return {std::ceil((range.lower - forgiven_rad - span.lower) / turn_rad),
          std::floor((range.upper + forgiven_rad - span.upper) / turn_rad)};
}

/// At most `kept_turns` of them, those nearest to `wanted`.
std::vector<int> nearest_turns(const Turns& turns, double wanted) {
  constexpr int below = kept_turns / 2;
  const double lowest = std::clamp(wanted - below, turns.lowest,
                                   std::max(turns.lowest, turns.highest - (kept_turns - 1)));
  std::vector<int> nearest;
  for (double turn = lowest; turn <= turns.highest && nearest.size() < kept_turns; turn += 1.0)
    nearest.push_back(static_cast<int>(turn));
  return nearest;
}

std::vector<int> second_turns_of(const Span& span, const Range<double>& range) {
  const Turns whole = whole_turns(span, range);
  const bool fits = whole.highest - whole.lowest + 1.0 >= kept_turns;
  return nearest_turns(fits ? whole : common_turns(span, range), 0.0);
}

/// One representative of each remainder that is followed.
std::vector<int> first_turns_of(const Span& span, const Range<double>& range, int modulus,
                                double wanted) {
  const Turns whole = whole_turns(span, range);
  if (whole.highest - whole.lowest + 1.0 >= kept_turns) return nearest_turns(whole, wanted);
  // A path that winds beyond the range: in a wide one the turns to go on with are spread over it.
  const int count = std::min(modulus, kept_remainders);
  std::vector<int> turns;
  turns.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    turns.push_back(static_cast<int>(wanted) + static_cast<int>(1LL * i * modulus / count));
  return turns;
}

}  // namespace

bool in_range(const std::optional<Range<double>>& range, double value_rad) {
  return !range ||
         (range->lower - forgiven_rad <= value_rad && value_rad <= range->upper + forgiven_rad);
}

Range<double> start_window_rad(const machine::Preferences& preferences) {
  if (!preferences.first_turn) return {-pi, pi};
  return {preferences.first_turn->lower.rad(), preferences.first_turn->upper.rad()};
}

double moved_to_window_rad(double value_rad, const Range<double>& window_rad) {
  return value_rad + turn_rad * std::ceil((window_rad.lower - forgiven_rad - value_rad) / turn_rad);
}

int StateSpace::first_turns(const State& state, double value_rad) const {
  if (first_endless) return state.first_turns;
  const double from_centre = (first_centre_rad - value_rad) / turn_rad - state.first_turns;
  return state.first_turns +
         first_modulus * static_cast<int>(std::round(from_centre / first_modulus));
}

StateSpace state_space(const kinematics::Model& model, const JointRanges& ranges,
                       const Candidates& candidates, const machine::Preferences& preferences) {
  StateSpace space;
  space.first_endless = !ranges.rotary_rad[0] || model.rotary_count < 1;
  space.second_endless = !ranges.rotary_rad[1] || model.rotary_count < 2;
  if (!space.first_endless) {
    const Range<double>& range = *ranges.rotary_rad[0];
    space.first_centre_rad = 0.5 * (range.lower + range.upper);
    space.first_modulus = static_cast<int>(
        std::min(largest_turns, std::floor((range.upper - range.lower) / turn_rad) + 2.0));
  }
  const auto window = start_window_rad(preferences);
  for (int branch = 0; branch < candidates.branches; ++branch) {
    Span first, second;
    double start_turns = std::numeric_limits<double>::quiet_NaN();
    for (std::uint32_t point = candidates.range.begin; point < candidates.range.end; ++point) {
      if (candidates.pole[point - candidates.range.begin] != 0) continue;
      const double value = candidates.first_of(point, branch);
      if (std::isnan(start_turns))
        start_turns = std::round((moved_to_window_rad(value, window) - value) / turn_rad);
      first.take(value);
      second.take(candidates.second_of(model, point, branch));
    }
    if (std::isnan(start_turns)) continue;
    const std::vector<int> none{0};
    const auto first_turns = space.first_endless ? none
                                                 : first_turns_of(first, *ranges.rotary_rad[0],
                                                                  space.first_modulus, start_turns);
    const auto second_turns =
        space.second_endless ? none : second_turns_of(second, *ranges.rotary_rad[1]);
    for (const int second_turn : second_turns)
      for (const int first_turn : first_turns)
        if (space.states.size() < StateSpace::largest_state_count)
          space.states.push_back({branch, first_turn, second_turn});
  }
  return space;
}

}  // namespace pentapost::plan
