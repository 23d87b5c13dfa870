#include "pentapost/reorient/axis_rates.hpp"

#include "pentapost/reorient/posture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pentapost::reorient {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

double AxisRates::frame_change(const Freedom& freedom, const Spread& spread) const {
  return place_ == 2 ? freedom.tool_rad : place_ == 1 ? freedom.rotary_rad : spread.turn_rad;
}

/// By sums of angles and upper bounds of their functions, without any of these.
bool AxisRates::may_exceed_right_angled(double ratio, const MotionGroup& group,
                                        const Clamping& clamping, const Spread& about,
                                        const SpeedShares& shares) const {
  const double about_sine = about.pole_rad, about_cosine = 1.0 - 0.5 * about_sine * about_sine;
  const double sine = group.axis_sine + group.axis_cosine * about_sine;
  const double cosine = group.axis_cosine * about_cosine - group.axis_sine * about_sine;
  const Vec3 normal = clamping.pole.cross(group.centre.axis);
  const double sin_gamma_square = normal.squaredNorm(), sin_gamma = std::sqrt(sin_gamma_square);
  const double cos_gamma = std::abs(clamping.pole.dot(group.centre.axis));
  const double least_sine = sin_gamma * cosine - cos_gamma * sine;
  if (!(cosine > 0.0 && sin_gamma > sine && least_sine > 0.0)) return true;
  const Vec3 axis_rate = group.centre.turn_rad_s.cross(group.centre.axis);
  const double rate = axis_rate.norm();
  const double change =
      group.spread.turn_rad_s + group.centre.turn_rad_s.norm() * group.spread.axis_rad;
  const double share = sine / sin_gamma;
  const double turned = share * (1.0 + 0.58 * share * share) + group.spread.axis_rad;
  const double first =
      std::min(std::abs(axis_rate.dot(normal)) / sin_gamma + rate * turned + change,
               group.largest_turn_rad_s) /
      least_sine;
  const double second = std::min(
      (std::abs(axis_rate.dot(clamping.pole)) + rate * about.pole_rad + change) / least_sine,
      group.largest_turn_rad_s);
  const PerAxis& time_s = shares.time_per_way_s;
  if (first * time_s[first_axis] > ratio || second * time_s[second_axis] > ratio) return true;
  if (!shares.has_linear) return false;
  const double tip_mm = (group.centre.tip_mm + clamping.origin_from_a_mm).norm() +
                        group.spread.tip_mm + about.origin_mm;
  const double second_arm_mm = place_ == 2 ? tip_mm + b_from_a_mm_ : tool_mm_;
  const double first_arm_mm = place_ == 0 ? b_from_a_mm_ + tool_mm_ : tip_mm;
  const double speed_mm_s = group.largest_tip_mm_s + first * first_arm_mm + second * second_arm_mm;
  for (std::size_t i = 0; i < first_axis; ++i)
    if (speed_mm_s * row_norms_[static_cast<Eigen::Index>(i)] * time_s[i] > ratio) return true;
  return false;
}

bool AxisRates::may_exceed(double ratio, const MotionGroup& group, const Clamping& clamping,
                           int branch, const Spread& about, const SpeedShares& shares) const {
  if (is_right_angled_ && place_ >= 0) {
    if (!may_exceed_right_angled(ratio, group, clamping, about, shares)) return false;
    if (!shares.has_linear) return true;
  }
  Spread spread = group.spread;
  spread.pole_rad = about.pole_rad;
  spread.turn_rad = about.turn_rad;
  spread.origin_mm = about.origin_mm;
  const RateBounds found = bounds(group.centre, clamping, branch, spread);
  for (std::size_t i = 0; i < axis_count; ++i)
    if (shares.time_per_way_s[i] > 0.0 && found.upper[i] * shares.time_per_way_s[i] > ratio)
      return true;
  return false;
}

/// Of the angle between the sides `near` and gamma of the triangle, whose third side is `far`.
double AxisRates::largest_corner_change(double gamma_rad, double low_rad, double high_rad,
                                        double cos_near, double cos_far, double sin_near) const {
  const auto corner_rad = [&](double at_rad) {
    return angle_of_cosine_rad((cos_far - std::cos(at_rad) * cos_near) /
                               (std::sin(at_rad) * sin_near));
  };
  const double here_rad = corner_rad(gamma_rad);
  double change_rad =
      std::max(std::abs(corner_rad(low_rad) - here_rad), std::abs(corner_rad(high_rad) - here_rad));
  // The corner is largest or smallest where cos(gamma) = cos(near) / cos(far).
  if (std::abs(cos_near) < std::abs(cos_far)) {
    const double turning_rad = angle_of_cosine_rad(cos_near / cos_far);
    if (turning_rad > low_rad && turning_rad < high_rad)
      change_rad = std::max(change_rad, std::abs(corner_rad(turning_rad) - here_rad));
  }
  return change_rad;
}

AxisRates::Freedom AxisRates::freedom(const Posture& posture, const Spread& spread) const {
  Freedom free;
  const double apart_rad = spread.pole_rad + spread.axis_rad;
  const double low_rad = std::max(0.0, posture.gamma_rad - apart_rad);
  const double high_rad = std::min(pi, posture.gamma_rad + apart_rad);
  const double sin_product = sin_lambda_ * sin_mu_;
  const double highest = (std::cos(low_rad) - cos_lambda_ * cos_mu_) / sin_product;
  const double lowest = (std::cos(high_rad) - cos_lambda_ * cos_mu_) / sin_product;
  const double volume_low = volume(low_rad), volume_high = volume(high_rad);
  free.may_be_reached = highest >= -1.0 && lowest <= 1.0;
  free.largest_volume =
      lowest <= 0.0 && highest >= 0.0 ? sin_product : std::max(volume_low, volume_high);
  free.least_sin_a = is_right_angled_ ? 1.0 : 0.0;
  free.largest_sin_gamma = low_rad <= 0.5 * pi && high_rad >= 0.5 * pi
                               ? 1.0
                               : std::max(std::sin(low_rad), std::sin(high_rad));
  if (!(highest < 1.0 && lowest > -1.0 && low_rad > 0.0 && high_rad < pi)) return free;
  free.smallest_volume = std::min(volume_low, volume_high);
  const double sine = std::sin(apart_rad) / posture.sin_gamma;
  if (!(apart_rad < 0.5 * pi && sine < 1.0)) return free;
  const double about_rad = std::asin(sine);
  double at_tool_rad = 0.0, at_pole_rad = 0.0;
  if (!is_right_angled_) {
    at_tool_rad =
        largest_corner_change(posture.gamma_rad, low_rad, high_rad, cos_mu_, cos_lambda_, sin_mu_);
    at_pole_rad = largest_corner_change(posture.gamma_rad, low_rad, high_rad, cos_lambda_, cos_mu_,
                                        sin_lambda_);
    // By the sine rule.
    const double sin_a = std::abs(posture.volume) / (sin_lambda_ * posture.sin_gamma);
    free.least_sin_a = std::max(0.0, sin_a - at_pole_rad);
  }
  free.b_rad = std::min(2.0, spread.axis_rad + sin_mu_ * (about_rad + at_tool_rad));
  free.tool_rad = std::min(2.0, spread.axis_rad + about_rad + at_tool_rad);
  free.rotary_rad = std::min(2.0, spread.pole_rad + about_rad + at_pole_rad);
  return free;
}

RateBounds AxisRates::bounds(const ToolMotion& motion, const Clamping& clamping, int branch,
                             const Spread& spread) const {
  RateBounds bounds;
  bounds.upper.fill(infinite);
  const auto found = posture(motion, clamping, branch);
  const double turn_rad_s = motion.turn_rad_s.norm() + spread.turn_rad_s;
  const bool turns = turn_rad_s > 0.0;
  if (!found) {
    if (turns) return bounds;
    bounds.upper[first_axis] = bounds.upper[second_axis] = 0.0;
    if (place_ >= 0)
      bounds.least_linear_mm_s =
          std::max(0.0, motion.tip_mm_s.norm() - spread.tip_mm_s) / largest_tip_per_linear_;
    return bounds;
  }
  const Posture& at = *found;
  const Freedom free = freedom(at, spread);
  bounds.may_be_reached = free.may_be_reached;
  if (!free.may_be_reached) return bounds;

  // Both rotary rates are a numerator over the volume.
  struct Rate {
    double lower, upper, change;
  };
  const double rate_change = spread.turn_rad_s + motion.turn_rad_s.norm() * spread.axis_rad;
  const auto rate = [&](double rate_here, double numerator_change, double largest) {
    const double numerator = std::abs(rate_here * at.volume);
    const double least = numerator - numerator_change;
    const double most = std::min(numerator + numerator_change, largest);
    const double lower = least > 0.0 ? least / free.largest_volume : 0.0;
    if (!turns) return Rate{0.0, 0.0, 0.0};
    if (!(free.smallest_volume > 0.0)) return Rate{lower, infinite, infinite};
    const double upper = most / free.smallest_volume;
    const double lowest = least >= 0.0 ? lower : least / free.smallest_volume;
    return Rate{lower, upper, std::max(upper - std::abs(rate_here), std::abs(rate_here) - lowest)};
  };
  const double axis_rate = at.axis_rate.norm();
  Rate first = rate(at.first_rate, axis_rate * free.b_rad + rate_change, turn_rad_s * sin_mu_);
  Rate second = rate(at.second_rate, axis_rate * spread.pole_rad + rate_change,
                     turn_rad_s * free.largest_sin_gamma);
  // sin(gamma) / volume is 1 / (sin(lambda) sin(mu) sin(opening) / sin(gamma)), by the sine rule
  // 1 / (sin(lambda) sin(A)).
  if (free.least_sin_a > 0.0) {
    const double largest = turn_rad_s / (sin_lambda_ * free.least_sin_a);
    second.upper = std::min(second.upper, largest);
    second.change = std::min(second.change, second.upper + std::abs(at.second_rate));
  }
  bounds.lower[first_axis] = first.lower;
  bounds.upper[first_axis] = first.upper;
  bounds.lower[second_axis] = second.lower;
  bounds.upper[second_axis] = second.upper;
  if (place_ < 0) return bounds;

  const double tip_change_mm = spread.tip_mm + spread.origin_mm;
  const double second_arm_change =
      place_ == 2 ? tip_change_mm + b_from_a_mm_ * free.rotary_rad : tool_mm_ * free.tool_rad;
  const double first_arm_change =
      place_ == 0 ? b_from_a_mm_ * free.rotary_rad + tool_mm_ * free.tool_rad : tip_change_mm;
  // What does not move has no part, however far its arm may reach.
  const auto part = [](double rate_part, double arm) {
    return rate_part == 0.0 || arm == 0.0 ? 0.0 : rate_part * arm;
  };
  const double change =
      spread.tip_mm_s + part(first.change, clamping.pole.cross(at.first_arm_mm).norm()) +
      part(first.upper, spread.pole_rad * at.first_arm_mm.norm() + first_arm_change) +
      part(second.change, at.b.cross(at.second_arm_mm).norm()) +
      part(second.upper, free.b_rad * at.second_arm_mm.norm() + second_arm_change);
  const double size = at.linear_rate_mm_s.norm();
  bounds.least_linear_mm_s = std::max(0.0, size - change) / largest_tip_per_linear_;
  const double turned = frame_change(free, spread) * size;
  const Vec3 linear = linear_per_component_ * linear_frame(at).components(at.linear_rate_mm_s);
  for (std::size_t i = 0; i < first_axis; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double here = std::abs(linear[row]), most = row_norms_[row] * (size + change);
    const double off = row_norms_[row] * (turned + change);
    bounds.lower[i] = std::max(0.0, here - off);
    bounds.upper[i] = std::min(most, here + off);
  }
  return bounds;
}

Vec3 AxisRates::linear_change_mm(const ToolMotion& motion, const Clamping& clamping, int branch,
                                 const Spread& spread) const {
  const auto at = posture(motion, clamping, branch);
  if (place_ < 0 || !at) return Vec3::Constant(infinite);
  const Freedom free = freedom(*at, spread);
  double change_mm = spread.tip_mm + spread.origin_mm;
  if (place_ != 1) change_mm += b_from_a_mm_ * free.rotary_rad;
  if (place_ != 2) change_mm += tool_mm_ * free.tool_rad;
  return row_norms_ * (frame_change(free, spread) * linear_arm_mm(*at).norm() + change_mm);
}

}  // namespace pentapost::reorient
