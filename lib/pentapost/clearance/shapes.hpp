#pragma once

#include "pentapost/core/units.hpp"

#include <variant>

namespace pentapost::clearance {

/// A solid cylinder.
struct Cylinder {
  Vec3 centre_mm = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();  ///< unit
  double half_length_mm = 0.0, radius_mm = 0.0;
};

/// A solid box.
struct Box {
  Vec3 centre_mm = Vec3::Zero();
  Mat3 directions = Mat3::Identity();  ///< columns: unit vectors along its edges
  Vec3 half_size_mm = Vec3::Zero();
};

using Obstacle = std::variant<Cylinder, Box>;

/// A lower bound of the distance: the widest gap between the projections of both bodies onto a few
/// directions. Never above the distance but by rounding; exact where faces or rims meet head on.
double distance_bound_mm(const Cylinder& tool, const Obstacle& obstacle);

/// Whether distance_bound_mm(), or that of balls about the bodies, is above `margin_mm`: cheap.
bool bound_exceeds(const Cylinder& tool, const Obstacle& obstacle, double margin_mm);

/// Whether the distance of the two bodies can be `margin_mm` or less. A "no" is certain, and in
/// rare symmetric places a "yes" is wrong.
bool may_be_within(const Cylinder& tool, const Obstacle& obstacle, double margin_mm);

/// Whether the distance of the two bodies is `margin_mm` or less, to 1e-4 mm.
bool is_within(const Cylinder& tool, const Obstacle& obstacle, double margin_mm);

/// Distance of two bodies that are within `margin_mm`, to 1e-3 mm; 0: they touch or overlap.
double distance_within_mm(const Cylinder& tool, const Obstacle& obstacle, double margin_mm);

}  // namespace pentapost::clearance
