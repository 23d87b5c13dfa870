#include "pentapost/plan/sequences.hpp"

namespace pentapost::plan {

bool keeps_tool(const path::ToolChange& in_use, const path::ToolChange& next) {
  return next.number == in_use.number &&
         (!next.length_register || next.length_register == in_use.length_register);
}

std::vector<Sequence> sequences(const path::ToolPath& tool_path) {
  std::vector<Sequence> found;
  const auto size = static_cast<std::uint32_t>(tool_path.size());
  path::ToolChange tool{.number = 1};
  Sequence open{{0, 0}, tool.number};
  const auto close = [&](std::uint32_t point) {
    open.range.end = point;
    if (open.range.begin < point) found.push_back(open);
    open = {{point, point}, tool.number};
  };
  for (const auto& event : tool_path.events) {
    if (const auto* change = std::get_if<path::ToolChange>(&event.what)) {
      if (keeps_tool(tool, *change) && event.before_point > open.range.begin) continue;
      tool = *change;
      close(event.before_point);
      open.tool_number = tool.number;
    } else if (std::holds_alternative<path::GoHome>(event.what)) {
      close(event.before_point);
    }
  }
  close(size);
  return found;
}

}  // namespace pentapost::plan
