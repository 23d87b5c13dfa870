#include "pentapost/plan/choice.hpp"

#include "pentapost/plan/plain_choice.hpp"

#include <algorithm>
#include <utility>

namespace pentapost::plan {

Result<Choice> choose(const kinematics::Model& model, const JointRanges& ranges,
                      const path::ToolPath& tool_path, PointRange range, const Settings& settings,
                      double gauge_length_mm, bool check_linear) {
  const double freedom_rad = axis_freedom_rad(settings.axis_tolerance_rad, settings.flank);
  const PoleZone zone = pole_zone(model, tool_path.axis_rounding_rad, freedom_rad);
  Choice choice;
  choice.slack_rad = std::min(std::max(tool_path.axis_rounding_rad, freedom_rad),
                              0.5 * settings.axis_tolerance_rad);
  if (auto plain = plain_choice(model, ranges, tool_path, range, zone, settings, gauge_length_mm,
                                check_linear)) {
    choice.axis_path = *std::move(plain);
    return choice;
  }
  auto candidates = find_candidates(model, tool_path, range, zone, choice.slack_rad);
  if (!candidates) return std::move(candidates).error();
  auto chosen = choose_branches(model, ranges, tool_path, *candidates, settings, gauge_length_mm,
                                check_linear);
  if (!chosen) return std::move(chosen).error();
  choice.axis_path = std::move(chosen).value();
  choice.axis_change_rad = candidates->largest_freedom_rad;
  return choice;
}

}  // namespace pentapost::plan
