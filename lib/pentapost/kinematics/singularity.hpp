#pragma once

#include "pentapost/kinematics/model.hpp"

#include <optional>
#include <span>
#include <vector>

namespace pentapost::kinematics {

/// Where the rotary inverse degenerates (lib/README.md section 3).
enum class SingularityKind {
  pole,            ///< tool axis parallel to the first rotary axis, which alone diverges
  reach_boundary,  ///< the two solutions merge, both rotary rates diverge; not to be crossed
};

/// All singular tool axes of one kind and place: a point or a circle on the sphere of directions.
struct Singularity {
  SingularityKind kind = SingularityKind::pole;
  Vec3 centre = Vec3::UnitZ();  ///< unit, table frame
  double half_angle_rad = 0.0;  ///< angle of every singular tool axis to `centre`; 0 at a pole
  double opening_rad = 0.0;     ///< RotarySolutions::opening_rad there: 0 or pi
};

/// The poles and reach boundaries of a machine, at most two; none with fewer than two rotary
/// joints. A boundary narrower than 1e-9 rad counts as the pole.
std::vector<Singularity> singularities(const Model& model);

/// Angle from the tool axis `axis` (unit, table frame) to the nearest singular one of
/// `singularity`.
double distance_rad(const Singularity& singularity, const Vec3& axis);

/// The nearest of several singularities, with its distance.
struct NearestSingularity {
  Singularity singularity;
  double distance_rad = 0.0;
};
/// @return nullopt where `all` is empty.
std::optional<NearestSingularity> nearest_singularity(std::span<const Singularity> all,
                                                      const Vec3& axis);

/// Volume that the linear directions span in a posture, as a share of that with all joints at zero:
/// 1 where all linear joints stand in one place of the chain; inverse_linear() needs 1e-6 of it.
double linear_volume_ratio(const Model& model, double first_rad, double second_rad);

}  // namespace pentapost::kinematics
