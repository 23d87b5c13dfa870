#pragma once

#include "pentapost/core/codes.hpp"
#include "pentapost/json/strict_reader.hpp"
#include "pentapost/machine/clearance.hpp"

#include <string_view>
#include <vector>

namespace pentapost::json {

// What stands alike in a machine definition and in a request.
// @param contradiction  the code of values that are right by themselves and not together.

/// [{"radius_mm", "from_mm", "to_mm"}], at most most_tool_cylinders of them.
std::vector<machine::ToolCylinder> read_tool_cylinders(const Array& array, Code contradiction);

/// {"radius_mm", "centre_mm", "normal", "thickness_mm"}: all but the radius have a default.
machine::TableDisc read_table_disc(const Object& object, Code contradiction);

/// A point no coordinate of which is beyond largest_clearance_coordinate_mm.
Vec3 read_clearance_point(const Object& object, std::string_view key);

}  // namespace pentapost::json
