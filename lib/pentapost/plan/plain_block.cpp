#include "pentapost/plan/plain_block.hpp"

#include "pentapost/plan/linearise.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::plan {

PlainBlock::PlainBlock(const kinematics::Model& model, const Settings& settings,
                       const BlockMaker& maker)
    : model_{model},
      settings_{settings},
      arms_mm_{(model.a_point_mm - model.b_point_mm).norm() + model.b_point_mm.norm() +
               std::abs(maker.gauge_in_words_mm())},
      stretch_{
          std::sqrt((model.linear_columns[0] + model.linear_columns[1] + model.linear_columns[2])
                        .squaredNorm())},
      resolution_mm_{0.5 * std::sqrt(3.0) * std::pow(10.0, -settings.decimals_mm)} {}

/// Second derivative of the tip where all joints run evenly: turned arms, and linear ways that
/// turn.
double PlainBlock::tip_curvature_mm(double turn_rad, const Posture& from, const Posture& to) const {
  const double reach_mm =
      stretch_ * std::max(from.linear_mm.norm(), to.linear_mm.norm()) + arms_mm_;
  return turn_rad * (turn_rad * reach_mm + 2.0 * stretch_ * (to.linear_mm - from.linear_mm).norm());
}

// A difference whose second derivative is at most K leaves the line between its ends by K / 8.
bool PlainBlock::suffices(const ClMove& move, const Posture& from, const Posture& to) const {
  constexpr double angle_per_chord = 1.05;  // 2 asin(1/2) = 1.0472, for chords up to 1
  const double first_rad = std::abs(to.printed.first_rad - from.printed.first_rad);
  const double second_rad = std::abs(to.printed.second_rad - from.printed.second_rad);
  const double turn_rad = first_rad + second_rad;
  const double turn_chord = (move.axis_to - move.axis_from).norm();
  if (!(turn_chord <= 1.0) || !(turn_rad <= 1.0)) return false;
  const double cl_turn_rad = angle_per_chord * turn_chord;

  double tip_mm = std::sqrt(std::max((from.tip_mm - move.tip_from_mm).squaredNorm(),
                                     (to.tip_mm - move.tip_to_mm).squaredNorm()));
  double chord = std::sqrt(
      std::max((from.axis - move.axis_from).squaredNorm(), (to.axis - move.axis_to).squaredNorm()));
  const double sine_gamma = std::min(
      1.0, std::max(model_.a.cross(from.axis).norm(), model_.a.cross(to.axis).norm()) + second_rad);
  chord += (first_rad * first_rad * sine_gamma + 2.0 * first_rad * second_rad +
            second_rad * second_rad + cl_turn_rad * cl_turn_rad) /
           8.0;
  if (settings_.output == Output::axes && turn_rad > 0.0) {
    tip_mm += tip_curvature_mm(turn_rad, from, to) / 8.0;
    // The tip may be ahead of the axis or behind it.
    const double ahead_mm = std::max(0.0, tip_mm - resolution_mm_);
    chord += cl_turn_rad * (move.length_mm > 0.0 ? std::min(1.0, ahead_mm / move.length_mm) : 1.0);
  }
  return tip_mm <= tolerance_share * settings_.tip_tolerance_mm && chord <= 1.0 &&
         angle_per_chord * chord <= tolerance_share * settings_.axis_tolerance_rad;
}

}  // namespace pentapost::plan
