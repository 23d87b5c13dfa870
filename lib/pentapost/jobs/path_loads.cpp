#include "pentapost/jobs/path_loads.hpp"

#include "pentapost/analysis/path_analysis.hpp"
#include "pentapost/plan/candidates.hpp"
#include "pentapost/reorient/piece.hpp"

#include <algorithm>

namespace pentapost::jobs {

reorient::PathLoads path_loads(const PreparedJob& prepared, bool check_linear) {
  const plan::Settings& settings = prepared.settings;
  const analysis::Allowance allowance{analysis::speed_limits(prepared.model, settings), 1.0};
  const auto& time_per_way_s = allowance.time_per_way_s;
  const bool has_linear =
      std::any_of(time_per_way_s.begin(), time_per_way_s.begin() + analysis::first_axis,
                  [](double each) { return each > 0.0; });
  const double freedom_rad = plan::axis_freedom_rad(settings.axis_tolerance_rad, settings.flank);
  const bool wants_negative = settings.preferences.tilt == machine::Preferences::Tilt::negative;
  return {prepared.model,
          reorient::pieces_of(prepared.read.tool_path, settings),
          {.shares = {.time_per_way_s = time_per_way_s, .has_linear = has_linear},
           .ranges = prepared.ranges,
           .check_linear = check_linear,
           .slack_rad = std::max(prepared.read.tool_path.axis_rounding_rad, freedom_rad),
           .preferred_branch = wants_negative ? 1 : 0,
           .rule = {prepared.model, prepared.ranges, settings, prepared.read.tool_path}}};
}

bool has_speed_limit(const PreparedJob& prepared) {
  const auto limits = analysis::speed_limits(prepared.model, prepared.settings);
  return std::any_of(limits.begin(), limits.end(),
                     [](const auto& limit) { return limit.has_value(); });
}

}  // namespace pentapost::jobs
