#include "pentapost/path/segment.hpp"

#include <algorithm>

namespace pentapost::path {

Segment::Segment(const Vec3& tip_from_mm, const Vec3& axis_from, const Vec3& tip_to_mm,
                 const Vec3& axis_to, const Arc* arc)
    : tip_from_mm_{tip_from_mm}, tip_to_mm_{tip_to_mm}, axis_from_{axis_from}, axis_to_{axis_to} {
  // Equal axes are the rule in real files and need no trigonometry.
  if (axis_from != axis_to) set_axis_turn();
  if (arc == nullptr) {
    length_mm_ = (tip_to_mm - tip_from_mm).norm();
    return;
  }
  set_arc(*arc);
}

void Segment::set_axis_turn() {
  const Vec3 normal = axis_from_.cross(axis_to_);
  const double sine = normal.norm();
  axis_angle_rad_ = std::atan2(sine, axis_from_.dot(axis_to_));
  if (sine > 0.0)
    axis_turn_ = normal.cross(axis_from_) / sine;
  else if (axis_angle_rad_ > 0.0)
    axis_turn_ = axis_from_.unitOrthogonal();
}

void Segment::set_arc(const Arc& arc) {
  is_arc_ = true;
  centre_mm_ = arc.centre_wp_mm;
  const double normal_length = arc.normal_wp.norm();
  if (normal_length > 0.0) normal_ = arc.normal_wp / normal_length;
  const Vec3 from = tip_from_mm_ - centre_mm_;
  const Vec3 to = tip_to_mm_ - centre_mm_;
  height_from_mm_ = from.dot(normal_);
  height_to_mm_ = to.dot(normal_);
  const Vec3 arm_from = from - height_from_mm_ * normal_;
  const Vec3 arm_to = to - height_to_mm_ * normal_;
  radius_from_mm_ = arm_from.norm();
  radius_to_mm_ = arm_to.norm();
  if (radius_from_mm_ > 0.0)
    radial_ = arm_from / radius_from_mm_;
  else if (radius_to_mm_ > 0.0)
    radial_ = Eigen::AngleAxisd{-arc.sweep_rad, normal_} * (arm_to / radius_to_mm_);
  else
    radial_ = normal_.unitOrthogonal();
  sweep_rad_ = arc.sweep_rad;
  if (radius_to_mm_ > 0.0) {
    const double end_rad = std::atan2(arm_to.dot(normal_.cross(radial_)), arm_to.dot(radial_));
    const double mended_rad = sweep_rad_ + wrapped_rad(end_rad - sweep_rad_);
    if (mended_rad > 0.0) sweep_rad_ = mended_rad;
  }
  length_mm_ = std::hypot(sweep_rad_ * 0.5 * (radius_from_mm_ + radius_to_mm_),
                          height_to_mm_ - height_from_mm_, radius_to_mm_ - radius_from_mm_);
}

Vec3 Segment::arm_mm(double fraction) const {
  const double angle_rad = fraction * sweep_rad_;
  const double radius_mm = radius_from_mm_ + fraction * (radius_to_mm_ - radius_from_mm_);
  return radius_mm * (std::cos(angle_rad) * radial_ + std::sin(angle_rad) * normal_.cross(radial_));
}

Vec3 Segment::tip_mm(double fraction) const {
  if (fraction == 0.0) return tip_from_mm_;
  if (fraction == 1.0) return tip_to_mm_;
  if (!is_arc_) return tip_from_mm_ + fraction * (tip_to_mm_ - tip_from_mm_);
  const double height_mm = height_from_mm_ + fraction * (height_to_mm_ - height_from_mm_);
  return centre_mm_ + height_mm * normal_ + arm_mm(fraction);
}

Vec3 Segment::axis(double fraction) const {
  if (fraction == 0.0 || axis_angle_rad_ == 0.0) return axis_from_;
  if (fraction == 1.0) return axis_to_;
  const double angle_rad = fraction * axis_angle_rad_;
  return std::cos(angle_rad) * axis_from_ + std::sin(angle_rad) * axis_turn_;
}

Vec3 Segment::tip_rate_mm(double fraction) const {
  if (!is_arc_) return tip_to_mm_ - tip_from_mm_;
  const double angle_rad = fraction * sweep_rad_;
  const double radius_mm = radius_from_mm_ + fraction * radius_change_mm();
  const Vec3 across = normal_.cross(radial_);
  return (height_to_mm_ - height_from_mm_) * normal_ +
         radius_change_mm() * (std::cos(angle_rad) * radial_ + std::sin(angle_rad) * across) +
         radius_mm * sweep_rad_ * (std::cos(angle_rad) * across - std::sin(angle_rad) * radial_);
}

Vec3 Segment::tip_acceleration_mm(double fraction) const {
  if (!is_arc_) return Vec3::Zero();
  const double angle_rad = fraction * sweep_rad_;
  const double radius_mm = radius_from_mm_ + fraction * radius_change_mm();
  const Vec3 across = normal_.cross(radial_);
  return 2.0 * radius_change_mm() * sweep_rad_ *
             (std::cos(angle_rad) * across - std::sin(angle_rad) * radial_) -
         radius_mm * sweep_rad_ * sweep_rad_ *
             (std::cos(angle_rad) * radial_ + std::sin(angle_rad) * across);
}

Vec3 Segment::axis_rate(double fraction) const {
  if (fraction == 0.0) return axis_angle_rad_ * axis_turn_;
  const double angle_rad = fraction * axis_angle_rad_;
  return axis_angle_rad_ * (std::cos(angle_rad) * axis_turn_ - std::sin(angle_rad) * axis_from_);
}

Vec3 Segment::axis_acceleration(double fraction) const {
  return -axis_angle_rad_ * axis_angle_rad_ * axis(fraction);
}

double Segment::largest_radius_mm() const { return std::max(radius_from_mm_, radius_to_mm_); }
double Segment::smallest_radius_mm() const { return std::min(radius_from_mm_, radius_to_mm_); }

double Segment::axis_distance_mm(const Vec3& point_mm) const {
  return normal_.cross(point_mm - centre_mm_).norm();
}

double Segment::projected_fraction(const Vec3& point_mm, double near_fraction) const {
  if (!(length_mm_ > 0.0)) return 0.0;
  const Vec3 along = tip_to_mm_ - tip_from_mm_;
  if (!is_arc_) return along.dot(point_mm - tip_from_mm_) / along.squaredNorm();
  if (!(sweep_rad_ > 0.0)) return 0.0;
  const Vec3 from_centre = point_mm - centre_mm_;
  const double angle_rad =
      std::atan2(from_centre.dot(normal_.cross(radial_)), from_centre.dot(radial_));
  const double turns = std::round((near_fraction * sweep_rad_ - angle_rad) / (2.0 * pi));
  const double of_angle = (angle_rad + 2.0 * pi * turns) / sweep_rad_;
  const double rise_mm = height_to_mm_ - height_from_mm_;
  if (rise_mm == 0.0) return of_angle;
  // On a helix both angle and height tell the place, each by its share in the way.
  const double of_height = (from_centre.dot(normal_) - height_from_mm_) / rise_mm;
  const double round_mm = 0.5 * (radius_from_mm_ + radius_to_mm_) * sweep_rad_;
  const double share = rise_mm * rise_mm / (rise_mm * rise_mm + round_mm * round_mm);
  return of_angle + share * (of_height - of_angle);
}

double Segment::nearest_fraction(const Vec3& point_mm, double near_fraction) const {
  return std::clamp(projected_fraction(point_mm, near_fraction), 0.0, 1.0);
}

}  // namespace pentapost::path
