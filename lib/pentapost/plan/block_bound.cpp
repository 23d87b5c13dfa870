#include "pentapost/plan/block_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pentapost::plan {
namespace {

/// Largest of |s (s - 1/2) (s - 1)| / 6 on [0, 1]: what a third derivative of 1 adds to the
/// quadratic through both ends and the middle; for the norm of a vector in space.
constexpr double cubic_remainder = 0.00802;

double cube(double x) { return x * x * x; }
double square(double x) { return x * x; }

/// Bound of the quadratic through three deviations, at the ends and in the middle.
double quadratic_bound(const Vec3& at_start, const Vec3& at_middle, const Vec3& at_end) {
  return std::max(at_start.norm(), at_end.norm()) + (at_middle - 0.5 * (at_start + at_end)).norm();
}

double chord_to_angle_rad(double chord) { return chord < 2.0 ? 2.0 * std::asin(0.5 * chord) : pi; }

/// How far the quadratic through three errors along a straight way goes beyond its ends.
double beyond_ends_mm(const std::array<double, 3>& ahead_mm, double length_mm) {
  const double sag_mm = ahead_mm[1] - 0.5 * (ahead_mm[0] + ahead_mm[2]);
  const double even_mm = length_mm + ahead_mm[2] - ahead_mm[0];
  double beyond_mm = std::max({0.0, -ahead_mm[0], ahead_mm[2]});
  if (const double turn = (even_mm + 4.0 * sag_mm) / (8.0 * sag_mm); turn > 0.0 && turn < 1.0) {
    const double there_mm = ahead_mm[0] + turn * even_mm + 4.0 * sag_mm * turn * (1.0 - turn);
    beyond_mm = std::max({beyond_mm, -there_mm, there_mm - length_mm});
  }
  return beyond_mm;
}

/// Distance that the digits printed leave open.
double printed_resolution_mm(int decimals_mm) {
  return 0.5 * std::sqrt(3.0) * std::pow(10.0, -decimals_mm);
}

/// Third derivative of the tip in a joint-linear block (Output::axes).
double tip_third_derivative(const kinematics::Model& model, double gauge_mm, double first_rad,
                            double second_rad, const Posture& from, const Posture& to) {
  const double turn_rad = first_rad + second_rad;
  const double reach_mm = std::max(from.linear_mm.norm(), to.linear_mm.norm()) +
                          (model.a_point_mm - model.b_point_mm).norm() + model.b_point_mm.norm() +
                          std::abs(gauge_mm);
  return square(turn_rad) * (turn_rad * reach_mm + 3.0 * (to.linear_mm - from.linear_mm).norm());
}

}  // namespace

BlockBound bound_block(const kinematics::Model& model, const Settings& settings,
                       const BlockMaker& maker, const path::Segment& segment, double fraction_from,
                       const Posture& from, double fraction_to, const Posture& to) {
  const double share = fraction_to - fraction_from;
  const double fraction_middle = 0.5 * (fraction_from + fraction_to);
  const double first_rad = std::abs(to.printed.first_rad - from.printed.first_rad);
  const double second_rad = std::abs(to.printed.second_rad - from.printed.second_rad);
  const bool rotary_still = first_rad == 0.0 && second_rad == 0.0;
  const double axis_turn_rad = share * segment.axis_angle_rad();

  BlockBound bound;
  const Vec3 axis_error_from = from.axis - segment.axis(fraction_from);
  const Vec3 axis_error_to = to.axis - segment.axis(fraction_to);
  if (rotary_still) {
    const double chord =
        std::max(axis_error_from.norm(), axis_error_to.norm()) + square(axis_turn_rad) / 8.0;
    bound.axis_rad = chord_to_angle_rad(chord);
    if (!segment.is_arc()) {
      // Both ways are straight: the ends are the worst.
      bound.tip_mm = std::max((from.tip_mm - segment.tip_mm(fraction_from)).norm(),
                              (to.tip_mm - segment.tip_mm(fraction_to)).norm());
      return bound;
    }
  }

  const Posture middle = maker.middle(from, to);
  if (!rotary_still) {
    const Vec3 axis_error_middle = middle.axis - segment.axis(fraction_middle);
    const double sine_gamma = std::min(
        1.0, std::max(model.a.cross(from.axis).norm(), model.a.cross(to.axis).norm()) + second_rad);
    const double third = cube(first_rad) * sine_gamma + 3.0 * square(first_rad) * second_rad +
                         3.0 * first_rad * square(second_rad) + cube(second_rad) +
                         cube(axis_turn_rad);
    bound.axis_rad =
        chord_to_angle_rad(quadratic_bound(axis_error_from, axis_error_middle, axis_error_to) +
                           cubic_remainder * third);
  }

  std::array<Vec3, 3> tip_error{from.tip_mm - segment.tip_mm(fraction_from),
                                middle.tip_mm - segment.tip_mm(fraction_middle),
                                to.tip_mm - segment.tip_mm(fraction_to)};
  double third_mm = 0.0;
  if (settings.output == Output::axes && !rotary_still)
    third_mm =
        tip_third_derivative(model, maker.gauge_in_words_mm(), first_rad, second_rad, from, to);
  if (segment.is_arc()) {
    const double swept_rad = share * segment.sweep_rad();
    third_mm += cube(swept_rad) * segment.largest_radius_mm();
  }
  const double length_mm = share * segment.length_mm();
  double beyond_mm = 0.0, ahead_mm = 0.0;
  if (!segment.is_arc() && segment.length_mm() > 0.0) {
    // What lies across the straight way is a deviation, and what goes beyond its ends; what lies
    // along it delays the axis.
    const Vec3 along = (segment.tip_to_mm() - segment.tip_from_mm()) / segment.length_mm();
    std::array<double, 3> ahead{};
    for (std::size_t i = 0; i < 3; ++i) {
      ahead[i] = along.dot(tip_error[i]);
      tip_error[i] -= ahead[i] * along;
    }
    beyond_mm = beyond_ends_mm(ahead, length_mm);
    ahead_mm = std::max(std::abs(ahead[0]), std::abs(ahead[2])) +
               std::abs(ahead[1] - 0.5 * (ahead[0] + ahead[2])) + cubic_remainder * third_mm;
  }
  bound.tip_mm = std::hypot(quadratic_bound(tip_error[0], tip_error[1], tip_error[2]), beyond_mm) +
                 cubic_remainder * third_mm;
  // On a circle the whole deviation can delay, by up to a quarter turn for its radius; what leaves
  // the circle by more is nearest to any place of it, and jumps from one end to the other.
  if (segment.is_arc()) ahead_mm = 0.5 * pi * bound.tip_mm;
  const bool jumps = segment.is_arc() && !(bound.tip_mm < segment.smallest_radius_mm());
  if (settings.output == Output::axes && segment.length_mm() > 0.0) {
    const double unknown_mm = std::max(0.0, ahead_mm - printed_resolution_mm(settings.decimals_mm));
    const double delay = length_mm > 0.0 ? std::min(1.0, unknown_mm / length_mm) : 1.0;
    bound.axis_rad += axis_turn_rad * (jumps ? 2.0 : delay);
  }
  return bound;
}

}  // namespace pentapost::plan
