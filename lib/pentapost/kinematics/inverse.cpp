#include "pentapost/kinematics/inverse.hpp"

#include "pentapost/kinematics/linear_solve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pentapost::kinematics {
namespace {

/// What rounding may put a tool axis beyond the reach: some ten units in the last place.
constexpr double rounding_rad = 1e-14;
/// Sine below which two unit vectors are parallel: their rounding.
constexpr double parallel_sine = 1e-15;

/// The tool axis seen along a: its shadow on p and q.
using Shadow = Eigen::Vector2d;

/// Angle from one shadow to another, right-handed about a.
double angle_rad(const Shadow& from, const Shadow& to) {
  return std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
}

/// Sine and cosine of half an angle.
struct HalfAngle {
  double sine, cosine;
};

/// From equal multiples of the sine (>= 0) and the cosine of the whole angle, all digits kept.
HalfAngle half_of(double sine_multiple, double cosine_multiple) {
  const double length =
      std::sqrt(sine_multiple * sine_multiple + cosine_multiple * cosine_multiple);
  const double larger = std::sqrt(0.5 * (1.0 + std::abs(cosine_multiple) / length));
  const double smaller = sine_multiple / (2.0 * length * larger);
  return cosine_multiple < 0.0 ? HalfAngle{larger, smaller} : HalfAngle{smaller, larger};
}

/// The half-angle formula of section 2, with each sine written as that of a sum or a difference of
/// gamma / 2 and a fixed angle. Beyond the reach the angle at b stays at its end, 0 or pi.
HalfAngle half_opening(const Model::Fixed& fixed, const HalfAngle& gamma) {
  const double x = gamma.sine * fixed.cos_half_difference;
  const double y = gamma.cosine * fixed.sin_half_difference;
  const double z = gamma.cosine * fixed.sin_half_sum;
  const double w = gamma.sine * fixed.cos_half_sum;
  const double sine_square = std::max(0.0, (x + y) * (x - y));    // sin(s - lambda) sin(s - mu)
  const double cosine_square = std::max(0.0, (z + w) * (z - w));  // sin s sin(s - gamma)
  const double length = std::sqrt(sine_square + cosine_square);
  return {std::sqrt(sine_square) / length, std::sqrt(cosine_square) / length};
}

/// Two rotary joints: the triangle with sides lambda, mu, gamma.
RotarySolutions solve_triangle(const Model& model, const Vec3& axis, double slack_rad) {
  const Model::Fixed& fixed = model.fixed;
  const Shadow shadow{fixed.p.dot(axis), fixed.q.dot(axis)};
  const double sin_gamma = shadow.norm();
  const double cos_gamma = fixed.a_drawn.dot(axis);

  RotarySolutions found;
  found.gamma_rad = std::atan2(sin_gamma, cos_gamma);
  found.beyond_rad = std::max(std::abs(model.lambda_rad - model.mu_rad) - found.gamma_rad,
                              found.gamma_rad - (model.lambda_rad + model.mu_rad));
  if (!(found.beyond_rad <= slack_rad + rounding_rad)) return found;

  const HalfAngle opening = half_opening(fixed, half_of(sin_gamma, cos_gamma));
  found.count = 2;
  found.opening_rad = 2.0 * std::atan2(opening.sine, opening.cosine);
  found.branch[0].second_rad = model.beta_zero_rad + found.opening_rad;
  found.branch[1].second_rad = model.beta_zero_rad - found.opening_rad;
  found.first_is_free = sin_gamma <= parallel_sine;
  if (found.first_is_free) return found;

  const Shadow middle = fixed.start + 2.0 * opening.sine * opening.sine * fixed.turned_half;
  const Shadow aside = 2.0 * opening.sine * opening.cosine * fixed.turned_quarter;
  found.branch[0].first_rad = angle_rad(middle + aside, shadow);
  found.branch[1].first_rad = angle_rad(middle - aside, shadow);
  return found;
}

/// One rotary joint carries the tool axis round a cone; none leaves it where it is.
RotarySolutions solve_cone(const Model& model, const Vec3& axis, double slack_rad) {
  const Model::Fixed& fixed = model.fixed;
  RotarySolutions found;
  found.opening_rad = pi / 2.0;
  if (model.rotary_count == 0) {
    found.gamma_rad = angle_between_rad(model.t, axis);
    found.beyond_rad = found.gamma_rad;
  } else {
    found.gamma_rad = angle_between_rad(model.a, axis);
    found.beyond_rad = std::abs(found.gamma_rad - model.lambda_rad);
  }
  if (!(found.beyond_rad <= slack_rad + rounding_rad)) return found;
  found.count = 1;
  if (model.rotary_count == 0) return found;

  const Shadow shadow{fixed.p.dot(axis), fixed.q.dot(axis)};
  found.first_is_free = fixed.start.norm() <= parallel_sine || shadow.norm() <= parallel_sine;
  if (!found.first_is_free) found.branch[0].first_rad = angle_rad(fixed.start, shadow);
  return found;
}

/// All linear joints in one place of the chain: what turns before it is undone, what turns beyond
/// it is done, and the directions are those at zero.
Vec3 solve_in_one_place(const Model& model, const Vec3& tip_mm, const Turns& turn,
                        double gauge_length_mm) {
  const int place = model.fixed.linear_place;
  const Vec3 b_from_a_mm = model.b_point_mm - model.a_point_mm;
  Vec3 tool_mm = -model.b_point_mm - gauge_length_mm * model.t;
  if (place < 2) tool_mm = turn.second(tool_mm) + b_from_a_mm;
  if (place < 1) tool_mm = turn.first(tool_mm);
  Vec3 wanted_mm = tip_mm - model.a_point_mm;
  if (place > 0) wanted_mm = turn.undo_first(wanted_mm);
  if (place > 1) wanted_mm = turn.undo_second(wanted_mm - b_from_a_mm);

  const auto directions_at_zero = static_cast<std::size_t>(place);
  const Vec3 target_mm = wanted_mm - tool_mm;
  const Vec3 linear_mm = model.fixed.linear_inverse * target_mm;
  const Vec3 left_mm = target_mm - model.linear_columns[directions_at_zero] * linear_mm;
  return linear_mm + model.fixed.linear_inverse * left_mm;
}

}  // namespace

RotarySolutions inverse_rotary(const Model& model, const Vec3& axis, double slack_rad) {
  return model.rotary_count == 2 ? solve_triangle(model, axis, slack_rad)
                                 : solve_cone(model, axis, slack_rad);
}

RotaryInside inverse_rotary_inside(const Model& model, const Vec3& axis, int branch) {
  const Model::Fixed& fixed = model.fixed;
  const Shadow shadow{fixed.p.dot(axis), fixed.q.dot(axis)};
  RotaryInside found;
  found.sin_gamma = shadow.norm();
  const HalfAngle opening = half_opening(fixed, half_of(found.sin_gamma, fixed.a_drawn.dot(axis)));
  found.opening_rad = 2.0 * std::atan2(opening.sine, opening.cosine);
  const Shadow middle = fixed.start + 2.0 * opening.sine * opening.sine * fixed.turned_half;
  const Shadow aside = 2.0 * opening.sine * opening.cosine * fixed.turned_quarter;
  found.first_rad =
      angle_rad(branch == 0 ? Shadow{middle + aside} : Shadow{middle - aside}, shadow);
  return found;
}

std::optional<Vec3> inverse_linear(const Model& model, const Vec3& tip_mm, double first_rad,
                                   double second_rad, double gauge_length_mm) {
  return inverse_linear(model, tip_mm, Turns{model, first_rad, second_rad}, gauge_length_mm);
}

std::optional<Vec3> inverse_linear(const Model& model, const Vec3& tip_mm, const Turns& turn,
                                   double gauge_length_mm) {
  if (model.fixed.linear_place >= 0)
    return solve_in_one_place(model, tip_mm, turn, gauge_length_mm);
  return solve_linear(model, turn.linear_matrix(),
                      tip_mm - turn.tip_without_linear_mm(gauge_length_mm));
}

}  // namespace pentapost::kinematics
