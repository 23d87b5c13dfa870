#include "pentapost/verify/hole.hpp"

#include "pentapost/core/number_text.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::verify {
namespace {

/// Controls take dwells in ms.
constexpr double dwell_rounding_s = 0.0006;

using Kind = path::CycleStart::Kind;
using Hole = nc::ReadMotion::Hole;

Hole hole_of(const path::CycleStart& cycle) {
  switch (cycle.kind) {
    case Kind::drill:
    case Kind::face:
      return Hole::drill;
    case Kind::deep:
      return cycle.peck_mm ? Hole::deep : Hole::drill;
    case Kind::break_chip:
      return cycle.peck_mm ? Hole::break_chip : Hole::drill;
    case Kind::tap:
      return Hole::tap;
    case Kind::tap_left:
      return Hole::tap_left;
    case Kind::bore:
    case Kind::ream:
      return Hole::feed_out;
    case Kind::bore_drag:
      return Hole::spindle_stop;
  }
  return Hole::other;
}

}  // namespace

HoleLevels hole_levels(const path::CycleStart& cycle, const Vec3& reference_mm, const Vec3& axis) {
  return {.bottom_mm = reference_mm - cycle.depth_mm * axis,
          .clearance_mm = reference_mm + cycle.clearance_mm * axis,
          .retract_mm = reference_mm + cycle.retract_mm.value_or(cycle.clearance_mm) * axis};
}

Deviation hole_deviation(const HoleLevels& expected, const Vec3& axis, const Stop& bottom,
                         const Stop& clearance, const Stop& retract) {
  return {.tip_mm = std::max({(bottom.station.tip_mm - expected.bottom_mm).norm(),
                              (clearance.station.tip_mm - expected.clearance_mm).norm(),
                              (retract.station.tip_mm - expected.retract_mm).norm()}),
          .axis_chord = (bottom.station.axis - axis).norm()};
}

std::string wrong_travel(const Stop& from, const Stop& clearance, const std::optional<Stop>& travel,
                         const std::optional<Vec3>& last_mm, const Vec3& axis,
                         const Deviation& limit) {
  const Vec3 way_mm = clearance.station.tip_mm - from.station.tip_mm;
  if (from.placed && axis.cross(way_mm).norm() <= limit.tip_mm) return {};
  if (!travel) return "the way to the hole runs at a level that is not known";
  const Vec3& travel_mm = travel->station.tip_mm;
  const auto below = [&](const Vec3& place_mm) {
    const Vec3 up_mm = place_mm - travel_mm;
    const double slack_mm = limit.tip_mm + limit.axis_chord * up_mm.norm();
    return up_mm.dot(axis) <= slack_mm ? 0.0 : up_mm.dot(axis);
  };
  const double below_last_mm = last_mm ? below(*last_mm) : 0.0;
  const double below_mm = std::max(below(clearance.station.tip_mm), below_last_mm);
  if (below_mm <= 0.0) return {};
  return "the way to the hole runs " + number_text(below_mm, 6) + " mm below the level of " +
         (below_last_mm == below_mm ? "the point before" : "its clearance");
}

std::string wrong_cycle_data(const nc::ReadMotion& motion, const path::CycleStart& cycle,
                             double length_rounding_mm) {
  if (motion.hole != hole_of(cycle))
    return "the cycle " + std::string{motion.cycle} + " is not the one of the CL data";
  const bool pecks = cycle.kind == Kind::deep || cycle.kind == Kind::break_chip;
  const double peck_mm = pecks ? cycle.peck_mm.value_or(0.0) : 0.0;
  if (!(std::abs(motion.peck_mm - peck_mm) <= length_rounding_mm))
    return "the cycle pecks by " + number_text(motion.peck_mm) + " mm, expected are " +
           number_text(peck_mm) + " mm";
  if (!(std::abs(motion.dwell_s - cycle.dwell_s) <= dwell_rounding_s))
    return "the cycle dwells " + number_text(motion.dwell_s) + " s, expected are " +
           number_text(cycle.dwell_s) + " s";
  return {};
}

}  // namespace pentapost::verify
