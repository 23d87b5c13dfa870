#pragma once

#include "pentapost/core/units.hpp"
#include "pentapost/machine/clearance.hpp"

#include <cstddef>
#include <vector>

namespace pentapost::clearance {

inline constexpr std::size_t most_jig_boxes = 32;
inline constexpr double default_safety_mm = 2.0, largest_safety_mm = 1000.0;

/// A piece of the jig: a box along the axes of its frame.
struct JigBox {
  enum class Frame {
    table,      ///< base frame with all joints at zero; stays when the part is turned
    workpiece,  ///< CL coordinates; turns with the part
  };
  Vec3 min_mm = Vec3::Zero(), max_mm = Vec3::Zero();  ///< min < max in each coordinate
  Frame frame = Frame::table;
};

/// What may collide: the holder and the spindle of the tool with the table and the jig.
struct Model {
  machine::Clearance machine = {};
  std::vector<machine::ToolCylinder> holder = {};  ///< heights from the tool tip up; of every tool
  std::vector<JigBox> jig = {};
  double safety_mm = default_safety_mm;  ///< distance that must remain; >= 0
};

}  // namespace pentapost::clearance
