#include "pentapost/plan/branches.hpp"

#include "pentapost/plan/state_search.hpp"

#include <algorithm>

namespace pentapost::plan {

using kinematics::Model;

JointRanges joint_ranges(const machine::Chain& chain, const Model& model) {
  JointRanges ranges;
  const auto look_at = [&](const machine::Joint& joint) {
    if (const auto* rotary = std::get_if<machine::RotaryJoint>(&joint.kind)) {
      const std::size_t index = joint.name == model.rotary_names[0] ? 0 : 1;
      if (rotary->range)
        ranges.rotary_rad[index] = {rotary->range->lower.rad(), rotary->range->upper.rad()};
      return;
    }
    const auto place = std::find(model.linear_names.begin(), model.linear_names.end(), joint.name);
    ranges.linear_mm[static_cast<std::size_t>(place - model.linear_names.begin())] =
        std::get<machine::LinearJoint>(joint.kind).range_mm;
  };
  std::for_each(chain.table().begin(), chain.table().end(), look_at);
  std::for_each(chain.head().begin(), chain.head().end(), look_at);
  return ranges;
}

OrderingSpeeds ordering_speeds(const Model& model, const Settings& settings) {
  constexpr double assumed_rad_s = 30.0 * rad_per_deg;
  constexpr double assumed_mm_s = 250.0;
  const auto speed_of = [&](const std::string& name, double assumed) {
    const auto found = settings.limits.find(name);
    return found == settings.limits.end() ? assumed : found->second.max_speed.value_or(assumed);
  };
  OrderingSpeeds speeds;
  for (std::size_t i = 0; i < 3; ++i)
    speeds.linear_mm_s[static_cast<Eigen::Index>(i)] =
        speed_of(model.linear_names[i], assumed_mm_s);
  for (std::size_t i = 0; i < 2; ++i)
    speeds.rotary_rad_s[i] = speed_of(model.rotary_names[i], assumed_rad_s);
  return speeds;
}

Result<AxisPath> choose_branches(const Model& model, const JointRanges& ranges,
                                 const path::ToolPath& tool_path, const Candidates& candidates,
                                 const Settings& settings, double gauge_length_mm,
                                 bool check_linear) {
  return StateSearch{model, ranges, tool_path, candidates, settings, gauge_length_mm, check_linear}
      .run();
}

}  // namespace pentapost::plan
