#include "pentapost/jobs/analyse_prepared.hpp"

#include "pentapost/analysis/cl_analysis.hpp"
#include "pentapost/jobs/analysis_reporter.hpp"
#include "pentapost/jobs/bends.hpp"
#include "pentapost/jobs/cures.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace pentapost::jobs {
namespace {

/// What the speeds of the linear axes rest on and the job does not say.
void warn_of_assumptions(const PostJob& job, PreparedJob& prepared) {
  Diagnostics& diagnostics = prepared.read.diagnostics;
  const auto missing = missing_gauge_length(job, prepared.read.tool_path);
  if (missing && prepared.model.head_turns)
    diagnostics.add({Severity::warning, Code::gauge_length_assumed, 0,
                     "the gauge length of tool " + std::to_string(*missing) +
                         " is not given and counts as 0: the speeds of the linear axes depend on "
                         "it"});
  const auto table = job.machine.chain.table();
  const bool table_turns = std::any_of(table.begin(), table.end(),
                                       [](const machine::Joint& each) { return each.is_rotary(); });
  if (table_turns && !job.setup.origin_mm)
    diagnostics.add({Severity::warning, Code::origin_assumed, 0,
                     "the setup's origin is not given and counts as 0, 0, 0: the speeds of the "
                     "linear axes depend on it"});
  warn_of_unchecked_ranges(job, prepared.ranges, missing, diagnostics);
}

}  // namespace

Result<AnalyseReport> analyse_prepared(const AnalyseJob& job, PreparedJob& prepared,
                                       CureSearch cures) {
  expand_holes(prepared, [](std::uint32_t) { return false; });
  const auto bent = bend_at_poles(prepared, prepared.settings);
  const path::ToolPath& tool_path = bent.bends.empty() ? prepared.read.tool_path : bent.tool_path;
  warn_of_assumptions(job.job, prepared);
  auto analysis =
      analysis::analyse_path(prepared.model, prepared.ranges, tool_path, prepared.settings,
                             {.share = job.zone_share, .most_samples = job.samples});
  if (!analysis) return std::move(analysis).error();

  AnalyseReport report;
  static_cast<ReportHead&>(report) = report_head(job.job, prepared.read);
  report.points = tool_path.size();
  if (!bent.bends.empty()) report.pole_axis_change_deg = bent.largest_change_rad * deg_per_rad;
  const ReportFrame frame{.model = prepared.model,
                          .ranges = prepared.ranges,
                          .settings = prepared.settings,
                          .to_cl = turn_of(job.job.setup).transpose(),
                          .linear_known = job.job.setup.origin_mm.has_value()};
  if (auto status = report_analysis(frame, std::move(*analysis), report); !status)
    return std::move(status).error();
  if (cures == CureSearch::all) find_cures(job, prepared, tool_path, report.zones);
  report.diagnostics = std::move(prepared.read.diagnostics);
  return report;
}

}  // namespace pentapost::jobs
