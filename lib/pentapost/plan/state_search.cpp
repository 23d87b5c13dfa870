#include "pentapost/plan/state_search.hpp"

#include "pentapost/kinematics/inverse.hpp"
#include "pentapost/plan/choice_costs.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pentapost::plan {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double turn_rad = 2.0 * pi;
/// Openings from which the two branches are one: both ends of the triangle.
constexpr double merged_rad = 1e-7;

}  // namespace

StateSearch::StateSearch(const kinematics::Model& model, const JointRanges& ranges,
                         const path::ToolPath& tool_path, const Candidates& candidates,
                         const Settings& settings, double gauge_length_mm, bool check_linear)
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

Result<AxisPath> StateSearch::run() {
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
  if (before + 1 < candidates_.range.end) {
    end_at_pole(before);
    if (!any_reached()) return out_of_range(before);
  }
  return trace_back();
}

std::uint8_t StateSearch::pole_of(std::uint32_t point) const {
  return candidates_.pole[point - candidates_.range.begin];
}

Vec3 StateSearch::tip_table(std::uint32_t point) const {
  return tool_path_.tip_wp_mm[point] + settings_.origin_mm;
}

RotaryPair StateSearch::pair_of(std::size_t state, const Reached& reached,
                                std::uint32_t point) const {
  const int branch = space_.states[state].branch;
  return {candidates_.first_of(point, branch) + turn_rad * reached.first_turns,
          candidates_.second_of(model_, point, branch) + turn_rad * reached.second_turns};
}

Reached StateSearch::with_turns(std::size_t state, std::uint32_t point, double cost_s) const {
  const State& taken = space_.states[state];
  return {cost_s, space_.first_turns(taken, candidates_.first_of(point, taken.branch)),
          taken.second_turns};
}

void StateSearch::look_at(std::uint32_t point) {
  for (int branch = 0; branch < candidates_.branches; ++branch) {
    const auto index = static_cast<std::size_t>(branch);
    const auto linear =
        kinematics::inverse_linear(model_, tip_table(point), candidates_.first_of(point, branch),
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

bool StateSearch::admissible(std::size_t state, const Reached& reached, std::uint32_t point) const {
  if (!linear_ok_[static_cast<std::size_t>(space_.states[state].branch)]) return false;
  return in_rotary_ranges(pair_of(state, reached, point));
}

bool StateSearch::in_rotary_ranges(const RotaryPair& pair) const {
  return in_range(ranges_.rotary_rad[0], pair.first_rad) &&
         in_range(ranges_.rotary_rad[1], pair.second_rad);
}

void StateSearch::begin(std::uint32_t point) {
  std::optional<PolePassage> from_pole;
  if (point > candidates_.range.begin)
    from_pole.emplace(model_, tool_path_, candidates_, std::nullopt, point);
  from_.resize(reached_.size());
  for (std::size_t state = 0; state < reached_.size(); ++state) {
    from_[state] = static_cast<std::uint8_t>(state);
    Reached& start = reached_[state];
    start = started(state, point);
    const RotaryPair pair = pair_of(state, start, point);
    const int branch = space_.states[state].branch;
    if (!admissible(state, start, point) ||
        (from_pole && !in_rotary_ranges(from_pole->pair_out(pair, branch))))
      start.cost_s = infinite;
  }
  push_back_row();
}

void StateSearch::end_at_pole(std::uint32_t before) {
  const PolePassage to_pole{model_, tool_path_, candidates_, before, std::nullopt};
  for (std::size_t state = 0; state < reached_.size(); ++state) {
    if (reached_[state].cost_s == infinite) continue;
    const RotaryPair pair = pair_of(state, reached_[state], before);
    if (!in_rotary_ranges(to_pole.pair_in(pair, space_.states[state].branch)))
      reached_[state].cost_s = infinite;
  }
}

Reached StateSearch::started(std::size_t state, std::uint32_t point) const {
  const auto window = start_window_rad(settings_.preferences);
  Reached start = with_turns(state, point, 0.0);
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

Status StateSearch::go_on(std::uint32_t before, std::uint32_t point) {
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

double StateSearch::step_time_s(std::uint32_t before, std::uint32_t point, int branch) const {
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

double StateSearch::retract_s(std::uint32_t point) const {
  const bool air = tool_path_.move[point] == path::Move::rapid ||
                   point + 1 == candidates_.range.end ||
                   tool_path_.move[point + 1] == path::Move::rapid;
  return air ? retract_in_air_s : retract_in_cut_s;
}

void StateSearch::step(std::uint32_t before, std::uint32_t point) {
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

void StateSearch::take_over_inside(std::uint32_t before, std::uint32_t point,
                                   std::vector<Reached>& next) {
  for (std::size_t from = 0; from < reached_.size(); ++from) {
    if (reached_[from].cost_s == infinite || next[from].cost_s != infinite) continue;
    for (std::size_t to = 0; to < reached_.size(); ++to) {
      const State &left = space_.states[from], &taken = space_.states[to];
      if (taken.branch != left.branch || taken.second_turns != left.second_turns || from == to)
        continue;
      Reached there =
          with_turns(to, point, reached_[from].cost_s + retract_in_cut_s + inside_move_s);
      there.second_turns = reached_[from].second_turns;
      if (there.cost_s >= next[to].cost_s || !admissible(to, there, point)) continue;
      // Both must be within range at the same place on the way: the limit that `from` meets.
      const double to_before = pair_of(to, there, before).first_rad;
      const double from_after = pair_of(from, reached_[from], point).first_rad;
      const auto& range = *ranges_.rotary_rad[0];
      const double limit = from_after > range.upper ? range.upper : range.lower;
      const double taken_there =
          limit + turn_rad * (there.first_turns - reached_[from].first_turns);
      if (in_range(range, to_before) || !in_range(range, taken_there)) continue;
      next[to] = there;
      from_[to] = static_cast<std::uint8_t>(from | inside_bit);
    }
  }
}

void StateSearch::pass_pole(std::uint32_t before, std::uint32_t point) {
  const PolePassage passage{model_, tool_path_, candidates_, before, point};
  next_.assign(reached_.size(), Reached{});
  from_.assign(reached_.size(), 0);
  for (std::size_t to = 0; to < reached_.size(); ++to) {
    for (std::size_t from = 0; from < reached_.size(); ++from) {
      if (reached_[from].cost_s == infinite) continue;
      const RotaryPair in =
          passage.pair_in(pair_of(from, reached_[from], before), space_.states[from].branch);
      Reached there = with_turns(to, point, 0.0);
      const RotaryPair out = near_endless(to, there, passage, point, in);
      if (std::abs(out.second_rad - in.second_rad) > merged_rad || !in_rotary_ranges(in) ||
          !in_rotary_ranges(out))
        continue;
      there.cost_s = reached_[from].cost_s + passage.turn_cost_s(in, out, speeds_.rotary_rad_s[0]);
      if (there.cost_s >= next_[to].cost_s || !admissible(to, there, point)) continue;
      next_[to] = there;
      from_[to] = static_cast<std::uint8_t>(from);
    }
  }
  reached_.swap(next_);
  push_back_row();
}

RotaryPair StateSearch::near_endless(std::size_t to, Reached& there, const PolePassage& passage,
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

void StateSearch::turn_about(std::uint32_t point) {
  from_.assign(reached_.size(), 0);
  std::size_t best = 0;
  for (std::size_t state = 0; state < reached_.size(); ++state)
    if (reached_[state].cost_s < reached_[best].cost_s) best = state;
  const double cost_s = reached_[best].cost_s + retract_in_air_s;
  for (std::size_t state = 0; state < reached_.size(); ++state) {
    from_[state] = static_cast<std::uint8_t>(best);
    reached_[state] = with_turns(state, point, cost_s);
    if (!admissible(state, reached_[state], point)) reached_[state].cost_s = infinite;
  }
  push_back_row();
}

void StateSearch::reposition(std::uint32_t point) {
  std::size_t best = 0;
  for (std::size_t state = 1; state < reached_.size(); ++state)
    if (reached_[state].cost_s < reached_[best].cost_s) best = state;
  if (reached_.empty() || reached_[best].cost_s == infinite) return;
  const double opening_rad =
      std::abs(candidates_.second_rad[point - candidates_.range.begin] - model_.beta_zero_rad);
  const bool merged =
      candidates_.branches == 2 && (opening_rad <= merged_rad || opening_rad >= pi - merged_rad);
  const RotaryPair from = pair_of(best, reached_[best], point);
  const double base_s = reached_[best].cost_s;
  for (std::size_t state = 0; state < reached_.size(); ++state) {
    if (state == best) continue;
    Reached there = with_turns(state, point, 0.0);
    RotaryPair to = pair_of(state, there, point);
    if (space_.first_endless) {
      const double turns = std::round((from.first_rad - to.first_rad) / turn_rad);
      there.first_turns += static_cast<int>(turns);
      to.first_rad += turn_rad * turns;
    }
    const double first_rad = std::abs(to.first_rad - from.first_rad);
    const double second_rad = std::abs(to.second_rad - from.second_rad);
    const double time_s =
        std::max(first_rad / speeds_.rotary_rad_s[0], second_rad / speeds_.rotary_rad_s[1]);
    const bool same = merged && first_rad <= 1e-6 && second_rad <= 4.0 * merged_rad;
    there.cost_s = base_s + time_s + (same ? 0.0 : retract_s(point));
    if (there.cost_s >= reached_[state].cost_s || !admissible(state, there, point)) continue;
    reached_[state] = there;
    repositioned_.push_back({static_cast<std::uint32_t>(off_pole_.size()),
                             static_cast<std::uint8_t>(state), static_cast<std::uint8_t>(best)});
  }
}

bool StateSearch::any_reached() const {
  return std::any_of(reached_.begin(), reached_.end(),
                     [](const Reached& reached) { return reached.cost_s != infinite; });
}

void StateSearch::push_back_row() { rows_.insert(rows_.end(), from_.begin(), from_.end()); }

}  // namespace pentapost::plan
