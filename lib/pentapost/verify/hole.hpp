#pragma once

#include "pentapost/nc/reader.hpp"
#include "pentapost/path/tool_path.hpp"
#include "pentapost/verify/block_deviation.hpp"
#include "pentapost/verify/tool_position.hpp"

#include <optional>
#include <string>

namespace pentapost::verify {

/// The levels of a hole on the drilling axis, CL frame.
struct HoleLevels {
  Vec3 bottom_mm, clearance_mm, retract_mm;
};

/// Where a cycle drills at a reference point.
HoleLevels hole_levels(const path::CycleStart& cycle, const Vec3& reference_mm, const Vec3& axis);

/// How far a drilled hole is off: the largest over its levels, and the tool axis against the
/// drilling axis.
Deviation hole_deviation(const HoleLevels& expected, const Vec3& axis, const Stop& bottom,
                         const Stop& clearance, const Stop& retract);

/// What is wrong with the way across to a hole; empty: nothing. Below where the tool was or where
/// it is to start there may be a part of the work.
/// @param from, clearance  the tool before the cycle, and where its feed starts.
/// @param travel  the tool over the hole at the level of the way across; nullopt: not known.
/// @param last_mm  where the CL data have the tool before; nullopt: it comes from a tool change,
///                 from home or with another tool axis.
/// @param limit  how far the places may be off the CL data.
std::string wrong_travel(const Stop& from, const Stop& clearance, const std::optional<Stop>& travel,
                         const std::optional<Vec3>& last_mm, const Vec3& axis,
                         const Deviation& limit);

/// What is wrong with pecks and dwell; empty: nothing.
/// @param length_rounding_mm  last digit printed.
std::string wrong_cycle_data(const nc::ReadMotion& motion, const path::CycleStart& cycle,
                             double length_rounding_mm);

}  // namespace pentapost::verify
