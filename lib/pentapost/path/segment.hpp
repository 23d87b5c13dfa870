#pragma once

#include "pentapost/core/units.hpp"
#include "pentapost/path/tool_path.hpp"

namespace pentapost::path {

/// The continuous move between two CL points: tip on a line or an arc, axis on the great circle.
///
/// An arc whose ends differ in radius (CL digits) or in height runs both evenly from one to the
/// other: a helix, or a spiral by the rounding of the file. Its sweep is the one of the Arc, mended
/// by the digits of the end point, so that the move is continuous up to that point.
class Segment {
 public:
  /// @param axis_from, axis_to  unit; opposite axes turn about an arbitrary (but fixed) normal.
  /// @param arc  nullptr: a straight move.
  Segment(const Vec3& tip_from_mm, const Vec3& axis_from, const Vec3& tip_to_mm,
          const Vec3& axis_to, const Arc* arc = nullptr);

  Vec3 tip_mm(double fraction) const;  ///< 0: start, 1: end (both exact)
  Vec3 axis(double fraction) const;    ///< unit, on the great circle; 0 and 1 are exact
  // Derivatives by the fraction; the length of tip_rate_mm() is length_mm() but on a spiral.
  Vec3 tip_rate_mm(double fraction) const;
  Vec3 tip_acceleration_mm(double fraction) const;
  Vec3 axis_rate(double fraction) const;
  Vec3 axis_acceleration(double fraction) const;
  double length_mm() const { return length_mm_; }            ///< length of the tip's path
  double axis_angle_rad() const { return axis_angle_rad_; }  ///< angle that the tool axis turns
  bool is_arc() const { return is_arc_; }
  const Vec3& tip_from_mm() const { return tip_from_mm_; }
  const Vec3& tip_to_mm() const { return tip_to_mm_; }
  const Vec3& axis_from() const { return axis_from_; }
  const Vec3& axis_to() const { return axis_to_; }

  /// Fraction of the point of the tip's path that is nearest to `point_mm`, in [0, 1].
  /// 0 where the tip stands still. On an arc the nearest to `near_fraction` of equal turns.
  double nearest_fraction(const Vec3& point_mm, double near_fraction) const;

  /// As nearest_fraction, on the line or circle drawn on beyond both ends: may leave [0, 1].
  double projected_fraction(const Vec3& point_mm, double near_fraction) const;

  // Of arcs only.
  const Vec3& normal() const { return normal_; }   ///< unit; the tip runs right-handed about it
  double sweep_rad() const { return sweep_rad_; }  ///< > 0 on an arc, whole turns included
  Vec3 arm_mm(double fraction) const;              ///< from the arc's axis to the tip, across it
  double radius_change_mm() const { return radius_to_mm_ - radius_from_mm_; }
  double largest_radius_mm() const;
  double smallest_radius_mm() const;
  /// Distance of a point from the arc's axis.
  double axis_distance_mm(const Vec3& point_mm) const;

 private:
  void set_axis_turn();
  void set_arc(const Arc& arc);

  Vec3 tip_from_mm_, tip_to_mm_, axis_from_, axis_to_;
  double axis_angle_rad_ = 0.0;
  Vec3 axis_turn_ = Vec3::Zero();  ///< unit, perpendicular to axis_from_ in the plane of the turn
  double length_mm_ = 0.0;
  bool is_arc_ = false;
  Vec3 centre_mm_ = Vec3::Zero(), normal_ = Vec3::UnitZ(), radial_ = Vec3::UnitX();
  double radius_from_mm_ = 0.0, radius_to_mm_ = 0.0, height_from_mm_ = 0.0, height_to_mm_ = 0.0;
  double sweep_rad_ = 0.0;
};

}  // namespace pentapost::path
