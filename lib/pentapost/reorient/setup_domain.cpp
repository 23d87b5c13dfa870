#include "pentapost/reorient/setup_domain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pentapost::reorient {
namespace {

/// Angles that differ by whole turns are one.
bool contains_angle(const Range<double>& range, double angle_deg) {
  constexpr double turn_deg = 360.0;
  const double turns = std::ceil((range.lower - angle_deg) / turn_deg);
  return angle_deg + turn_deg * turns <= range.upper;
}

bool contains_angles(const Range<double>& range, const Coordinate::Part& part) {
  constexpr double turn_deg = 360.0;
  const double turns = std::ceil((range.lower - part.lower) / turn_deg);
  return part.upper + turn_deg * turns <= range.upper;
}

}  // namespace

Coordinate Coordinate::interval(double lower, double upper) {
  Coordinate coordinate;
  coordinate.lower_ = lower;
  coordinate.upper_ = upper;
  return coordinate;
}

Coordinate Coordinate::list(std::vector<double> values) {
  Coordinate coordinate;
  coordinate.values_ = std::move(values);
  std::sort(coordinate.values_.begin(), coordinate.values_.end());
  coordinate.values_.erase(std::unique(coordinate.values_.begin(), coordinate.values_.end()),
                           coordinate.values_.end());
  coordinate.lower_ = coordinate.values_.front();
  coordinate.upper_ = coordinate.values_.back();
  return coordinate;
}

Coordinate::Part Coordinate::whole() const { return {lower_, upper_, 0, values_.size()}; }

double Coordinate::middle(const Part& part) const {
  return is_list() ? values_[part.begin + (part.end - part.begin) / 2]
                   : 0.5 * (part.lower + part.upper);
}

double Coordinate::nearest(const Part& part, double wanted) const {
  if (!is_list()) return std::clamp(wanted, part.lower, part.upper);
  const auto begin = values_.begin() + static_cast<std::ptrdiff_t>(part.begin);
  const auto end = values_.begin() + static_cast<std::ptrdiff_t>(part.end);
  return *std::min_element(
      begin, end, [&](double x, double y) { return std::abs(x - wanted) < std::abs(y - wanted); });
}

double Coordinate::reach(const Part& part) const {
  const double from = middle(part);
  return std::max(part.upper - from, from - part.lower);
}

bool Coordinate::can_be_split(const Part& part) const {
  constexpr double finest_share = 1e-7;
  if (is_list()) return part.end - part.begin > 1;
  return part.upper - part.lower > finest_share * std::max(1.0, upper_ - lower_);
}

std::array<Coordinate::Part, 2> Coordinate::split(const Part& part) const {
  if (!is_list()) {
    const double at = 0.5 * (part.lower + part.upper);
    return {Part{part.lower, at}, Part{at, part.upper}};
  }
  const std::size_t at = part.begin + (part.end - part.begin) / 2;
  return {Part{values_[part.begin], values_[at - 1], part.begin, at},
          Part{values_[at], values_[part.end - 1], at, part.end}};
}

bool SetupDomain::allows(const SetupPoint& point) const {
  for (std::size_t i = 0; i < dimensions; ++i)
    if (coordinates[i].nearest(coordinates[i].whole(), point[i]) != point[i]) return false;
  return std::none_of(forbidden.begin(), forbidden.end(), [&](const ForbiddenSetups& each) {
    return (!each.theta_x_deg || contains_angle(*each.theta_x_deg, point.theta_x_deg)) &&
           (!each.theta_z_deg || contains_angle(*each.theta_z_deg, point.theta_z_deg));
  });
}

SetupPoint SetupDomain::nearest(const SetupPoint& wanted) const {
  SetupPoint found = wanted;
  for (std::size_t i = 0; i < dimensions; ++i) {
    const Coordinate& coordinate = coordinates[i];
    double least = std::numeric_limits<double>::infinity();
    for (const double turns_deg : {0.0, -360.0, 360.0}) {
      if (i > 1 && turns_deg != 0.0) continue;
      const double equal = wanted[i] + turns_deg;
      const double value = coordinate.nearest(coordinate.whole(), equal);
      if (!(std::abs(value - equal) < least)) continue;
      least = std::abs(value - equal);
      found[i] = value;
    }
  }
  return found;
}

SetupCell whole(const SetupDomain& domain) {
  SetupCell cell;
  for (std::size_t i = 0; i < SetupDomain::dimensions; ++i)
    cell.parts[i] = domain.coordinates[i].whole();
  return cell;
}

SetupPoint middle(const SetupDomain& domain, const SetupCell& cell) {
  const auto at = [&](std::size_t i) { return domain.coordinates[i].middle(cell.parts[i]); };
  return {at(0), at(1), {at(2), at(3), at(4)}};
}

bool is_forbidden(const SetupDomain& domain, const SetupCell& cell) {
  return std::any_of(
      domain.forbidden.begin(), domain.forbidden.end(), [&](const ForbiddenSetups& each) {
        return (!each.theta_x_deg || contains_angles(*each.theta_x_deg, cell.parts[0])) &&
               (!each.theta_z_deg || contains_angles(*each.theta_z_deg, cell.parts[1]));
      });
}

}  // namespace pentapost::reorient
