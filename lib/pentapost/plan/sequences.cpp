#include "pentapost/plan/sequences.hpp"

namespace pentapost::plan {

std::vector<Sequence> sequences(const path::ToolPath& tool_path) {
  std::vector<Sequence> found;
  const auto size = static_cast<std::uint32_t>(tool_path.size());
  int tool_number = 1;
  Sequence open{{0, 0}, tool_number};
  const auto close = [&](std::uint32_t point) {
    open.range.end = point;
    if (open.range.begin < point) found.push_back(open);
    open = {{point, point}, tool_number};
  };
  for (const auto& event : tool_path.events) {
    if (const auto* change = std::get_if<path::ToolChange>(&event.what)) {
      if (change->number == tool_number && event.before_point > open.range.begin) continue;
      tool_number = change->number;
      close(event.before_point);
      open.tool_number = tool_number;
    } else if (std::holds_alternative<path::GoHome>(event.what)) {
      close(event.before_point);
    }
  }
  close(size);
  return found;
}

}  // namespace pentapost::plan
