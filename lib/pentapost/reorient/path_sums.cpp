#include "pentapost/reorient/path_loads.hpp"

#include "pentapost/reorient/motions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pentapost::reorient {
namespace {

/// Bounds whose quotient is below this are one value.
constexpr double close_enough = 1.001;

/// So many that the turn of each does not outweigh `fine_rad`; an arc's tip has one motion only.
int parts_of(const Piece& piece, double fine_rad) {
  constexpr double most = 8.0;
  if (!piece.is_straight || !(piece.half_turn_rad() > fine_rad)) return 1;
  return static_cast<int>(
      std::clamp(std::ceil(piece.half_turn_rad() / std::max(fine_rad, 1e-9)), 1.0, most));
}

}  // namespace

bool PathLoads::is_near_singularity(const Extremes& found, double within_rad,
                                    double change_rad) const {
  if (tools_.empty()) return false;
  const AxisRates& rates = tools_.front().rates;
  const Range<double> inside{found.least_rad + change_rad, found.most_rad - change_rad};
  return (inside.lower <= inside.upper && rates.has_singularity_between(inside)) ||
         std::min(rates.singularity_distance_rad(found.least_rad),
                  rates.singularity_distance_rad(found.most_rad)) <= within_rad - change_rad;
}

/// One of the branches where both have the same rotary speeds and nothing else counts.
Branches PathLoads::one_if_equal(const Branches& branches) const {
  const bool is_equal = !tools_.empty() && tools_.front().rates.has_equal_branches();
  return is_equal ? Branches{true, false} : branches;
}

/// Least sum of `part` over all pieces.
/// @param part  of a time and bounds of the rates in it: the least it adds, and whether that is all
///        that there is to know.
template <class Part>
double PathLoads::least_sum(const Clamping& clamping, const Spread& spread,
                            const Branches& branches, const Part& part) const {
  constexpr double fine_share = 0.5;
  double total = 0.0;
  for (const Tool& tool : tools_) {
    const auto least = [&](const ToolMotion& motion, const Spread& of_motion, double time_s) {
      const Spread both = together(of_motion, spread);
      const int one = branches[0] ? 0 : 1;
      const auto first = part(time_s, tool.rates.bounds(motion, clamping, one, both));
      if (!branches[0] || !branches[1]) return first;
      const auto second = part(time_s, tool.rates.bounds(motion, clamping, 1, both));
      return std::pair{std::min(first.first, second.first), first.second && second.second};
    };
    descend(
        tool.tree,
        [&](const PieceTree::Node& node) {
          if (node.time_s == 0.0) return false;
          const double gamma_rad = angle_between_rad(clamping.pole, node.group.centre.axis);
          if (tool.rates.singularity_distance_rad(gamma_rad) <=
              node.group.spread.axis_rad + node.farthest_turn_rad + spread.pole_rad +
                  limits_.slack_rad)
            return true;
          const auto [adds, is_all] = least(node.group.centre, node.group.spread, node.time_s);
          if (!is_all && node.group.spread.axis_rad > fine_share * spread.pole_rad) return true;
          total += adds;
          return false;
        },
        [&](std::uint32_t index) {
          const Piece& piece = tool.tree.pieces()[index];
          const auto whole_move = gammas_of_move(piece, clamping.pole);
          const double aside_rad = spread.pole_rad + limits_.slack_rad;
          // Near a singularity the tool axis may be changed.
          if (std::min(tool.rates.singularity_distance_rad(whole_move.lower),
                       tool.rates.singularity_distance_rad(whole_move.upper)) <= aside_rad ||
              tool.rates.has_singularity_between(whole_move)) {
            total += part(piece.time_s, RateBounds{}).first;
            return;
          }
          const int parts = parts_of(piece, fine_share * spread.pole_rad);
          Piece part_of_piece = piece;
          part_of_piece.time_s = piece.time_s / parts;
          for (int i = 0; i < parts; ++i) {
            part_of_piece.middle = piece.at(((i + 0.5) / parts - 0.5) * piece.time_s);
            total +=
                least(part_of_piece.middle, spread_of(part_of_piece), part_of_piece.time_s).first;
          }
        });
  }
  return sure_share * total;
}

double PathLoads::least_time_s(const Clamping& clamping, const Spread& spread,
                               const Branches& branches) const {
  // What is not slowed down takes its time, to the last digit.
  const double least = least_sum(
      clamping, spread, limits_.shares.has_linear ? branches : one_if_equal(branches),
      [&](double time_s, const RateBounds& bounds) {
        return std::pair{time_s * std::max(1.0, least_ratio(bounds)), !(ratio(bounds.upper) > 1.0)};
      });
  return std::max(programmed_time_s_, least);
}

double PathLoads::least_travel_rad(const Clamping& clamping, const Spread& spread,
                                   const Branches& branches) const {
  return least_sum(clamping, spread, one_if_equal(branches),
                   [&](double time_s, const RateBounds& bounds) {
                     const double lower = bounds.lower[first_axis] + bounds.lower[second_axis];
                     const double upper = bounds.upper[first_axis] + bounds.upper[second_axis];
                     return std::pair{time_s * lower, upper <= close_enough * lower};
                   });
}

/// Sum of `part` over all pieces, each divided until it is even enough.
template <class Part>
double PathLoads::sum(const Clamping& clamping, int branch, double tolerance,
                      const Part& part) const {
  constexpr int most_levels = 8;
  /// Of the distance to a singularity, below which the rate in the middle stands for all.
  constexpr double small_share = 0.05;
  double total = 0.0;
  for (const Tool& tool : tools_) {
    // From a time to another, from the middle.
    const auto add = [&](const auto& self, const Piece& piece, double from_s, double to_s,
                         int level) -> void {
      const double middle_s = 0.5 * (from_s + to_s), half_s = 0.5 * (to_s - from_s);
      const ToolMotion motion = piece.at(middle_s);
      const double distance_rad =
          tool.rates.singularity_distance_rad(angle_between_rad(clamping.pole, motion.axis));
      if (half_s * motion.turn_rad_s.norm() <= small_share * distance_rad || level >= most_levels) {
        const auto rates = tool.rates.at(motion, clamping, branch);
        total += (to_s - from_s) * (rates ? part(*rates, *rates).first : part({}, {}).first);
        return;
      }
      self(self, piece, from_s, middle_s, level + 1);
      self(self, piece, middle_s, to_s, level + 1);
    };
    descend(
        tool.tree,
        [&](const PieceTree::Node& node) {
          if (node.time_s == 0.0) return false;
          const RateBounds bounds =
              tool.rates.bounds(node.group.centre, clamping, branch, node.group.spread);
          const auto [lower, upper] = part(bounds.lower, bounds.upper);
          if (!(upper <= (1.0 + 2.0 * tolerance) * lower)) return true;
          total += node.time_s * 0.5 * (lower + upper);
          return false;
        },
        [&](std::uint32_t index) {
          const Piece& piece = tool.tree.pieces()[index];
          add(add, piece, -0.5 * piece.time_s, 0.5 * piece.time_s, 0);
        });
  }
  return total;
}

template <class Part>
double PathLoads::largest_sum(const Clampings& clampings, int branch, double tolerance,
                              const Part& part) const {
  double largest = sum(clampings.nominal, branch, tolerance, part);
  if (!is_near_singularity(extremes(clampings.nominal, {}),
                           near_accuracies * clampings.accuracy_rad, 0.0))
    return largest;
  for (const Clamping& each : clampings.about)
    largest = std::max(largest, sum(each, branch, tolerance, part));
  return largest;
}

double PathLoads::time_s(const Clampings& clampings, int branch, double tolerance) const {
  return largest_sum(clampings, branch, tolerance, [&](const PerAxis& lower, const PerAxis& upper) {
    return std::pair{std::max(1.0, ratio(lower)), std::max(1.0, ratio(upper))};
  });
}

double PathLoads::travel_rad(const Clampings& clampings, int branch, double tolerance) const {
  return largest_sum(clampings, branch, tolerance, [](const PerAxis& lower, const PerAxis& upper) {
    return std::pair{lower[first_axis] + lower[second_axis],
                     upper[first_axis] + upper[second_axis]};
  });
}

}  // namespace pentapost::reorient
