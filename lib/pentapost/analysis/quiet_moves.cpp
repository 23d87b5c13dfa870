#include "pentapost/analysis/quiet_moves.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::analysis {
namespace {

/// Chords up to this are the angle but for the factor.
constexpr double largest_chord = 0.4;
constexpr double angle_per_chord = 1.01;

}  // namespace

QuietMoves::QuietMoves(const kinematics::Model& model, const plan::Settings& settings,
                       const Allowance& allowance, double gauge_length_mm)
    : model_{model},
      origin_from_a_mm_{settings.origin_mm - model.a_point_mm},
      least_ratio_{std::min(1.0, allowance.share)},
      first_s_per_rad_{allowance.time_per_way_s[first_axis]},
      second_s_per_rad_{allowance.time_per_way_s[second_axis]},
      linear_s_per_mm_{*std::max_element(allowance.time_per_way_s.begin(),
                                         allowance.time_per_way_s.begin() + first_axis) *
                       model.fixed.linear_inverse.norm()},
      cos_lambda_cos_mu_{std::cos(model.lambda_rad) * std::cos(model.mu_rad)},
      sin_lambda_{std::sin(model.lambda_rad)},
      sin_lambda_sin_mu_{sin_lambda_ * std::sin(model.mu_rad)},
      b_from_a_mm_{(model.b_point_mm - model.a_point_mm).norm()},
      tool_arm_mm_{model.b_point_mm.norm() + std::abs(gauge_length_mm)} {}

// cos(gamma) = cos(lambda) cos(mu) + sin(lambda) sin(mu) cos(B) bounds B by how far the tool axis
// can get from where it is, and so bounds both rates by those of the inverse.
bool QuietMoves::is_quiet(const Vec3& tip_mm, const Vec3& axis_from, const Vec3& axis_to,
                          double length_mm, double time_s) const {
  if (model_.rotary_count != 2 || model_.fixed.linear_place < 0) return false;
  const double chord = (axis_to - axis_from).norm();
  if (chord == 0.0) return is_within(0.0, 0.0, tip_mm, length_mm, time_s);
  if (!(chord <= largest_chord)) return false;
  const double turn_rad = angle_per_chord * chord;
  const double cos_gamma = model_.fixed.a_drawn.dot(axis_from);
  const double sin_gamma = std::sqrt(std::max(0.0, 1.0 - cos_gamma * cos_gamma)) + turn_rad;
  const double cos_b = std::abs((cos_gamma - cos_lambda_cos_mu_) / sin_lambda_sin_mu_) +
                       turn_rad * sin_gamma / sin_lambda_sin_mu_;
  const double sin_b_square = 1.0 - cos_b * cos_b;
  if (!(sin_b_square > 0.0)) return false;
  const double per_sin_b = turn_rad / std::sqrt(sin_b_square);
  return is_within(per_sin_b / sin_lambda_, per_sin_b * sin_gamma / sin_lambda_sin_mu_, tip_mm,
                   length_mm, time_s);
}

bool QuietMoves::is_within(double first_rad, double second_rad, const Vec3& tip_mm,
                           double length_mm, double time_s) const {
  const double most_s = least_ratio_ * time_s;
  if (!(first_rad * first_s_per_rad_ <= most_s && second_rad * second_s_per_rad_ <= most_s))
    return false;
  const double tip_arm_mm = (tip_mm + origin_from_a_mm_).norm() + length_mm;
  const int place = model_.fixed.linear_place;
  const double first_arm_mm = place > 0 ? tip_arm_mm : b_from_a_mm_ + tool_arm_mm_;
  const double second_arm_mm = place > 1 ? tip_arm_mm + b_from_a_mm_ : tool_arm_mm_;
  const double way_mm = length_mm + first_rad * first_arm_mm + second_rad * second_arm_mm;
  return way_mm * linear_s_per_mm_ <= most_s;
}

}  // namespace pentapost::analysis
