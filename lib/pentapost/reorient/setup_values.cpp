#include "pentapost/reorient/setup_values.hpp"

#include "pentapost/path/turn.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pentapost::reorient {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::size_t most_places = 24;

}  // namespace

void Hints::remember(const PeakPlace& place) {
  const auto known = std::find_if(places.begin(), places.end(), [&](const PeakPlace& each) {
    return each.tool == place.tool && each.piece == place.piece;
  });
  if (known != places.end()) places.erase(known);
  places.insert(places.begin(), place);
  if (places.size() > most_places) places.pop_back();
}

SetupValue SetupValues::evaluate(const SetupPoint& setup, Hints& hints, double tolerance) const {
  const Mat3 turn =
      path::setup_turn(setup.theta_x_deg * rad_per_deg, setup.theta_z_deg * rad_per_deg);
  SetupValue found{
      .value = infinite,
      .clampings = loads_.clampings(clamping_of(model_, turn, setup.origin_mm), accuracy_rad_),
      .place = std::nullopt};
  found.extremes = hints.extremes = loads_.extremes(found.clampings.nominal, hints.extremes);
  Branches serve = loads_.branches(found.extremes);
  for (const int branch : {0, 1})
    if (auto& serves = serve[static_cast<std::size_t>(branch)];
        serves && loads_.linear_excess_mm(found.clampings.nominal, branch) > 0.0)
      serves = false;
  if (!serve[0] && !serve[1]) {
    // Setups nearby may be possible: what is known of the path bounds them.
    if (goal_ == Goal::peak_ratio && hints.places.empty())
      if (const Peak peak =
              loads_.peak(found.clampings, loads_.branch_of({true, true}), tolerance, {});
          peak.place)
        hints.remember(*peak.place);
    return found;
  }
  const int branch = loads_.branch_of(serve);
  switch (goal_) {
    case Goal::peak_ratio: {
      const Peak peak = loads_.peak(found.clampings, branch, tolerance, hints.places);
      found.value = peak.ratio;
      found.place = peak.place;
      if (peak.place) hints.remember(*peak.place);
      break;
    }
    case Goal::time:
      found.value = loads_.time_s(found.clampings, branch, tolerance);
      break;
    case Goal::travel:
      found.value = loads_.travel_rad(found.clampings, branch, tolerance);
      break;
  }
  return found;
}

Spread SetupValues::spread_of(const SetupDomain& domain, const SetupCell& cell,
                              const Clamping& middle) const {
  const auto reach = [&](std::size_t i) { return domain.coordinates[i].reach(cell.parts[i]); };
  const double tilt_rad = reach(0) * rad_per_deg, turn_rad = reach(1) * rad_per_deg;
  Spread spread;
  spread.turn_rad = std::min(pi, tilt_rad + turn_rad);
  // The pole is turned about x in the table, and about z in the part.
  const double tilt_arm = Vec3::UnitX().cross(model_.a).norm();
  const double turn_arm = Vec3::UnitZ().cross(middle.pole).norm();
  const double tilted_rad = tilt_rad * tilt_arm;
  spread.pole_rad =
      std::min(spread.turn_rad, tilted_rad + turn_rad * std::min(1.0, turn_arm + tilted_rad));
  const double along_mm = std::abs(middle.origin_from_a_mm.dot(middle.pole));
  const double aside_mm = middle.origin_from_a_mm.cross(middle.pole).norm();
  spread.origin_mm = along_mm * spread.pole_rad + aside_mm * spread.turn_rad +
                     Vec3{reach(2), reach(3), reach(4)}.norm();
  return spread;
}

/// Of the clampings about the setups of a region from those about its middle: their poles are as
/// far off, but turning one way and then the other leaves a little turn.
Spread SetupValues::about_spread(Spread spread) const {
  spread.turn_rad *= 1.0 + accuracy_rad_;
  spread.origin_mm *= 1.0 + accuracy_rad_;
  return spread;
}

double SetupValues::least_ratio(const SetupValue& middle, const Spread& spread,
                                std::span<const PeakPlace> places) const {
  double least = 0.0;
  const Branches branches =
      loads_.possible_branches(middle.clampings.nominal, middle.extremes, spread);
  const auto take = [&](const PeakPlace& place, const Clamping& clamping, const Spread& about) {
    least = std::max(least, loads_.least_ratio(place, clamping, about, branches));
  };
  for (const PeakPlace& place : places) take(place, middle.clampings.nominal, spread);
  // Every setup of the region has clampings about it in the place of those about the middle.
  if (middle.place) {
    for (const Clamping& about : middle.clampings.about)
      take(*middle.place, about, about_spread(spread));
    if (spread.pole_rad < middle.clampings.accuracy_rad &&
        loads_.meets_singularity(*middle.place, middle.clampings.nominal,
                                 middle.clampings.accuracy_rad - spread.pole_rad))
      least = infinite;
  }
  return std::max(least, loads_.least_passage_ratio(middle.clampings, middle.extremes, spread));
}

double SetupValues::least_ratio(const SetupDomain& domain, const SetupCell& cell,
                                const SetupValue& middle, std::span<const PeakPlace> places) const {
  return least_ratio(middle, spread_of(domain, cell, middle.clampings.nominal), places);
}

bool SetupValues::is_impossible(const SetupDomain& domain, const SetupCell& cell,
                                const SetupValue& middle) const {
  return loads_.is_impossible(middle.clampings.nominal, middle.extremes,
                              spread_of(domain, cell, middle.clampings.nominal));
}

double SetupValues::least_value(const SetupDomain& domain, const SetupCell& cell,
                                const SetupValue& middle, std::span<const PeakPlace> places) const {
  const Spread spread = spread_of(domain, cell, middle.clampings.nominal);
  if (goal_ == Goal::peak_ratio) return least_ratio(middle, spread, places);
  const Branches branches =
      loads_.possible_branches(middle.clampings.nominal, middle.extremes, spread);
  const auto least = [&](const Clamping& clamping, const Spread& about) {
    return goal_ == Goal::time ? loads_.least_time_s(clamping, about, branches)
                               : loads_.least_travel_rad(clamping, about, branches);
  };
  double value = least(middle.clampings.nominal, spread);
  // In a region wider than the accuracy those about its middle tell nothing more.
  if (spread.pole_rad < accuracy_rad_ &&
      loads_.is_near_singularity(middle.extremes, PathLoads::near_accuracies * accuracy_rad_,
                                 spread.pole_rad))
    for (const Clamping& about : middle.clampings.about)
      value = std::max(value, least(about, about_spread(spread)));
  return value;
}

/// The dimension in which the setups of a cell differ most.
std::size_t SetupValues::widest(const SetupDomain& domain, const SetupCell& cell,
                                const SetupValue& at) const {
  const Clamping& middle = at.clampings.nominal;
  constexpr double part_size_mm = 200.0;
  const double aside_mm = middle.origin_from_a_mm.cross(middle.pole).norm();
  const double tilt_rad = domain.coordinates[0].reach(cell.parts[0]) * rad_per_deg;
  const double turn_arm =
      std::min(1.0, Vec3::UnitZ().cross(middle.pole).norm() + tilt_rad + aside_mm / part_size_mm +
                        (model_.fixed.linear_place == 0 ? 1.0 : 0.0));
  std::size_t widest = 0;
  double most = -1.0;
  for (std::size_t i = 0; i < SetupDomain::dimensions; ++i) {
    const Coordinate& coordinate = domain.coordinates[i];
    if (!coordinate.can_be_split(cell.parts[i])) continue;
    const double reach = coordinate.reach(cell.parts[i]);
    // Least bounds keep every dimension in the turn.
    constexpr double smallest_arm = 1e-3;
    const double effect = i == 0   ? reach * rad_per_deg
                          : i == 1 ? reach * rad_per_deg * std::max(turn_arm, smallest_arm)
                                   : reach / part_size_mm;
    if (effect > most) {
      most = effect;
      widest = i;
    }
  }
  return most < 0.0 ? SetupDomain::dimensions : widest;
}

std::vector<SetupPoint> SetupValues::knife_edges(const SetupDomain& domain, const SetupCell& cell,
                                                 const PeakPlace& place) const {
  std::vector<SetupPoint> edges;
  const Vec3 normal = loads_.motion(place).turn_rad_s;
  const SetupPoint from = middle(domain, cell);
  const auto aside = [&](const SetupPoint& setup) {
    const Mat3 turn =
        path::setup_turn(setup.theta_x_deg * rad_per_deg, setup.theta_z_deg * rad_per_deg);
    return normal.dot(turn.transpose() * model_.a);
  };
  constexpr int halvings = 60;
  for (const std::size_t i : {0U, 1U}) {
    if (domain.coordinates[i].is_list()) continue;
    const auto at = [&](double angle_deg) {
      SetupPoint setup = from;
      (i == 0 ? setup.theta_x_deg : setup.theta_z_deg) = angle_deg;
      return setup;
    };
    double lower = cell.parts[i].lower, upper = cell.parts[i].upper;
    const bool is_low = aside(at(lower)) < 0.0;
    if (is_low == (aside(at(upper)) < 0.0)) continue;
    for (int k = 0; k < halvings; ++k) {
      const double half = 0.5 * (lower + upper);
      (aside(at(half)) < 0.0) == is_low ? lower = half : upper = half;
    }
    edges.push_back(at(lower));
  }
  return edges;
}

}  // namespace pentapost::reorient
