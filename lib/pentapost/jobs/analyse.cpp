#include "pentapost/jobs/analyse.hpp"

#include "pentapost/analysis/cl_analysis.hpp"
#include "pentapost/core/number_text.hpp"
#include "pentapost/jobs/analyse_program.hpp"
#include "pentapost/jobs/analysis_reporter.hpp"
#include "pentapost/jobs/cures.hpp"
#include "pentapost/jobs/prepared_job.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pentapost::jobs {
namespace {

Status check_own_domain(const AnalyseJob& job) {
  if (!(job.zone_share > 0.0) || !std::isfinite(job.zone_share))
    return Problem{
        .code = Code::out_of_domain,
        .message = "found " + number_text(job.zone_share) + "; expected a number above 0",
        .pointer = "/zone_share"};
  const auto fewest = analysis::Samples::fewest;
  if (job.samples && (*job.samples < fewest || *job.samples > AnalyseJob::most_samples))
    return Problem{.code = Code::out_of_domain,
                   .message = "found " + std::to_string(*job.samples) + "; expected " +
                              std::to_string(fewest) + " to " +
                              std::to_string(AnalyseJob::most_samples),
                   .pointer = "/max_samples"};
  return ok();
}

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

std::ptrdiff_t retracts_of(const analysis::PathAnalysis& analysis) {
  return std::count_if(analysis.repositionings.begin(), analysis.repositionings.end(),
                       [](const analysis::Repositioning& each) {
                         return each.kind == analysis::Repositioning::Kind::retract;
                       });
}

/// The analysis of the bent path. Where a program would be planned without the bends, since they
/// make it fail or cost a retract, the CL's own path is analysed and `bent` is emptied.
Result<analysis::PathAnalysis> analyse_with_bends(const AnalyseJob& job,
                                                  const PreparedJob& prepared,
                                                  plan::PoleBends& bent) {
  const auto along = [&](const path::ToolPath& tool_path) {
    return analysis::analyse_path(prepared.model, prepared.ranges, tool_path, prepared.settings,
                                  {.share = job.zone_share, .most_samples = job.samples});
  };
  if (bent.bends.empty()) return along(prepared.read.tool_path);
  auto with_bends = along(bent.tool_path);
  if (with_bends && retracts_of(*with_bends) == 0) return with_bends;
  auto without = along(prepared.read.tool_path);
  if (with_bends && (!without || retracts_of(*with_bends) <= retracts_of(*without)))
    return with_bends;
  bent = {};
  return without;
}

}  // namespace

Result<AnalyseReport> analyse(const AnalyseJob& job) {
  if (auto status = check_own_domain(job); !status) return std::move(status).error();
  if (job.nc) return analyse_program(job);
  auto prepared = prepare(job.job);
  if (!prepared) return std::move(prepared).error();
  expand_holes(*prepared, [](std::uint32_t) { return false; });
  auto bent = bend_at_poles(*prepared);
  warn_of_assumptions(job.job, *prepared);
  auto analysis = analyse_with_bends(job, *prepared, bent);
  if (!analysis) return std::move(analysis).error();

  const path::ToolPath& tool_path = bent.bends.empty() ? prepared->read.tool_path : bent.tool_path;
  AnalyseReport report;
  static_cast<ReportHead&>(report) = report_head(job.job, prepared->read);
  report.points = tool_path.size();
  if (!bent.bends.empty()) report.pole_axis_change_deg = bent.largest_change_rad * deg_per_rad;
  const ReportFrame frame{.model = prepared->model,
                          .ranges = prepared->ranges,
                          .settings = prepared->settings,
                          .to_cl = turn_of(job.job.setup).transpose(),
                          .linear_known = job.job.setup.origin_mm.has_value()};
  if (auto status = report_analysis(frame, std::move(*analysis), report); !status)
    return std::move(status).error();
  find_cures(job, *prepared, tool_path, report.zones);
  report.diagnostics = std::move(prepared->read.diagnostics);
  return report;
}

}  // namespace pentapost::jobs
