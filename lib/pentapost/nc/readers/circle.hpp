#pragma once

#include <optional>

namespace pentapost::nc::readers {

/// A point of the plane across Z, mm.
struct PlanePoint {
  double x = 0.0, y = 0.0;
};

/// Ends of an arc that are nearer than this are one point: a control counts in steps of at least
/// 1e-5 mm, and sums of such numbers differ by less than 1e-9 mm.
inline constexpr double same_point_mm = 1e-7;

bool is_same_point(PlanePoint first, PlanePoint second);

/// Difference of the distances of start and end from the centre, mm.
double radius_mismatch_mm(PlanePoint start, PlanePoint end, PlanePoint centre);

/// Centre of the arc with a given radius.
/// @param radius_mm     > 0: the arc is at most 180 deg; < 0: at least 180 deg.
/// @param tolerance_mm  by so much the chord may exceed the diameter.
/// @return nullopt: no such arc, or start and end are one point.
std::optional<PlanePoint> centre_from_radius(PlanePoint start, PlanePoint end, double radius_mm,
                                             bool clockwise, double tolerance_mm);

}  // namespace pentapost::nc::readers
