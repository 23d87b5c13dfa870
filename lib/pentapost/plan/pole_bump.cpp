#include "pentapost/plan/pole_bump.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::plan {
namespace {

constexpr double largest_growth = 1.4;
constexpr double largest_step = 0.1;
/// From here on the step is what bounds.
constexpr double join = largest_step / (largest_growth - 1.0);
constexpr double largest_core_turn_rad = 60.0 * rad_per_deg;

double square(double value) { return value * value; }

/// Number of pieces from the core to x, and its inverse.
double pieces_to(double x) {
  const double inner = std::log(std::min(x, join) / PoleBump::core) / std::log(largest_growth);
  return inner + std::max(0.0, x - join) / largest_step;
}
double x_after(double pieces) {
  const double inner = pieces_to(join);
  if (pieces > inner) return join + largest_step * (pieces - inner);
  return PoleBump::core * std::pow(largest_growth, pieces);
}

}  // namespace

PoleBump::PoleBump(const Vec3& pole, const Vec3& nearest, const std::array<double, 2>& end_chord)
    : pole_{pole},
      towards_{(nearest - pole * pole.dot(nearest)).normalized()},
      beside_{pole.cross(towards_)},
      normal_{-beside_},
      delta_rad_{angle_between_rad(pole, nearest)},
      nearest_square_{(nearest - pole).squaredNorm()} {
  for (std::size_t side = 0; side < 2; ++side)
    width_square_[side] = square(end_chord[side]) - nearest_square_;
}

double PoleBump::x_of(const Vec3& axis, std::size_t side) const {
  return std::sqrt(
      std::max(0.0, ((axis - pole_).squaredNorm() - nearest_square_) / width_square_[side]));
}

std::vector<double> PoleBump::divisions(const GreatCircle& turn, double from_fraction,
                                        double to_fraction, std::size_t side) const {
  const double from_x = x_of(turn.axis(from_fraction), side);
  const double to_x = x_of(turn.axis(to_fraction), side);
  const auto [least, most] = std::minmax(from_x, to_x);
  std::vector<double> cuts;
  const double lower = std::max(least, core), upper = std::min(most, 1.0);
  if (!(lower < upper * (1.0 - same_share))) return cuts;
  if (least < core * (1.0 - same_share)) cuts.push_back(core);
  const double first = pieces_to(lower), way = pieces_to(upper) - first;
  const int count = static_cast<int>(std::ceil(way - same_share));
  for (int i = 1; i < count; ++i) cuts.push_back(x_after(first + way * i / count));
  if (most > 1.0 + same_share) cuts.push_back(1.0);

  // On the circle c^2 = c_foot^2 + 4 cos(foot) sin^2(turned / 2).
  const double foot_rad = turn.nearest_rad(pole_);
  const Vec3 foot = turn.at(foot_rad);
  const double foot_square = (foot - pole_).squaredNorm(), foot_cosine = foot.dot(pole_);
  const double middle_rad = 0.5 * (from_fraction + to_fraction) * turn.angle_rad;
  std::vector<double> fractions;
  fractions.reserve(cuts.size());
  for (const double x : cuts) {
    const double above = nearest_square_ + x * x * width_square_[side] - foot_square;
    if (!(above > 0.0 && foot_cosine > 0.0)) continue;
    const double turned_rad = 2.0 * std::asin(std::min(1.0, 0.5 * std::sqrt(above / foot_cosine)));
    const double fraction =
        (foot_rad + std::copysign(turned_rad, middle_rad - foot_rad)) / turn.angle_rad;
    if (fraction > from_fraction && fraction < to_fraction) fractions.push_back(fraction);
  }
  std::sort(fractions.begin(), fractions.end());
  fractions.erase(std::unique(fractions.begin(), fractions.end()), fractions.end());
  return fractions;
}

Vec3 PoleBump::shifted(const Vec3& axis, double share) const {
  return Eigen::AngleAxisd{share * delta_rad_, normal_} * axis;
}

double PoleBump::azimuth_rad(const Vec3& axis) const {
  return std::atan2(axis.dot(beside_), axis.dot(towards_));
}

bool PoleBump::set_core(const std::array<Vec3, 2>& core_ends) {
  const double in_rad = azimuth_rad(shifted(core_ends[before], 1.0));
  const double out_rad = azimuth_rad(shifted(core_ends[after], 1.0));
  const double turn_rad = wrapped_rad(out_rad - in_rad - pi);
  line_rad_ = out_rad - 0.5 * turn_rad;
  core_turn_rad_ = {0.5 * turn_rad, -0.5 * turn_rad};
  return std::abs(turn_rad) <= largest_core_turn_rad;
}

PoleBump::Polar PoleBump::polar(const Vec3& axis) const {
  const Vec3 near = shifted(axis, 1.0);
  return {angle_between_rad(pole_, near), azimuth_rad(near)};
}

Vec3 PoleBump::bent(const Vec3& axis, std::size_t side, double azimuth_turn_rad) const {
  const double x = std::min(1.0, x_of(axis, side));
  if (x <= core * (1.0 + same_share)) {
    const Vec3 near = shifted(axis, 1.0);
    const Vec3 along = std::cos(line_rad_) * towards_ + std::sin(line_rad_) * beside_;
    const double tilt_rad = std::atan2(near.dot(along), near.dot(pole_));
    return std::cos(tilt_rad) * pole_ + std::sin(tilt_rad) * along;
  }
  const double share = square(1.0 - x * (x - core) / (1.0 - core));
  const Vec3 near = shifted(axis, share);
  return (Eigen::AngleAxisd{azimuth_turn_rad, pole_} * near).normalized();
}

double turn_ratio(const Vec3& pole, const Vec3& from, const Vec3& to) {
  constexpr double through_sine = 1e-12;
  const Vec3 normal = from.cross(to);
  const double sine = normal.norm();
  if (!(sine > 0.0)) return 0.0;
  const double foot_sine = std::abs(pole.dot(normal)) / sine;
  if (foot_sine <= through_sine) return 0.0;
  // Along the circle the azimuth turns by sin(foot) / sin^2(distance).
  const GreatCircle turn{from, to};
  const double nearest = std::clamp(turn.nearest_fraction(pole), 0.0, 1.0);
  return foot_sine / pole.cross(turn.axis(nearest)).squaredNorm();
}

}  // namespace pentapost::plan
