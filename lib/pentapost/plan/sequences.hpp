#pragma once

#include "pentapost/path/tool_path.hpp"
#include "pentapost/plan/candidates.hpp"

#include <vector>

namespace pentapost::plan {

/// A stretch of the path that starts with a positioning: the program's start, another tool, the
/// return from home, or an operation that a rapid with another tool axis leads to. Rotary solutions
/// are chosen for each by itself.
struct Sequence {
  PointRange range;
  int tool_number = 1;
};

/// Whether a tool change leaves the tool in use where it is: the same number and length register.
bool keeps_tool(const path::ToolChange& in_use, const path::ToolChange& next);

/// Every point belongs to one sequence, in order. A path that names no tool is cut with tool 1.
std::vector<Sequence> sequences(const path::ToolPath& tool_path);

}  // namespace pentapost::plan
