#pragma once

#include "pentapost/core/units.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace pentapost::machine {

// A larger length is a misplaced decimal point; coordinates may be as large as those of a path.
inline constexpr double largest_clearance_size_mm = 10'000.0;
inline constexpr double largest_clearance_coordinate_mm = 1e6;
inline constexpr std::size_t most_tool_cylinders = 16;

/// A piece of holder or spindle: a solid cylinder about the tool axis.
struct ToolCylinder {
  double radius_mm = 0.0;  ///< > 0
  // Heights along the tool axis; what they count from is said where the cylinder is used.
  double from_mm = 0.0, to_mm = 0.0;  ///< from < to
};

/// The table's face, with solid table below it. Base frame with all joints at zero.
struct TableDisc {
  double radius_mm = 0.0;                                     ///< > 0
  Vec3 centre_mm = Vec3::Zero();                              ///< of the face
  UnitVector normal = UnitVector::normalised(Vec3::UnitZ());  ///< out of the table
  double thickness_mm = 50.0;                                 ///< > 0
};

/// What a machine has that the tool path may collide with. nullopt: not known, not checked.
struct Clearance {
  std::optional<std::vector<ToolCylinder>> spindle = {};  ///< heights from the gauge line up
  std::optional<TableDisc> table = {};
};

}  // namespace pentapost::machine
