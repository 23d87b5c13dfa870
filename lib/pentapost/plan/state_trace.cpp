#include "pentapost/plan/state_search.hpp"

#include "pentapost/core/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pentapost::plan {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double turn_rad = 2.0 * pi;
/// Values this close are the same posture.
constexpr double same_rad = 1e-6;

}  // namespace

std::vector<StateSearch::Chosen> StateSearch::chosen_states() const {
  std::vector<Chosen> chosen(off_pole_.size());
  std::size_t state = 0;
  for (std::size_t other = 1; other < reached_.size(); ++other)
    if (reached_[other].cost_s < reached_[state].cost_s) state = other;
  auto repositioned = repositioned_.rbegin();
  for (std::size_t row = off_pole_.size(); row-- > 0;) {
    Chosen& here = chosen[row];
    here.departure = static_cast<std::uint8_t>(state);
    here.arrival = here.departure;
    for (; repositioned != repositioned_.rend() && repositioned->row >= row; ++repositioned)
      if (repositioned->row == row && repositioned->to == state) here.arrival = repositioned->from;
    const std::uint8_t from = rows_[row * reached_.size() + here.arrival];
    here.inside = (from & inside_bit) != 0;
    state = static_cast<std::size_t>(from & static_cast<std::uint8_t>(~inside_bit));
  }
  return chosen;
}

AxisPath StateSearch::empty_path() const {
  AxisPath path;
  path.range = candidates_.range;
  path.pole = candidates_.pole;
  path.arrival.resize(candidates_.pole.size());
  path.branch.resize(candidates_.pole.size(), AxisPath::at_rest);
  return path;
}

/// Follows the chosen states from the start and writes values and turns down.
AxisPath StateSearch::trace_back() {
  const std::vector<Chosen> chosen = chosen_states();
  AxisPath path = empty_path();
  const std::uint32_t begin = path.range.begin;
  Reached turns;
  for (std::size_t row = 0; row < chosen.size(); ++row) {
    const std::uint32_t point = off_pole_[row];
    const State& state = space_.states[chosen[row].arrival];
    if (row == 0) {
      turns = started(chosen[0].arrival, point);
      if (point > begin) {
        const PolePassage passage{model_, tool_path_, candidates_, std::nullopt, point};
        const RotaryPair out =
            passage.pair_out(pair_of(chosen[0].arrival, turns, point), state.branch);
        passage.write(out, out, state.branch, state.branch, path);
      }
    } else {
      const std::uint32_t before = off_pole_[row - 1];
      const std::size_t left = chosen[row - 1].departure;
      const Link link = candidates_.link[point - begin];
      if (link == Link::over_pole) {
        const PolePassage passage{model_, tool_path_, candidates_, before, point};
        const RotaryPair in =
            passage.pair_in(pair_of(left, turns, before), space_.states[left].branch);
        Reached there = with_turns(chosen[row].arrival, point, 0.0);
        const RotaryPair out = near_endless(chosen[row].arrival, there, passage, point, in);
        passage.write(in, out, space_.states[left].branch, state.branch, path);
        turns = there;
      } else if (chosen[row].inside) {
        const Reached there = with_turns(chosen[row].arrival, point, 0.0);
        path.departures.push_back(
            {before, {}, true, true, turn_rad * (there.first_turns - turns.first_turns)});
        turns.first_turns = there.first_turns;
      } else if (link == Link::broken) {
        turns = with_turns(chosen[row].arrival, point, 0.0);
        // The repositioning belongs to the point before, with the values of the branch there.
        path.departures.push_back({before, pair_of(chosen[row].arrival, turns, point), true});
      }
    }
    path.arrival[point - begin] = pair_of(chosen[row].arrival, turns, point);
    path.branch[point - begin] = static_cast<std::uint8_t>(state.branch);
    if (chosen[row].departure != chosen[row].arrival) {
      const RotaryPair from = path.arrival[point - begin];
      Reached there = with_turns(chosen[row].departure, point, 0.0);
      RotaryPair to = pair_of(chosen[row].departure, there, point);
      if (space_.first_endless) {
        there.first_turns +=
            static_cast<int>(std::round((from.first_rad - to.first_rad) / turn_rad));
        to = pair_of(chosen[row].departure, there, point);
      }
      turns = there;
      const bool moves = std::abs(to.first_rad - from.first_rad) > same_rad ||
                         std::abs(to.second_rad - from.second_rad) > same_rad;
      path.departures.push_back({point, to, moves});
    }
  }
  if (off_pole_.back() + 1 < path.range.end) {
    const PolePassage passage{model_, tool_path_, candidates_, off_pole_.back(), std::nullopt};
    const int branch = space_.states[chosen.back().departure].branch;
    const RotaryPair in =
        passage.pair_in(pair_of(chosen.back().departure, turns, off_pole_.back()), branch);
    passage.write(in, in, branch, branch, path);
  }
  return path;
}

/// A path wholly at the pole keeps the first axis at the start preference.
Result<AxisPath> StateSearch::path_at_pole() const {
  AxisPath path = empty_path();
  RotaryPair pair;
  if (model_.rotary_count > 0) {
    const auto window = start_window_rad(settings_.preferences);
    pair.first_rad = in_range(window, 0.0) ? 0.0 : window.lower;
    if (const auto& range = ranges_.rotary_rad[0]; range)
      pair.first_rad = std::clamp(pair.first_rad, range->lower, range->upper);
  }
  if (model_.rotary_count == 2) {
    pair.second_rad = second_at_pole_rad(model_, candidates_.pole.front(), 0);
    if (const auto& range = ranges_.rotary_rad[1]; !in_range(range, pair.second_rad)) {
      const double moved_rad = moved_to_window_rad(pair.second_rad, *range);
      if (!in_range(range, moved_rad)) {
        const std::uint32_t line = tool_path_.cl_line[path.range.begin];
        return Problem{.code = Code::rotary_range,
                       .message = model_.rotary_names[1] + " = " +
                                  number_text(pair.second_rad * deg_per_rad, 3) +
                                  " deg lies outside " +
                                  number_text(range->lower * deg_per_rad, 3) + " to " +
                                  number_text(range->upper * deg_per_rad, 3) + " deg at CL line " +
                                  std::to_string(line),
                       .cl_line = line};
      }
      pair.second_rad = moved_rad;
    }
  }
  std::fill(path.arrival.begin(), path.arrival.end(), pair);
  return path;
}

/// No state is left at a point: says which axis is nearest to being possible.
Problem StateSearch::out_of_range(std::uint32_t point) const {
  const std::uint32_t line = tool_path_.cl_line[point];
  const std::string place = " at CL line " + std::to_string(line);
  double least_rad = infinite;
  std::string message;
  const auto look = [&](std::size_t axis, double value_rad) {
    const auto& range = ranges_.rotary_rad[axis];
    if (in_range(range, value_rad)) return 0.0;
    return std::max(range->lower - value_rad, value_rad - range->upper);
  };
  for (int branch = 0; branch < candidates_.branches; ++branch) {
    const double second_rad = candidates_.second_of(model_, point, branch);
    for (int turn = -1; turn <= 1; ++turn) {
      const std::array<double, 2> value_rad{
          wrapped_rad(candidates_.first_of(point, branch)) + turn_rad * turn, second_rad};
      const std::size_t axis = look(1, value_rad[1]) > 0.0 ? 1 : 0;
      const double beyond_rad = look(axis, value_rad[axis]);
      if (beyond_rad == 0.0 || beyond_rad >= least_rad) continue;
      least_rad = beyond_rad;
      const auto& range = *ranges_.rotary_rad[axis];
      message = model_.rotary_names[axis] + " = " + number_text(value_rad[axis] * deg_per_rad, 3) +
                " deg lies outside " + number_text(range.lower * deg_per_rad, 3) + " to " +
                number_text(range.upper * deg_per_rad, 3) + " deg" + place;
    }
    if (look(1, second_rad) > 0.0 || !check_linear_) continue;
    const auto index = static_cast<std::size_t>(branch);
    for (std::size_t i = 0; i < 3; ++i) {
      const double value_mm = linear_[index][static_cast<Eigen::Index>(i)];
      const auto& range = ranges_.linear_mm[i];
      if (!range || range->contains(value_mm)) continue;
      return {.code = Code::linear_range,
              .message = model_.linear_names[i] + " = " + number_text(value_mm, 3) +
                         " mm lies outside " + number_text(range->lower, 3) + " to " +
                         number_text(range->upper, 3) + " mm" + place,
              .cl_line = line};
    }
  }
  if (message.empty())
    message = "no rotary position within the ranges leads on from the point before" + place;
  return {.code = Code::rotary_range, .message = std::move(message), .cl_line = line};
}

}  // namespace pentapost::plan
