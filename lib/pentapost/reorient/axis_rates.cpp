#include "pentapost/reorient/axis_rates.hpp"

#include "pentapost/kinematics/rotate.hpp"
#include "pentapost/reorient/posture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pentapost::reorient {
namespace {

/// Cosines below this are those of a right angle.
constexpr double right_angle_cosine = 1e-12;
/// Sine of the opening, or of the angle to the pole, below which there are no rates.
constexpr double smallest_sine = 1e-9;

}  // namespace

AxisRates::AxisRates(const kinematics::Model& model, double gauge_length_mm)
    : least_gamma_rad_{std::abs(model.lambda_rad - model.mu_rad)},
      most_gamma_rad_{model.lambda_rad + model.mu_rad},
      cos_least_gamma_{std::cos(least_gamma_rad_)},
      cos_most_gamma_{std::cos(most_gamma_rad_)},
      lambda_rad_{model.lambda_rad},
      mu_rad_{model.mu_rad},
      cos_lambda_{std::cos(model.lambda_rad)},
      sin_lambda_{std::sin(model.lambda_rad)},
      cos_mu_{std::cos(model.mu_rad)},
      sin_mu_{std::sin(model.mu_rad)},
      is_right_angled_{std::abs(cos_lambda_) < right_angle_cosine &&
                       std::abs(cos_mu_) < right_angle_cosine},
      place_{model.fixed.linear_place} {
  const Vec3 b = model.b_flipped ? Vec3{-model.b} : model.b;
  const Vec3& a = model.fixed.a_drawn;
  const Vec3 opened =
      kinematics::rotated(model.b, kinematics::SineCosine{model.beta_zero_rad + 1.0}, model.t);
  sign_of_branch_0_ = b.dot(a.cross(opened)) > 0.0 ? 1.0 : -1.0;
  const Frame of_rotary = frame(a, b), of_tool = frame(model.t, b);
  const Vec3 b_from_a_mm = model.b_point_mm - model.a_point_mm;
  const Vec3 tool_mm = -model.b_point_mm - gauge_length_mm * model.t;
  b_from_a_mm_ = b_from_a_mm.norm();
  tool_mm_ = tool_mm.norm();
  b_from_a_components_ = of_rotary.components(b_from_a_mm);
  tool_components_ = of_tool.components(tool_mm);
  const Mat3& inverse = model.fixed.linear_inverse;
  const Frame carrying = place_ == 2   ? of_tool
                         : place_ == 1 ? of_rotary
                                       : Frame{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  Mat3 axes;
  axes << carrying.along, carrying.aside, carrying.across;
  linear_per_component_ = inverse * axes;
  row_norms_ = inverse.rowwise().norm();
  // A bound of the largest singular value, exact for axes at right angles.
  const Mat3 directions = inverse.inverse();
  const Mat3 products = directions.transpose() * directions;
  largest_tip_per_linear_ = std::sqrt(products.cwiseAbs().rowwise().sum().maxCoeff());
  linear_offset_mm_ = place_ == 2   ? Vec3{inverse * tool_mm}
                      : place_ == 1 ? Vec3{inverse * b_from_a_mm}
                                    : Vec3{Vec3::Zero()};
}

AxisRates::Frame AxisRates::frame(const Vec3& along, const Vec3& other) {
  const Vec3 aside = (other - other.dot(along) * along).normalized();
  return {along, aside, along.cross(aside)};
}

double AxisRates::volume(double gamma_rad) const {
  if (is_right_angled_) return std::sin(gamma_rad);
  const double half = 0.5 * (lambda_rad_ + mu_rad_ + gamma_rad);
  const double square = std::sin(half) * std::sin(half - lambda_rad_) * std::sin(half - mu_rad_) *
                        std::sin(half - gamma_rad);
  return square > 0.0 ? 2.0 * std::sqrt(square) : 0.0;
}

std::optional<AxisRates::Posture> AxisRates::posture(const ToolMotion& motion,
                                                     const Clamping& clamping, int branch) const {
  Posture at;
  const Vec3 &pole = clamping.pole, &axis = motion.axis;
  const Vec3 normal = pole.cross(axis);
  at.sin_gamma = normal.norm();
  at.cos_gamma = pole.dot(axis);
  if (at.sin_gamma < smallest_sine) return std::nullopt;
  at.gamma_rad = std::atan2(at.sin_gamma, at.cos_gamma);
  const double sign = branch == 0 ? sign_of_branch_0_ : -sign_of_branch_0_;
  if (is_right_angled_) {
    at.volume = sign * at.sin_gamma;
    at.b = sign / at.sin_gamma * normal;
  } else {
    const double size = volume(at.gamma_rad);
    if (!(size > smallest_sine * sin_lambda_ * sin_mu_)) return std::nullopt;
    at.volume = sign * size;
    const double per_square = 1.0 / (at.sin_gamma * at.sin_gamma);
    at.b = per_square * ((cos_lambda_ - at.cos_gamma * cos_mu_) * pole +
                         (cos_mu_ - at.cos_gamma * cos_lambda_) * axis + at.volume * normal);
  }
  at.axis_rate = motion.turn_rad_s.cross(axis);
  at.first_rate = at.axis_rate.dot(at.b) / at.volume;
  at.second_rate = -at.axis_rate.dot(pole) / at.volume;
  at.of_rotary = frame(pole, at.b);
  at.of_tool = frame(axis, at.b);
  const Mat3& turn = clamping.to_table;
  at.of_table = {turn.row(0), turn.row(1), turn.row(2)};
  at.b_from_a_mm = at.of_rotary.vector(b_from_a_components_);
  at.tool_mm = at.of_tool.vector(tool_components_);
  at.tip_from_a_mm = motion.tip_mm + clamping.origin_from_a_mm;
  at.second_arm_mm = place_ == 2 ? Vec3{at.tip_from_a_mm - at.b_from_a_mm} : at.tool_mm;
  at.first_arm_mm = place_ == 0 ? Vec3{at.b_from_a_mm + at.tool_mm} : at.tip_from_a_mm;
  at.linear_rate_mm_s = motion.tip_mm_s - at.first_rate * pole.cross(at.first_arm_mm) -
                        at.second_rate * at.b.cross(at.second_arm_mm);
  return at;
}

const AxisRates::Frame& AxisRates::linear_frame(const Posture& posture) const {
  return place_ == 2 ? posture.of_tool : place_ == 1 ? posture.of_rotary : posture.of_table;
}

std::optional<PerAxis> AxisRates::at(const ToolMotion& motion, const Clamping& clamping,
                                     int branch) const {
  PerAxis rates{};
  const auto found = posture(motion, clamping, branch);
  if (!found && motion.turn_rad_s.isZero(0.0)) {
    // At rest on the singularity the linear axes alone move, in a direction that is free.
    for (std::size_t i = 0; i < first_axis && place_ >= 0; ++i)
      rates[i] = row_norms_[static_cast<Eigen::Index>(i)] * motion.tip_mm_s.norm();
    return rates;
  }
  if (!found) return std::nullopt;
  rates[first_axis] = std::abs(found->first_rate);
  rates[second_axis] = std::abs(found->second_rate);
  if (place_ < 0) return rates;
  const Vec3 linear =
      linear_per_component_ * linear_frame(*found).components(found->linear_rate_mm_s);
  for (std::size_t i = 0; i < first_axis; ++i)
    rates[i] = std::abs(linear[static_cast<Eigen::Index>(i)]);
  return rates;
}

std::optional<double> AxisRates::ratio(const ToolMotion& motion, const Clamping& clamping,
                                       int branch, const SpeedShares& shares) const {
  const PerAxis& time_s = shares.time_per_way_s;
  if (is_right_angled_ && !shares.has_linear) {
    const Vec3 normal = clamping.pole.cross(motion.axis);
    const double sine_square = normal.squaredNorm();
    if (!(sine_square > smallest_sine * smallest_sine))
      return motion.turn_rad_s.isZero(0.0) ? std::optional{0.0} : std::nullopt;
    const Vec3 axis_rate = motion.turn_rad_s.cross(motion.axis);
    return std::max(
        std::abs(axis_rate.dot(normal)) / sine_square * time_s[first_axis],
        std::abs(axis_rate.dot(clamping.pole)) / std::sqrt(sine_square) * time_s[second_axis]);
  }
  const auto rates = at(motion, clamping, branch);
  if (!rates) return std::nullopt;
  double largest = 0.0;
  for (std::size_t i = 0; i < axis_count; ++i)
    if (time_s[i] > 0.0) largest = std::max(largest, (*rates)[i] * time_s[i]);
  return largest;
}

Vec3 AxisRates::linear_arm_mm(const Posture& posture) const {
  if (place_ == 2) return posture.tip_from_a_mm - posture.b_from_a_mm;
  if (place_ == 1) return posture.tip_from_a_mm - posture.tool_mm;
  return posture.tip_from_a_mm - posture.b_from_a_mm - posture.tool_mm;
}

std::optional<Vec3> AxisRates::linear_mm(const ToolMotion& motion, const Clamping& clamping,
                                         int branch) const {
  if (place_ < 0) return std::nullopt;
  const auto at = posture(motion, clamping, branch);
  if (!at) return std::nullopt;
  return linear_per_component_ * linear_frame(*at).components(linear_arm_mm(*at)) -
         linear_offset_mm_;
}

double angle_of_cosine_rad(double cosine) {
  const double within = std::clamp(cosine, -1.0, 1.0);
  return std::atan2(std::sqrt((1.0 - within) * (1.0 + within)), within);
}

std::optional<double> AxisRates::opening_rad(double gamma_rad) const {
  constexpr double rounding = 1e-12;
  const double cosine = (std::cos(gamma_rad) - cos_lambda_ * cos_mu_) / (sin_lambda_ * sin_mu_);
  if (!(std::abs(cosine) <= 1.0 + rounding)) return std::nullopt;
  return angle_of_cosine_rad(cosine);
}

std::optional<Range<double>> AxisRates::openings_rad(const Range<double>& gamma_rad) const {
  const double lower = std::max(gamma_rad.lower, least_gamma_rad_);
  const double upper = std::min(gamma_rad.upper, most_gamma_rad_);
  if (!(lower <= upper)) return std::nullopt;
  return Range<double>{opening_rad(lower).value_or(0.0), opening_rad(upper).value_or(pi)};
}

double AxisRates::singularity_distance_rad(double gamma_rad) const {
  return std::min(std::abs(gamma_rad - least_gamma_rad_), std::abs(most_gamma_rad_ - gamma_rad));
}

bool AxisRates::has_singularity_between(const Range<double>& gamma_rad) const {
  return gamma_rad.contains(least_gamma_rad_) || gamma_rad.contains(most_gamma_rad_);
}

}  // namespace pentapost::reorient
