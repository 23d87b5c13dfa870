#include "pentapost/plan/state_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pentapost::plan {
namespace {

/// Rounding that a range or a window forgives; far below the digits any control reads.
constexpr double forgiven_rad = 1e-7;
/// Rows of turns kept where the whole path fits into several.
constexpr int kept_turns = 3;
constexpr double turn_rad = 2.0 * pi;

struct Span {
  double lower = std::numeric_limits<double>::infinity();
  double upper = -std::numeric_limits<double>::infinity();
  void take(double value) {
    lower = std::min(lower, value);
    upper = std::max(upper, value);
  }
};

/// Whole turns with which `span` and `range` have something in common.
std::vector<int> possible_turns(const Span& span, const Range<double>& range, double wanted_turns) {
  const int lowest =
      static_cast<int>(std::ceil((range.lower - forgiven_rad - span.upper) / turn_rad));
  const int highest =
      static_cast<int>(std::floor((range.upper + forgiven_rad - span.lower) / turn_rad));
  std::vector<int> turns, whole;
  for (int i = lowest; i <= highest; ++i) {
    turns.push_back(i);
    if (in_range(range, span.lower + i * turn_rad) && in_range(range, span.upper + i * turn_rad))
      whole.push_back(i);
  }
  const auto nearer = [&](int x, int y) {
    return std::abs(x - wanted_turns) < std::abs(y - wanted_turns);
  };
  if (whole.size() > kept_turns) {
    std::stable_sort(whole.begin(), whole.end(), nearer);
    whole.resize(kept_turns);
    return whole;
  }
  constexpr std::size_t bound = StateSpace::largest_state_count / 4;
  if (turns.size() > bound) {
    std::stable_sort(turns.begin(), turns.end(), nearer);
    turns.resize(bound);
  }
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

StateSpace state_space(const kinematics::Model& model, const JointRanges& ranges,
                       const Candidates& candidates, const machine::Preferences& preferences) {
  StateSpace space;
  space.first_endless = !ranges.rotary_rad[0] || model.rotary_count < 1;
  space.second_endless = !ranges.rotary_rad[1] || model.rotary_count < 2;
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
    const auto first_turns =
        space.first_endless ? none : possible_turns(first, *ranges.rotary_rad[0], start_turns);
    const auto second_turns =
        space.second_endless ? none : possible_turns(second, *ranges.rotary_rad[1], 0.0);
    for (const int second_turn : second_turns)
      for (const int first_turn : first_turns)
        if (space.states.size() < StateSpace::largest_state_count)
          space.states.push_back({branch, first_turn, second_turn});
  }
  return space;
}

}  // namespace pentapost::plan
