#include "pentapost/reorient/path_loads.hpp"

#include "pentapost/reorient/motions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pentapost::reorient {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double same_angle_rad = 1e-12;

/// Of the angle between the pole and the tool axis in a piece.
Range<double> cosines_of(const Piece& piece, const Vec3& pole) {
  const double cosine = pole.dot(piece.middle.axis);
  const double speed_rad_s = piece.middle.turn_rad_s.norm();
  if (speed_rad_s == 0.0) return {cosine, cosine};
  const double half_rad = 0.5 * piece.time_s * speed_rad_s;
  const double sine =
      std::abs(pole.dot(piece.middle.turn_rad_s.cross(piece.middle.axis))) / speed_rad_s;
  const double half_sine = std::sin(half_rad), half_cosine = std::cos(half_rad);
  const bool turns_inside = sine * half_cosine < std::abs(cosine) * half_sine;
  const double most = std::sqrt(cosine * cosine + sine * sine);
  return {turns_inside && cosine < 0.0 ? -most : cosine * half_cosine - sine * half_sine,
          turns_inside && cosine > 0.0 ? most : cosine * half_cosine + sine * half_sine};
}

/// The third of a piece about a time from its middle.
Piece third_of(const Piece& piece, double from_middle_s) {
  Piece third = piece;
  third.middle = piece.at(from_middle_s);
  third.time_s = piece.time_s / 3.0;
  return third;
}

RateBounds without_linear(RateBounds bounds) {
  std::fill(bounds.lower.begin(), bounds.lower.begin() + first_axis, 0.0);
  bounds.least_linear_mm_s = 0.0;
  return bounds;
}

}  // namespace

PathLoads::PathLoads(const kinematics::Model& model, std::vector<ToolPieces> tools,
                     const Limits& limits)
    : model_{model},
      has_pole_{std::abs(model.lambda_rad - model.mu_rad) < same_angle_rad},
      has_two_poles_{has_pole_ && std::abs(model.lambda_rad + model.mu_rad - pi) < same_angle_rad},
      limits_{limits} {
  for (ToolPieces& tool : tools) {
    for (const Piece& piece : tool.pieces) programmed_time_s_ += piece.time_s;
    tools_.push_back({AxisRates{model, tool.gauge_length_mm}, PieceTree{std::move(tool.pieces)},
                      std::move(tool.stations)});
  }
}

/// The clamping whose pole is `away_rad` off the nominal one, in a direction counted round it.
Clamping PathLoads::moved(const Clamping& nominal, double away_rad, double direction_rad) {
  Eigen::Index smallest = 0;
  nominal.pole.cwiseAbs().minCoeff(&smallest);
  const Vec3 aside = nominal.pole.cross(Vec3::Unit(smallest)).normalized();
  const Vec3 about = Eigen::AngleAxisd{direction_rad, nominal.pole}.toRotationMatrix() * aside;
  const Mat3 turn = Eigen::AngleAxisd{away_rad, about}.toRotationMatrix();
  return {nominal.to_table * turn.transpose(), turn * nominal.pole,
          turn * nominal.origin_from_a_mm};
}

Clampings PathLoads::clampings(const Clamping& nominal, double accuracy_rad) const {
  Clampings all{.nominal = nominal, .about = {}, .accuracy_rad = accuracy_rad};
  for (int i = 0; i < directions && accuracy_rad > 0.0; ++i)
    all.about.push_back(moved(nominal, accuracy_rad, 2.0 * pi * i / directions));
  return all;
}

Extremes PathLoads::extremes(const Clamping& clamping, const Extremes& likely) const {
  Extremes found;
  double least_cosine = 2.0, most_cosine = -2.0;
  const auto may_be_farther = [&](const Vec3& axis, double cosine_about, double sine_about) {
    const double cosine = clamping.pole.dot(axis);
    const double aside = std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) * sine_about;
    const double most = cosine >= cosine_about ? 1.0 : cosine * cosine_about + aside;
    const double least = -cosine >= cosine_about ? -1.0 : cosine * cosine_about - aside;
    return most > most_cosine || least < least_cosine;
  };
  const auto take = [&](std::uint32_t tool, std::uint32_t piece) {
    const auto cosines = cosines_of(tools_[tool].tree.pieces()[piece], clamping.pole);
    if (cosines.upper > most_cosine) {
      most_cosine = cosines.upper;
      found.least_tool = tool;
      found.least_piece = piece;
    }
    if (cosines.lower < least_cosine) {
      least_cosine = cosines.lower;
      found.most_tool = tool;
      found.most_piece = piece;
    }
  };
  if (tools_.empty()) return found;
  take(likely.least_tool, likely.least_piece);
  take(likely.most_tool, likely.most_piece);
  for (std::uint32_t tool = 0; tool < tools_.size(); ++tool)
    descend(
        tools_[tool].tree,
        [&](const PieceTree::Node& node) {
          return may_be_farther(node.group.centre.axis, node.group.axis_cosine,
                                node.group.axis_sine);
        },
        [&](std::uint32_t piece) { take(tool, piece); });
  // The angles themselves keep their digits at a pole.
  const auto gammas_at = [&](std::uint32_t tool, std::uint32_t index) {
    const Piece& piece = tools_[tool].tree.pieces()[index];
    return gammas(piece.middle, clamping.pole, -piece.half_turn_rad(), piece.half_turn_rad());
  };
  found.least_rad = gammas_at(found.least_tool, found.least_piece).lower;
  found.most_rad = gammas_at(found.most_tool, found.most_piece).upper;
  return found;
}

bool PathLoads::has_linear_ranges() const {
  return limits_.check_linear &&
         std::any_of(limits_.ranges.linear_mm.begin(), limits_.ranges.linear_mm.end(),
                     [](const auto& range) { return range.has_value(); });
}

/// Whether the second axis can have an opening of that range on the branch within its own.
bool PathLoads::may_be_within(int branch, Range<double> opening_rad) const {
  const auto& range = limits_.ranges.rotary_rad[1];
  if (!range) return true;
  const double lower =
      model_.beta_zero_rad + (branch == 0 ? opening_rad.lower : -opening_rad.upper);
  const double upper =
      model_.beta_zero_rad + (branch == 0 ? opening_rad.upper : -opening_rad.lower);
  const double turns = std::ceil((range->lower - upper) / (2.0 * pi));
  return lower + 2.0 * pi * turns <= range->upper;
}

Branches PathLoads::branches(const Extremes& found) const {
  Branches serve{false, false};
  if (tools_.empty() || found.least_rad > found.most_rad) return {true, true};
  const AxisRates& rates = tools_.front().rates;
  const auto opening = [&](double gamma_rad) {
    for (const double change : {0.0, -limits_.slack_rad, limits_.slack_rad})
      if (const auto found_rad = rates.opening_rad(gamma_rad + change)) return found_rad;
    return std::optional<double>{};
  };
  const auto least = opening(found.least_rad), most = opening(found.most_rad);
  if (!least || !most) return serve;
  for (const int branch : {0, 1})
    serve[static_cast<std::size_t>(branch)] =
        may_be_within(branch, {*least, *least}) && may_be_within(branch, {*most, *most});
  return serve;
}

int PathLoads::branch_of(const Branches& branches) const {
  const auto preferred = static_cast<std::size_t>(limits_.preferred_branch);
  return branches[preferred] || !branches[1 - preferred] ? limits_.preferred_branch
                                                         : 1 - limits_.preferred_branch;
}

Branches PathLoads::possible_branches(const Clamping& clamping, const Extremes& found,
                                      const Spread& spread) const {
  constexpr Branches both{true, true};
  if (tools_.empty() || found.least_rad > found.most_rad) return both;
  const double change = spread.pole_rad + limits_.slack_rad;
  const auto branch = limits_.rule.settled(tools_.front().rates,
                                           {found.least_rad - change, found.most_rad + change},
                                           clamping.origin_from_a_mm.norm() + spread.origin_mm);
  if (!branch || (has_linear_ranges() && !keeps_to_linear_ranges(clamping, *branch, spread)))
    return both;
  return {*branch == 0, *branch == 1};
}

bool PathLoads::keeps_to_linear_ranges(const Clamping& clamping, int branch,
                                       const Spread& spread) const {
  bool keeps = true;
  for (const Tool& tool : tools_) {
    const auto may_leave = [&](const ToolMotion& motion, const Spread& of_motion) {
      Spread both = together(of_motion, spread);
      both.axis_rad += limits_.slack_rad;
      const auto linear = tool.rates.linear_mm(motion, clamping, branch);
      return !linear || !(excess_mm(*linear, tool.rates.linear_change_mm(motion, clamping, branch,
                                                                         both)) <= 0.0);
    };
    descend(
        tool.tree,
        [&](const PieceTree::Node& node) {
          return keeps && may_leave(node.group.centre, node.group.spread);
        },
        [&](std::uint32_t index) {
          const Piece& piece = tool.tree.pieces()[index];
          keeps = keeps && !may_leave(piece.middle, spread_of(piece));
        });
  }
  return keeps;
}

/// By how much a joint leaves its range where all may be changed by so much.
double PathLoads::excess_mm(const Vec3& linear_mm, const Vec3& change_mm) const {
  double excess = -infinite;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& range = limits_.ranges.linear_mm[i];
    const auto row = static_cast<Eigen::Index>(i);
    if (range)
      excess = std::max(excess, change_mm[row] + std::max(range->lower - linear_mm[row],
                                                          linear_mm[row] - range->upper));
  }
  return excess;
}

PathLoads::WorstPlace PathLoads::worst_place(const Clamping& clamping, int branch) const {
  WorstPlace worst;
  if (!limits_.check_linear) return worst;
  for (std::uint32_t tool_index = 0; tool_index < tools_.size(); ++tool_index) {
    const Tool& tool = tools_[tool_index];
    descend(
        tool.tree,
        [&](const PieceTree::Node& node) {
          const auto linear = tool.rates.linear_mm(node.group.centre, clamping, branch);
          if (!linear) return true;
          const Vec3 change =
              tool.rates.linear_change_mm(node.group.centre, clamping, branch, node.group.spread);
          return excess_mm(*linear, change) > worst.excess_mm;
        },
        [&](std::uint32_t index) {
          const ToolMotion& motion = tool.tree.pieces()[index].middle;
          const auto linear = tool.rates.linear_mm(motion, clamping, branch);
          // At a singularity the first axis is free.
          if (!linear || tool.rates.singularity_distance_rad(
                             angle_between_rad(clamping.pole, motion.axis)) <= limits_.slack_rad)
            return;
          const double excess = excess_mm(*linear, Vec3::Zero());
          if (excess > worst.excess_mm) worst = {excess, tool_index, index};
        });
  }
  return worst;
}

bool PathLoads::is_out_of_linear_range(const WorstPlace& place, const Clamping& clamping,
                                       const Spread& spread) const {
  if (!(place.excess_mm > 0.0)) return false;
  const Tool& tool = tools_[place.tool];
  const ToolMotion& motion = tool.tree.pieces()[place.piece].middle;
  Spread changed = spread;
  changed.axis_rad += limits_.slack_rad;
  for (const int branch : {0, 1}) {
    const auto linear = tool.rates.linear_mm(motion, clamping, branch);
    if (!linear) return false;
    const Vec3 change = tool.rates.linear_change_mm(motion, clamping, branch, changed);
    if (!(excess_mm(*linear, -change) > 0.0)) return false;
  }
  return true;
}

double PathLoads::ratio(const PerAxis& rates) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < axis_count; ++i)
    if (limits_.shares.time_per_way_s[i] > 0.0)
      largest = std::max(largest, rates[i] * limits_.shares.time_per_way_s[i]);
  return largest;
}

double PathLoads::least_ratio(const RateBounds& bounds) const {
  // One of three axes has at least this part of their speed.
  const double share = 1.0 / std::sqrt(3.0);
  const PerAxis& time_s = limits_.shares.time_per_way_s;
  return std::max(ratio(bounds.lower),
                  share * bounds.least_linear_mm_s * std::min({time_s[0], time_s[1], time_s[2]}));
}

/// Largest at the ends, in the middle and where the tool axis is nearest to the pole.
PathLoads::PieceRatio PathLoads::ratio_of_piece(const Tool& tool, const Piece& piece,
                                                const Clamping& clamping, int branch,
                                                double at_least) const {
  PieceRatio largest;
  const auto take = [&](double from_middle_s) {
    const auto found = tool.rates.ratio(piece.at(from_middle_s), clamping, branch, limits_.shares);
    if (found && *found > largest.ratio) largest = {*found, from_middle_s};
  };
  take(0.0);
  const double half_s = 0.5 * piece.time_s, speed_rad_s = piece.middle.turn_rad_s.norm();
  if (speed_rad_s == 0.0) return largest;
  // About what a ratio changes by in so small a piece.
  constexpr double largest_slope = 4.0;
  const double sin_gamma = clamping.pole.cross(piece.middle.axis).norm();
  if (tool.rates.has_equal_branches() &&
      largest.ratio * (1.0 + largest_slope * half_s * speed_rad_s / sin_gamma) < at_least)
    return largest;
  take(-half_s);
  take(half_s);
  const Vec3 along = piece.middle.turn_rad_s.cross(piece.middle.axis) / speed_rad_s;
  const double nearest =
      std::atan(clamping.pole.dot(along) / clamping.pole.dot(piece.middle.axis)) / speed_rad_s;
  if (std::abs(nearest) < half_s) take(nearest);
  return largest;
}

bool PathLoads::meets_singularity(const Tool& tool, const Piece& piece, const Clamping& clamping,
                                  double within_rad) const {
  const double half_rad = piece.half_turn_rad();
  if (half_rad == 0.0 || tool.rates.is_far_from_singularity(clamping.pole.dot(piece.middle.axis),
                                                            half_rad + within_rad))
    return false;
  const auto range = gammas(piece.middle, clamping.pole, -half_rad, half_rad);
  const double at_ends = std::min(tool.rates.singularity_distance_rad(range.lower),
                                  tool.rates.singularity_distance_rad(range.upper));
  return at_ends <= within_rad || tool.rates.has_singularity_between(range);
}

bool PathLoads::meets_singularity(const PeakPlace& place, const Clamping& clamping,
                                  double within_rad) const {
  const Tool& tool = tools_[place.tool];
  return limits_.shares.time_per_way_s[first_axis] > 0.0 &&
         meets_singularity(tool, tool.tree.pieces()[place.piece], clamping, within_rad);
}

Peak PathLoads::peak(const Clampings& clampings, int branch, double tolerance,
                     std::span<const PeakPlace> likely) const {
  Peak found;
  Spread about;
  about.pole_rad = about.turn_rad = clampings.accuracy_rad;
  about.origin_mm = clampings.accuracy_rad * clampings.nominal.origin_from_a_mm.norm();
  const auto raise = [&](double ratio, const PeakPlace& place) {
    if (ratio > found.ratio) found = {ratio, place};
  };
  const auto take = [&](std::uint32_t tool_index, std::uint32_t index) {
    const Tool& tool = tools_[tool_index];
    const Piece& piece = tool.tree.pieces()[index];
    const PieceRatio nominal = ratio_of_piece(tool, piece, clampings.nominal, branch, found.ratio);
    raise(nominal.ratio, {tool_index, index, 0});
    if (clampings.about.empty()) return;
    if (limits_.shares.time_per_way_s[first_axis] > 0.0 &&
        meets_singularity(tool, piece, clampings.nominal, clampings.accuracy_rad))
      return raise(infinite, {tool_index, index, 0});
    // By thirds, which are bounded closer than the whole.
    const double ratio = (1.0 + tolerance) * found.ratio, aside_s = piece.time_s / 3.0;
    const auto may_exceed = [&](const MotionGroup& group) {
      return tool.rates.may_exceed(ratio, group, clampings.nominal, branch, about, limits_.shares);
    };
    if (!may_exceed(group_of(third_of(piece, 0.0))) &&
        !may_exceed(group_of(third_of(piece, -aside_s))) &&
        !may_exceed(group_of(third_of(piece, aside_s))))
      return;
    for (std::uint32_t i = 0; i < clampings.about.size(); ++i)
      raise(ratio_of_piece(tool, piece, clampings.about[i], branch, found.ratio).ratio,
            {tool_index, index, i + 1});
  };
  for (const PeakPlace& place : likely) take(place.tool, place.piece);
  for (std::uint32_t tool_index = 0; tool_index < tools_.size(); ++tool_index) {
    const Tool& tool = tools_[tool_index];
    const auto may_be_higher = [&](const MotionGroup& group) {
      return tool.rates.may_exceed((1.0 + tolerance) * found.ratio, group, clampings.nominal,
                                   branch, about, limits_.shares);
    };
    descend(
        tool.tree, [&](const PieceTree::Node& node) { return may_be_higher(node.group); },
        [&](std::uint32_t index) {
          const Piece& piece = tool.tree.pieces()[index];
          if (piece.time_s > 0.0 && may_be_higher(group_of(piece))) take(tool_index, index);
        });
  }
  if (found.place && found.place->clamping > 0 && std::isfinite(found.ratio))
    found.ratio = std::max(found.ratio, largest_about(*found.place, clampings, branch));
  return found;
}

/// Of a place, between the directions next to the one that has been found, where it rises and falls
/// once.
double PathLoads::largest_about(const PeakPlace& place, const Clampings& clampings,
                                int branch) const {
  constexpr int steps = 12;
  const Tool& tool = tools_[place.tool];
  const Piece& piece = tool.tree.pieces()[place.piece];
  const auto at = [&](double direction_rad) {
    return ratio_of_piece(tool, piece,
                          moved(clampings.nominal, clampings.accuracy_rad, direction_rad), branch,
                          0.0)
        .ratio;
  };
  const double step_rad = 2.0 * pi / directions;
  double from = (place.clamping - 2.0) * step_rad, to = place.clamping * step_rad;
  for (int i = 0; i < steps; ++i) {
    const double third = (to - from) / 3.0;
    if (at(from + third) < at(to - third))
      from += third;
    else
      to -= third;
  }
  return at(0.5 * (from + to));
}

bool PathLoads::is_impossible(const Clamping& clamping, const Extremes& found,
                              const Spread& spread) const {
  if (tools_.empty()) return false;
  const AxisRates& rates = tools_.front().rates;
  if (found.least_rad > found.most_rad) return false;
  const double change = spread.pole_rad + limits_.slack_rad;
  const auto is_out = [&](double gamma_rad) {
    const auto openings = rates.openings_rad({gamma_rad - change, gamma_rad + change});
    return !openings || (!may_be_within(0, *openings) && !may_be_within(1, *openings));
  };
  if (is_out(found.least_rad) || is_out(found.most_rad)) return true;
  // One place that is out on both branches: on the way the path may change its branch.
  return limits_.check_linear &&
         (is_out_of_linear_range(worst_place(clamping, 0), clamping, spread) ||
          is_out_of_linear_range(worst_place(clamping, 1), clamping, spread));
}

double PathLoads::least_ratio(const PeakPlace& place, const Clamping& clamping,
                              const Spread& spread, const Branches& branches) const {
  const Tool& tool = tools_[place.tool];
  const Piece& piece = tool.tree.pieces()[place.piece];
  const auto whole_move = gammas_of_move(piece, clamping.pole);
  // Near a singularity the tool axis may be changed.
  const double aside_rad = spread.pole_rad + limits_.slack_rad;
  if (piece.half_turn_rad() > 0.0 &&
      (tool.rates.has_singularity_between(whole_move) ||
       std::min(tool.rates.singularity_distance_rad(whole_move.lower),
                tool.rates.singularity_distance_rad(whole_move.upper)) <= aside_rad))
    return 0.0;
  double least = infinite;
  for (const int branch : {0, 1}) {
    if (!branches[static_cast<std::size_t>(branch)]) continue;
    double largest = 0.0;
    const auto take = [&](double from_middle_s) {
      RateBounds bounds = tool.rates.bounds(piece.at(from_middle_s), clamping, branch, spread);
      if (!piece.is_straight && from_middle_s != 0.0) bounds = without_linear(bounds);
      largest = std::max(largest, least_ratio(bounds));
    };
    take(0.0);
    if (piece.half_turn_rad() > 0.0) {
      take(-0.5 * piece.time_s);
      take(0.5 * piece.time_s);
    }
    least = std::min(least, largest);
  }
  return PathLoads::sure_share * least;
}

}  // namespace pentapost::reorient
