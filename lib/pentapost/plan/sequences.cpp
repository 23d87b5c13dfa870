#include "pentapost/plan/sequences.hpp"

namespace pentapost::plan {
namespace {

/// Tool axes that differ by more are those of another setup of the work.
constexpr double largest_link_turn_rad = 1.0 * rad_per_deg;

/// Whether the rapid to the first point of an operation turns the tool: CAM systems leave such
/// links to the postprocessor, and their straight line may lead through the part.
bool is_turning_link(const path::ToolPath& tool_path, std::uint32_t point) {
  return point > 0 && point < tool_path.size() && tool_path.move[point] == path::Move::rapid &&
         angle_between_rad(tool_path.axis_wp[point - 1], tool_path.axis_wp[point]) >
             largest_link_turn_rad;
}

}  // namespace

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
    } else if (std::holds_alternative<path::GoHome>(event.what) ||
               (std::holds_alternative<path::Operation>(event.what) &&
                is_turning_link(tool_path, event.before_point))) {
      close(event.before_point);
    }
  }
  close(size);
  return found;
}

}  // namespace pentapost::plan
