#pragma once

#include "pentapost/plan/branches.hpp"

#include <optional>

namespace pentapost::plan {

/// The answer of choose_branches() where one solution is the cheapest beyond doubt and keeps its
/// turns from the first point to the last: off the poles and the edge of the reach, without a
/// repositioning. Most paths are such, and this costs a third of the whole search.
///
/// @param range, zone  see find_candidates().
/// @return nullopt: choose_branches() has to decide, or to say what is wrong.
std::optional<AxisPath> plain_choice(const kinematics::Model& model, const JointRanges& ranges,
                                     const path::ToolPath& tool_path, PointRange range,
                                     const PoleZone& zone, const Settings& settings,
                                     double gauge_length_mm, bool check_linear);

}  // namespace pentapost::plan
