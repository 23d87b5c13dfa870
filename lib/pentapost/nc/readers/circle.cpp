#include "pentapost/nc/readers/circle.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::nc::readers {

bool is_same_point(PlanePoint first, PlanePoint second) {
  return std::abs(first.x - second.x) < same_point_mm &&
         std::abs(first.y - second.y) < same_point_mm;
}

double radius_mismatch_mm(PlanePoint start, PlanePoint end, PlanePoint centre) {
  return std::abs(std::hypot(start.x - centre.x, start.y - centre.y) -
                  std::hypot(end.x - centre.x, end.y - centre.y));
}

std::optional<PlanePoint> centre_from_radius(PlanePoint start, PlanePoint end, double radius_mm,
                                             bool clockwise, double tolerance_mm) {
  if (is_same_point(start, end)) return std::nullopt;
  const double chord_x = end.x - start.x, chord_y = end.y - start.y;
  const double half_chord = std::hypot(chord_x, chord_y) / 2.0;
  const double radius = std::abs(radius_mm);
  if (half_chord > radius + tolerance_mm) return std::nullopt;
  const double height = std::sqrt(std::max(0.0, (radius - half_chord) * (radius + half_chord)));
  // The centre of a short counter-clockwise arc lies to the left of the chord.
  const double side = clockwise == (radius_mm > 0.0) ? -height : height;
  return PlanePoint{(start.x + end.x) / 2.0 - side * chord_y / (2.0 * half_chord),
                    (start.y + end.y) / 2.0 + side * chord_x / (2.0 * half_chord)};
}

}  // namespace pentapost::nc::readers
