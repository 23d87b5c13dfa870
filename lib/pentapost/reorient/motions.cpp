#include "pentapost/reorient/motions.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::reorient {

Range<double> gammas(const ToolMotion& motion, const Vec3& pole, double from_rad, double to_rad) {
  const double speed_rad_s = motion.turn_rad_s.norm();
  const double cosine = pole.dot(motion.axis);
  if (!(speed_rad_s > 0.0) || !(to_rad > from_rad)) {
    const double gamma = angle_between_rad(pole, motion.axis);
    return {gamma, gamma};
  }
  const Vec3 along = motion.turn_rad_s.cross(motion.axis) / speed_rad_s;
  const double sine = pole.dot(along);
  const auto at = [&](double angle_rad) {
    const Vec3 axis = std::cos(angle_rad) * motion.axis + std::sin(angle_rad) * along;
    return angle_between_rad(pole, axis);
  };
  const double at_from = at(from_rad), at_to = at(to_rad);
  Range<double> range{std::min(at_from, at_to), std::max(at_from, at_to)};
  const double nearest = std::atan2(sine, cosine);
  const auto is_inside = [&](double angle_rad) {
    for (const double turn : {-2.0 * pi, 0.0, 2.0 * pi})
      if (angle_rad + turn > from_rad && angle_rad + turn < to_rad) return true;
    return false;
  };
  if (is_inside(nearest)) range.lower = at(nearest);
  if (is_inside(nearest + pi)) range.upper = at(nearest + pi);
  return range;
}

Range<double> gammas_of_move(const Piece& piece, const Vec3& pole) {
  return gammas(piece.middle, pole, -piece.turn_before_rad, piece.turn_after_rad);
}

Spread together(const Spread& of_motion, const Spread& of_clamping) {
  Spread both = of_clamping;
  both.axis_rad += of_motion.axis_rad;
  both.turn_rad_s += of_motion.turn_rad_s;
  both.tip_mm += of_motion.tip_mm;
  both.tip_mm_s += of_motion.tip_mm_s;
  return both;
}

Spread spread_of(const Piece& piece) {
  Spread spread;
  spread.axis_rad = piece.half_turn_rad();
  const double speed_mm_s = piece.middle.tip_mm_s.norm();
  spread.tip_mm = 0.5 * piece.time_s * speed_mm_s;
  spread.tip_mm_s = piece.half_sweep_rad * speed_mm_s;
  return spread;
}

MotionGroup group_of(const Piece& piece) {
  const Spread spread = spread_of(piece);
  return {.centre = piece.middle,
          .spread = spread,
          .largest_turn_rad_s = piece.middle.turn_rad_s.norm(),
          .largest_tip_mm_s = piece.middle.tip_mm_s.norm(),
          // Of angles this small.
          .axis_sine = spread.axis_rad,
          .axis_cosine = 1.0 - 0.5 * spread.axis_rad * spread.axis_rad};
}

}  // namespace pentapost::reorient
