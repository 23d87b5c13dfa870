#include "pentapost/plan/branches.hpp"

#include "pentapost/core/number_text.hpp"
#include "pentapost/kinematics/inverse.hpp"
#include "pentapost/plan/pole_passage.hpp"
#include "pentapost/plan/state_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pentapost::plan {
namespace {

using kinematics::Model;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double turn_rad = 2.0 * pi;
// Costs in seconds, each far above all that the one below it can add up to.
constexpr double retract_in_cut_s = 2e6;
constexpr double retract_in_air_s = 1e6;
constexpr double inside_move_s = 1e3;  ///< a cut inside a move rather than at a point
constexpr double wrong_tilt_s = 1e4;
constexpr double outside_window_s = 1e3;  ///< a turn
/// Openings from which the two branches are one: both ends of the triangle.
constexpr double merged_rad = 1e-7;
constexpr std::uint8_t inside_bit = 0x80;

/// What a state costs, and where its endless axes are.
struct Reached {
  double cost_s = infinite;
  int first_turns = 0;
  int second_turns = 0;
};

class Chooser {
 public:
  Chooser(const Model& model, const JointRanges& ranges, const path::ToolPath& tool_path,
          const Candidates& candidates, const Settings& settings, double gauge_length_mm,
          bool check_linear)
      : model_{model},
        ranges_{ranges},
        tool_path_{tool_path},
        candidates_{candidates},
        settings_{settings},
        gauge_length_mm_{gauge_length_mm},
        check_linear_{check_linear},
        speeds_{ordering_speeds(model, settings)},
        space_{state_space(model, ranges, candidates, settings.preferences)},
        reached_(space_.states.size()) {}

  Result<AxisPath> run() {
    std::uint32_t before = 0;
    for (std::uint32_t point = candidates_.range.begin; point < candidates_.range.end; ++point) {
      if (pole_of(point) != 0) continue;
      look_at(point);
      if (off_pole_.empty())
        begin(point);
      else if (auto status = go_on(before, point); !status)
        return std::move(status).error();
      reposition(point);
      if (!any_reached()) return out_of_range(point);
      off_pole_.push_back(point);
      before = point;
      linear_before_ = linear_;
    }
    if (off_pole_.empty()) return path_at_pole();
    return trace_back();
  }

 private:
  std::uint8_t pole_of(std::uint32_t point) const {
    return candidates_.pole[point - candidates_.range.begin];
  }
  Vec3 tip_table(std::uint32_t point) const {
    return tool_path_.tip_wp_mm[point] + settings_.origin_mm;
  }

  RotaryPair pair_of(std::size_t state, const Reached& reached, std::uint32_t point) const {
    const int branch = space_.states[state].branch;
    return {candidates_.first_of(point, branch) + turn_rad * reached.first_turns,
            candidates_.second_of(model_, point, branch) + turn_rad * reached.second_turns};
  }
  Reached with_turns(std::size_t state, double cost_s) const {
    return {cost_s, space_.states[state].first_turns, space_.states[state].second_turns};
  }

  /// Linear values of both branches at a point, and whether their ranges hold.
  void look_at(std::uint32_t point) {
    for (int branch = 0; branch < candidates_.branches; ++branch) {
      const auto index = static_cast<std::size_t>(branch);
      const auto linear = kinematics::inverse_linear(
          model_, tip_table(point), candidates_.first_of(point, branch),
          candidates_.second_of(model_, point, branch), gauge_length_mm_);
      linear_ok_[index] = linear.has_value();
      if (!linear) continue;
      linear_[index] = *linear;
      if (!check_linear_) continue;
      for (Eigen::Index i = 0; i < 3; ++i) {
        const auto& range = ranges_.linear_mm[static_cast<std::size_t>(i)];
        if (range && !range->contains((*linear)[i])) linear_ok_[index] = false;
      }
    }
  }

  bool admissible(std::size_t state, const Reached& reached, std::uint32_t point) const {
    if (!linear_ok_[static_cast<std::size_t>(space_.states[state].branch)]) return false;
    const RotaryPair pair = pair_of(state, reached, point);
    return in_range(ranges_.rotary_rad[0], pair.first_rad) &&
           in_range(ranges_.rotary_rad[1], pair.second_rad);
  }

  /// A cutting sequence starts: here the preferences decide.
  void begin(std::uint32_t point) {
    from_.resize(reached_.size());
    for (std::size_t state = 0; state < reached_.size(); ++state) {
      from_[state] = static_cast<std::uint8_t>(state);
      reached_[state] = started(state, point);
      if (!admissible(state, reached_[state], point)) reached_[state].cost_s = infinite;
    }
    push_back_row();
  }

  /// A state at the first point off the pole, by the preferences.
  Reached started(std::size_t state, std::uint32_t point) const {
    const auto window = start_window_rad(settings_.preferences);
    Reached start = with_turns(state, 0.0);
    RotaryPair pair = pair_of(state, start, point);
    if (space_.first_endless) {
      const double moved_rad = moved_to_window_rad(pair.first_rad, window);
      start.first_turns = static_cast<int>(std::lround((moved_rad - pair.first_rad) / turn_rad));
      pair.first_rad = moved_rad;
    }
    const double outside_rad =
        std::max({0.0, window.lower - pair.first_rad, pair.first_rad - window.upper});
    start.cost_s = outside_window_s * outside_rad / turn_rad;
    if (model_.rotary_count == 2 && settings_.preferences.tilt) {
      const bool positive = *settings_.preferences.tilt == machine::Preferences::Tilt::positive;
      if (positive ? pair.second_rad < 0.0 : pair.second_rad > 0.0) start.cost_s += wrong_tilt_s;
    }
    return start;
  }

  Status go_on(std::uint32_t before, std::uint32_t point) {
    switch (candidates_.link[point - candidates_.range.begin]) {
      case Link::continuous:
        step(before, point);
        break;
      case Link::over_pole:
        pass_pole(before, point);
        break;
      case Link::broken:
        turn_about(point);
        break;
      case Link::start:
        throw std::logic_error{"choose_branches: a start inside the path"};
    }
    return ok();
  }

  double step_time_s(std::uint32_t before, std::uint32_t point, int branch) const {
    const auto index = static_cast<std::size_t>(branch);
    const double first_s =
        std::abs(candidates_.first_of(point, branch) - candidates_.first_of(before, branch)) /
        speeds_.rotary_rad_s[0];
    const double second_s = std::abs(candidates_.second_rad[point - candidates_.range.begin] -
                                     candidates_.second_rad[before - candidates_.range.begin]) /
                            speeds_.rotary_rad_s[1];
    const Vec3 linear_s =
        (linear_[index] - linear_before_[index]).cwiseAbs().cwiseQuotient(speeds_.linear_mm_s);
    return std::max({first_s, second_s, linear_s.maxCoeff()});
  }

  double retract_s(std::uint32_t point) const {
    const bool air = tool_path_.move[point] == path::Move::rapid ||
                     point + 1 == candidates_.range.end ||
                     tool_path_.move[point + 1] == path::Move::rapid;
    return air ? retract_in_air_s : retract_in_cut_s;
  }

  /// Every state goes on along its branch; where that ends at a limit of the first axis, a state
  /// with other turns takes over inside the move.
  void step(std::uint32_t before, std::uint32_t point) {
    std::array<double, 2> time_s{};
    for (int branch = 0; branch < candidates_.branches; ++branch)
      time_s[static_cast<std::size_t>(branch)] = step_time_s(before, point, branch);
    std::vector<Reached>& next = next_;
    next.assign(reached_.size(), Reached{});
    from_.assign(reached_.size(), 0);
    for (std::size_t state = 0; state < reached_.size(); ++state) {
      from_[state] = static_cast<std::uint8_t>(state);
      Reached here = reached_[state];
      if (here.cost_s == infinite) continue;
      here.cost_s += time_s[static_cast<std::size_t>(space_.states[state].branch)];
      if (admissible(state, here, point)) next[state] = here;
    }
    if (!space_.first_endless) take_over_inside(before, point, next);
    reached_.swap(next);
    push_back_row();
  }

  void take_over_inside(std::uint32_t before, std::uint32_t point, std::vector<Reached>& next) {
    for (std::size_t from = 0; from < reached_.size(); ++from) {
      if (reached_[from].cost_s == infinite || next[from].cost_s != infinite) continue;
      for (std::size_t to = 0; to < reached_.size(); ++to) {
        const State &left = space_.states[from], &taken = space_.states[to];
        if (taken.branch != left.branch || taken.second_turns != left.second_turns || from == to)
          continue;
        Reached there = with_turns(to, reached_[from].cost_s + retract_in_cut_s + inside_move_s);
        there.second_turns = reached_[from].second_turns;
        if (there.cost_s >= next[to].cost_s || !admissible(to, there, point)) continue;
        // Both must be within range at the same place on the way: the limit that `from` meets.
        const double to_before = pair_of(to, there, before).first_rad;
        const double from_after = pair_of(from, reached_[from], point).first_rad;
        const auto& range = *ranges_.rotary_rad[0];
        const double limit = from_after > range.upper ? range.upper : range.lower;
        const double taken_there = limit + turn_rad * (there.first_turns - reached_[from].first_turns);
        if (in_range(range, to_before) || !in_range(range, taken_there)) continue;
        next[to] = there;
        from_[to] = static_cast<std::uint8_t>(from | inside_bit);
      }
    }
  }

  /// Between the points lies the pole, where the first axis may turn.
  void pass_pole(std::uint32_t before, std::uint32_t point) {
    const PolePassage passage{model_, tool_path_, candidates_, before, point};
    next_.assign(reached_.size(), Reached{});
    from_.assign(reached_.size(), 0);
    for (std::size_t to = 0; to < reached_.size(); ++to) {
      for (std::size_t from = 0; from < reached_.size(); ++from) {
        if (reached_[from].cost_s == infinite) continue;
        const RotaryPair in = passage.pair_in(pair_of(from, reached_[from], before),
                                              space_.states[from].branch);
        Reached there = with_turns(to, 0.0);
        const RotaryPair out = near_endless(to, there, passage, point, in);
        if (std::abs(out.second_rad - in.second_rad) > merged_rad) continue;
        there.cost_s =
            reached_[from].cost_s + passage.turn_cost_s(in, out, speeds_.rotary_rad_s[0]);
        if (there.cost_s >= next_[to].cost_s || !admissible(to, there, point)) continue;
        next_[to] = there;
        from_[to] = static_cast<std::uint8_t>(from);
      }
    }
    reached_.swap(next_);
    push_back_row();
  }

  /// Values at the pole before going on to `point` in a state; endless axes by the nearest turn.
  RotaryPair near_endless(std::size_t to, Reached& there, const PolePassage& passage,
                          std::uint32_t point, const RotaryPair& in) const {
    const int branch = space_.states[to].branch;
    RotaryPair out = passage.pair_out(pair_of(to, there, point), branch);
    if (space_.first_endless) {
      const double turns = std::round((in.first_rad - out.first_rad) / turn_rad);
      there.first_turns += static_cast<int>(turns);
      out.first_rad += turn_rad * turns;
    }
    if (space_.second_endless) {
      const double turns = std::round((in.second_rad - out.second_rad) / turn_rad);
      there.second_turns += static_cast<int>(turns);
      out.second_rad += turn_rad * turns;
    }
    return out;
  }

  /// A rapid turns the tool axis about: only a repositioning leads on.
  void turn_about(std::uint32_t point) {
    from_.assign(reached_.size(), 0);
    std::size_t best = 0;
    for (std::size_t state = 0; state < reached_.size(); ++state)
      if (reached_[state].cost_s < reached_[best].cost_s) best = state;
    const double cost_s = reached_[best].cost_s + retract_in_air_s;
    for (std::size_t state = 0; state < reached_.size(); ++state) {
      from_[state] = static_cast<std::uint8_t>(best);
      reached_[state] = with_turns(state, cost_s);
      if (!admissible(state, reached_[state], point)) reached_[state].cost_s = infinite;
    }
    push_back_row();
  }

  /// At a point any state can follow on the cheapest one by way of a retract; where the branches
  /// meet, on the other branch without.
  void reposition(std::uint32_t point) {
    std::size_t best = 0;
    for (std::size_t state = 1; state < reached_.size(); ++state)
      if (reached_[state].cost_s < reached_[best].cost_s) best = state;
    if (reached_.empty() || reached_[best].cost_s == infinite) return;
    const double opening_rad =
        std::abs(candidates_.second_rad[point - candidates_.range.begin] - model_.beta_zero_rad);
    const bool merged = candidates_.branches == 2 &&
                        (opening_rad <= merged_rad || opening_rad >= pi - merged_rad);
    const RotaryPair from = pair_of(best, reached_[best], point);
    const double base_s = reached_[best].cost_s;
    for (std::size_t state = 0; state < reached_.size(); ++state) {
      if (state == best) continue;
      Reached there = with_turns(state, 0.0);
      RotaryPair to = pair_of(state, there, point);
      if (space_.first_endless) {
        const double turns = std::round((from.first_rad - to.first_rad) / turn_rad);
        there.first_turns += static_cast<int>(turns);
        to.first_rad += turn_rad * turns;
      }
      const double first_rad = std::abs(to.first_rad - from.first_rad);
      const double second_rad = std::abs(to.second_rad - from.second_rad);
      const double time_s = std::max(first_rad / speeds_.rotary_rad_s[0],
                                     second_rad / speeds_.rotary_rad_s[1]);
      const bool same = merged && first_rad <= 1e-6 && second_rad <= 4.0 * merged_rad;
      there.cost_s = base_s + time_s + (same ? 0.0 : retract_s(point));
      if (there.cost_s >= reached_[state].cost_s || !admissible(state, there, point)) continue;
      reached_[state] = there;
      repositioned_.push_back({static_cast<std::uint32_t>(off_pole_.size()),
                               static_cast<std::uint8_t>(state), static_cast<std::uint8_t>(best)});
    }
  }

  bool any_reached() const {
    return std::any_of(reached_.begin(), reached_.end(),
                       [](const Reached& reached) { return reached.cost_s != infinite; });
  }

  void push_back_row() { rows_.insert(rows_.end(), from_.begin(), from_.end()); }

  Problem out_of_range(std::uint32_t point) const;
  Result<AxisPath> path_at_pole() const;
  AxisPath trace_back();

  struct Repositioned {
    std::uint32_t row;
    std::uint8_t to, from;
  };
  /// The chosen states at one off-pole point.
  struct Chosen {
    std::uint8_t arrival;    ///< state in which the path comes
    std::uint8_t departure;  ///< state in which it goes on
    bool inside;             ///< it came by way of a cut inside the move
  };
  std::vector<Chosen> chosen_states() const;
  AxisPath empty_path() const;

  const Model& model_;
  const JointRanges& ranges_;
  const path::ToolPath& tool_path_;
  const Candidates& candidates_;
  const Settings& settings_;
  const double gauge_length_mm_;
  const bool check_linear_;
  const OrderingSpeeds speeds_;
  const StateSpace space_;

  std::vector<Reached> reached_, next_;
  std::vector<std::uint8_t> from_;         ///< predecessor of each state at the point in hand
  std::vector<std::uint8_t> rows_;         ///< from_ of every off-pole point
  std::vector<Repositioned> repositioned_;  ///< in order of their rows
  std::vector<std::uint32_t> off_pole_;
  std::array<Vec3, 2> linear_{Vec3::Zero(), Vec3::Zero()}, linear_before_{linear_};
  std::array<bool, 2> linear_ok_{true, true};
};

std::vector<Chooser::Chosen> Chooser::chosen_states() const {
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

AxisPath Chooser::empty_path() const {
  AxisPath path;
  path.range = candidates_.range;
  path.pole = candidates_.pole;
  path.arrival.resize(candidates_.pole.size());
  path.branch.resize(candidates_.pole.size(), AxisPath::at_rest);
  return path;
}

/// Follows the chosen states from the start and writes values and turns down.
AxisPath Chooser::trace_back() {
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
        Reached there = with_turns(chosen[row].arrival, 0.0);
        const RotaryPair out = near_endless(chosen[row].arrival, there, passage, point, in);
        passage.write(in, out, space_.states[left].branch, state.branch, path);
        turns = there;
      } else if (chosen[row].inside) {
        const Reached there = with_turns(chosen[row].arrival, 0.0);
        path.departures.push_back({before,
                                   {},
                                   true,
                                   true,
                                   turn_rad * (there.first_turns - turns.first_turns)});
        turns.first_turns = there.first_turns;
      } else if (link == Link::broken) {
        turns = with_turns(chosen[row].arrival, 0.0);
        // The repositioning belongs to the point before, with the values of the branch there.
        path.departures.push_back({before, pair_of(chosen[row].arrival, turns, point), true});
      }
    }
    path.arrival[point - begin] = pair_of(chosen[row].arrival, turns, point);
    path.branch[point - begin] = static_cast<std::uint8_t>(state.branch);
    if (chosen[row].departure != chosen[row].arrival) {
      const RotaryPair from = path.arrival[point - begin];
      Reached there = with_turns(chosen[row].departure, 0.0);
      RotaryPair to = pair_of(chosen[row].departure, there, point);
      if (space_.first_endless) {
        there.first_turns += static_cast<int>(std::round((from.first_rad - to.first_rad) / turn_rad));
        to = pair_of(chosen[row].departure, there, point);
      }
      turns = there;
      const bool moves = std::abs(to.first_rad - from.first_rad) > 1e-6 ||
                         std::abs(to.second_rad - from.second_rad) > 1e-6;
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
Result<AxisPath> Chooser::path_at_pole() const {
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
        return Problem{
            .code = Code::rotary_range,
            .message = model_.rotary_names[1] + " = " +
                       number_text(pair.second_rad * deg_per_rad, 3) + " deg lies outside " +
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
Problem Chooser::out_of_range(std::uint32_t point) const {
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

}  // namespace

JointRanges joint_ranges(const machine::Chain& chain, const Model& model) {
  JointRanges ranges;
  const auto look_at = [&](const machine::Joint& joint) {
    if (const auto* rotary = std::get_if<machine::RotaryJoint>(&joint.kind)) {
      const std::size_t index = joint.name == model.rotary_names[0] ? 0 : 1;
      if (rotary->range)
        ranges.rotary_rad[index] = {rotary->range->lower.rad(), rotary->range->upper.rad()};
      return;
    }
    const auto place =
        std::find(model.linear_names.begin(), model.linear_names.end(), joint.name);
    ranges.linear_mm[static_cast<std::size_t>(place - model.linear_names.begin())] =
        std::get<machine::LinearJoint>(joint.kind).range_mm;
  };
  std::for_each(chain.table().begin(), chain.table().end(), look_at);
  std::for_each(chain.head().begin(), chain.head().end(), look_at);
  return ranges;
}

OrderingSpeeds ordering_speeds(const Model& model, const Settings& settings) {
  constexpr double assumed_rad_s = 30.0 * rad_per_deg;
  constexpr double assumed_mm_s = 250.0;
  const auto speed_of = [&](const std::string& name, double assumed) {
    const auto found = settings.limits.find(name);
    return found == settings.limits.end() ? assumed : found->second.max_speed.value_or(assumed);
  };
  OrderingSpeeds speeds;
  for (std::size_t i = 0; i < 3; ++i)
    speeds.linear_mm_s[static_cast<Eigen::Index>(i)] = speed_of(model.linear_names[i], assumed_mm_s);
  for (std::size_t i = 0; i < 2; ++i)
    speeds.rotary_rad_s[i] = speed_of(model.rotary_names[i], assumed_rad_s);
  return speeds;
}

Result<AxisPath> choose_branches(const Model& model, const JointRanges& ranges,
                                 const path::ToolPath& tool_path, const Candidates& candidates,
                                 const Settings& settings, double gauge_length_mm,
                                 bool check_linear) {
  return Chooser{model, ranges, tool_path, candidates, settings, gauge_length_mm, check_linear}
      .run();
}

}  // namespace pentapost::plan
