#include "pentapost/plan/pole_passage.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pentapost::plan {
namespace {

constexpr double turn_rad = 2.0 * pi;

double nearest_turn(double value_rad, double reference_rad) {
  return value_rad + turn_rad * std::round((reference_rad - value_rad) / turn_rad);
}

}  // namespace

PolePassage::PolePassage(const kinematics::Model& model, const path::ToolPath& tool_path,
                         const Candidates& candidates, std::optional<std::uint32_t> before,
                         std::optional<std::uint32_t> after)
    : model_{model},
      tool_path_{tool_path},
      candidates_{candidates},
      before_{before},
      after_{after},
      first_{before ? *before + 1 : candidates.range.begin},
      end_{after ? *after : candidates.range.end} {
  if (first_ < end_) {
    pole_ = candidates.pole[first_ - candidates.range.begin];
  } else {
    const auto found =
        std::lower_bound(candidates.crossings.begin(), candidates.crossings.end(), *after,
                         [](const Candidates::Crossing& crossing, std::uint32_t point) {
                           return crossing.point < point;
                         });
    crossing_ = *found;
    pole_ = crossing_->pole;
  }
  for (int branch = 0; branch < candidates.branches; ++branch) {
    const auto index = static_cast<std::size_t>(branch);
    if (before)
      first_in_rad_[index] = first_at_pole_rad(model, pole_, tool_path.axis_wp[*before], branch);
    if (after)
      first_out_rad_[index] = first_at_pole_rad(model, pole_, tool_path.axis_wp[*after], branch);
  }
}

RotaryPair PolePassage::pair_in(const RotaryPair& pair_before, int branch) const {
  return {nearest_turn(first_in_rad_[static_cast<std::size_t>(branch)], pair_before.first_rad),
          second_at_pole_rad(model_, pole_, branch) + pair_before.second_rad -
              candidates_.second_of(model_, *before_, branch)};
}

RotaryPair PolePassage::pair_out(const RotaryPair& pair_after, int branch) const {
  return {nearest_turn(first_out_rad_[static_cast<std::size_t>(branch)], pair_after.first_rad),
          second_at_pole_rad(model_, pole_, branch) + pair_after.second_rad -
              candidates_.second_of(model_, *after_, branch)};
}

double PolePassage::turn_cost_s(const RotaryPair& in, const RotaryPair& out,
                                double speed_rad_s) const {
  return std::abs(out.first_rad - in.first_rad) / speed_rad_s;
}

/// Share of the turn that the move to `point`, between two points at the pole, can take.
double PolePassage::weight(std::uint32_t point, bool air) const {
  const path::Move move = tool_path_.move[point];
  if (air) return move == path::Move::rapid ? 1.0 : 0.0;
  if (move != path::Move::feed) return 0.0;
  const auto event = std::lower_bound(tool_path_.events.begin(), tool_path_.events.end(), point,
                                      [](const path::Event& candidate, std::uint32_t index) {
                                        return candidate.before_point < index;
                                      });
  for (auto it = event; it != tool_path_.events.end() && it->before_point == point; ++it)
    if (std::holds_alternative<path::Arc>(it->what)) return 0.0;
  return (tool_path_.tip_wp_mm[point] - tool_path_.tip_wp_mm[point - 1]).norm();
}

void PolePassage::write(const RotaryPair& in, const RotaryPair& out, int branch_in, int branch_out,
                        AxisPath& axis_path) const {
  const std::uint32_t begin = axis_path.range.begin;
  if (after_) axis_path.branch[*after_ - begin] = static_cast<std::uint8_t>(branch_out);
  if (crossing_) {
    axis_path.crossings.push_back({*after_, crossing_->fraction, pole_, in, out,
                                   static_cast<std::uint8_t>(branch_in),
                                   static_cast<std::uint8_t>(branch_out)});
    return;
  }
  std::vector<double> weights(end_ - first_, 0.0);
  for (const bool air : {true, false}) {
    for (std::uint32_t point = first_ + 1; point < end_; ++point)
      weights[point - first_] = weight(point, air);
    if (std::any_of(weights.begin(), weights.end(), [](double w) { return w > 0.0; })) break;
  }
  const double whole = std::accumulate(weights.begin(), weights.end(), 0.0);
  double done = 0.0;
  for (std::uint32_t point = first_; point < end_; ++point) {
    done += weights[point - first_];
    const double share = whole > 0.0 ? done / whole : 0.0;
    RotaryPair& pair = axis_path.arrival[point - begin];
    pair = in;
    pair.first_rad += share * (out.first_rad - in.first_rad);
    axis_path.branch[point - begin] = AxisPath::at_rest;
  }
  if (before_) axis_path.branch[first_ - begin] = static_cast<std::uint8_t>(branch_in);
  if (whole > 0.0) {
    axis_path.arrival[end_ - 1 - begin] = out;
  } else if (in != out) {
    for (std::uint32_t point = first_; point < end_; ++point)
      if (point > first_) axis_path.arrival[point - begin] = out;
    axis_path.departures.push_back({first_, out, false});
  }
}

}  // namespace pentapost::plan
