#include "pentapost/path/segment.hpp"

#include <algorithm>

namespace pentapost::path {

Segment::Segment(const Vec3& tip_from_mm, const Vec3& axis_from, const Vec3& tip_to_mm,
                 const Vec3& axis_to, const Arc* arc)
    : tip_from_mm_{tip_from_mm}, tip_to_mm_{tip_to_mm}, axis_from_{axis_from}, axis_to_{axis_to} {
  // Equal axes are the rule in real files and need no trigonometry.
  if (axis_from != axis_to) {
    axis_angle_rad_ = angle_between_rad(axis_from, axis_to);
    const Vec3 across = axis_to - axis_from * axis_from.dot(axis_to);
    const double across_norm = across.norm();
    if (across_norm > 0.0) axis_turn_ = across / across_norm;
  }
  if (arc == nullptr) {
    length_mm_ = (tip_to_mm - tip_from_mm).norm();
    return;
  }
  is_arc_ = true;
  centre_mm_ = arc->centre_wp_mm;
  normal_ = arc->normal_wp;
  sweep_rad_ = arc->sweep_rad;
  const Vec3 from = tip_from_mm - centre_mm_;
  const Vec3 to = tip_to_mm - centre_mm_;
  height_from_mm_ = from.dot(normal_);
  height_to_mm_ = to.dot(normal_);
  const Vec3 radial = from - height_from_mm_ * normal_;
  radius_from_mm_ = radial.norm();
  radius_to_mm_ = (to - height_to_mm_ * normal_).norm();
  if (radius_from_mm_ > 0.0) radial_ = radial / radius_from_mm_;
  length_mm_ = std::hypot(sweep_rad_ * 0.5 * (radius_from_mm_ + radius_to_mm_),
                          height_to_mm_ - height_from_mm_, radius_to_mm_ - radius_from_mm_);
}

Vec3 Segment::tip_mm(double fraction) const {
  if (fraction == 0.0) return tip_from_mm_;
  if (fraction == 1.0) return tip_to_mm_;
  if (!is_arc_) return tip_from_mm_ + fraction * (tip_to_mm_ - tip_from_mm_);
  const double angle_rad = fraction * sweep_rad_;
  const double radius_mm = radius_from_mm_ + fraction * (radius_to_mm_ - radius_from_mm_);
  const double height_mm = height_from_mm_ + fraction * (height_to_mm_ - height_from_mm_);
  return centre_mm_ + height_mm * normal_ +
         radius_mm *
             (std::cos(angle_rad) * radial_ + std::sin(angle_rad) * normal_.cross(radial_));
}

Vec3 Segment::axis(double fraction) const {
  if (fraction == 0.0 || axis_angle_rad_ == 0.0) return axis_from_;
  if (fraction == 1.0) return axis_to_;
  const double angle_rad = fraction * axis_angle_rad_;
  return std::cos(angle_rad) * axis_from_ + std::sin(angle_rad) * axis_turn_;
}

double Segment::nearest_fraction(const Vec3& point_mm, double near_fraction) const {
  if (length_mm_ == 0.0) return 0.0;
  if (!is_arc_) {
    const Vec3 along = tip_to_mm_ - tip_from_mm_;
    return std::clamp(along.dot(point_mm - tip_from_mm_) / along.squaredNorm(), 0.0, 1.0);
  }
  const Vec3 from_centre = point_mm - centre_mm_;
  const double angle_rad =
      std::atan2(from_centre.dot(normal_.cross(radial_)), from_centre.dot(radial_));
  const double turns = std::round((near_fraction * sweep_rad_ - angle_rad) / (2.0 * pi));
  return std::clamp((angle_rad + 2.0 * pi * turns) / sweep_rad_, 0.0, 1.0);
}

}  // namespace pentapost::path
