#include "pentapost/jobs/bends.hpp"

#include "pentapost/analysis/cl_analysis.hpp"

#include <algorithm>
#include <cstddef>

namespace pentapost::jobs {
namespace {

using analysis::PathAnalysis;

std::ptrdiff_t retracts_of(const PathAnalysis& analysis) {
  return std::count_if(analysis.repositionings.begin(), analysis.repositionings.end(),
                       [](const analysis::Repositioning& each) {
                         return each.kind == analysis::Repositioning::Kind::retract;
                       });
}

/// Largest ratio of any axis; where no axis has a limit, the speed of the one that a pole
/// multiplies.
double load_of(const PathAnalysis& analysis) {
  double largest = 0.0;
  for (const analysis::AxisPeak& peak : analysis.peaks) largest = std::max(largest, peak.ratio);
  return largest > 0.0 ? largest : analysis.peaks[analysis::first_axis].speed;
}

bool is_worthwhile(const PathAnalysis& bent, const PathAnalysis& own) {
  constexpr double rounding = 1.0 + 1e-9;
  return retracts_of(bent) <= retracts_of(own) && load_of(bent) <= rounding * load_of(own) &&
         bent.predicted_time_s <= rounding * own.predicted_time_s;
}

}  // namespace

plan::PoleBends bend_at_poles(const PreparedJob& prepared, const plan::Settings& settings) {
  const auto& own_path = prepared.read.tool_path;
  auto bent = plan::bend_at_poles(prepared.model, prepared.ranges, settings, own_path);
  if (bent.bends.empty()) return bent;
  const auto analysed = [&](const path::ToolPath& tool_path) {
    return analysis::analyse_path(prepared.model, prepared.ranges, tool_path, settings, {});
  };
  const auto with_bends = analysed(bent.tool_path);
  if (!with_bends) return {};
  const auto own = analysed(own_path);
  if (own && !is_worthwhile(*with_bends, *own)) return {};
  return bent;
}

}  // namespace pentapost::jobs
