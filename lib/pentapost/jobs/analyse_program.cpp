#include "pentapost/jobs/analyse_program.hpp"

#include "pentapost/core/sha256.hpp"
#include "pentapost/jobs/analysis_reporter.hpp"
#include "pentapost/jobs/nc_path.hpp"
#include "pentapost/jobs/prepared_job.hpp"
#include "pentapost/plan/block_maker.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace pentapost::jobs {
namespace {

Status check_setup(const Setup& setup) {
  if (setup.theta_x_deg == 0.0 && setup.theta_z_deg == 0.0) return ok();
  return Problem{.code = Code::conflicting_keys,
                 .message = "an NC program contains the turn of the workpiece already",
                 .pointer = setup.theta_x_deg != 0.0 ? "/setup/theta_x_deg" : "/setup/theta_z_deg"};
}

Result<PreparedJob> prepare_for(const AnalyseJob& job) {
  PostJob asked = job.job;
  if (!job.nc->dialect) return prepare_unread(asked);
  asked.post.dialect = job.nc->dialect;
  auto prepared = prepare_unread(asked);
  if (prepared) return prepared;
  Problem problem = std::move(prepared).error();
  if (problem.pointer == "/post/dialect") problem.pointer = "/nc_dialect";
  return problem;
}

/// What the speeds of the linear axes rest on and the job does not say.
void warn_of_assumptions(const PostJob& job, const PreparedJob& prepared, NcAnalysis& found) {
  if (found.missing_gauge && prepared.model.head_turns)
    found.diagnostics.add({Severity::warning, Code::gauge_length_assumed, 0,
                           "the gauge length of tool " + std::to_string(*found.missing_gauge) +
                               " is not given and counts as 0: the speeds of the linear axes "
                               "depend on it"});
  const auto table = job.machine.chain.table();
  const bool table_turns = std::any_of(table.begin(), table.end(),
                                       [](const machine::Joint& each) { return each.is_rotary(); });
  if (table_turns && !job.setup.origin_mm && found.output == Output::tcp)
    found.diagnostics.add({Severity::warning, Code::origin_assumed, 0,
                           "the setup's origin is not given and counts as 0, 0, 0: the speeds of "
                           "the linear axes depend on it"});
}

ReportHead head_of(const AnalyseJob& job, const Control& control, const NcAnalysis& found) {
  return {.machine_name = job.job.machine.name,
          .machine_version = job.job.machine.version,
          .machine_sha256 = job.job.machine.sha256,
          .nc_sha256 = sha256_hex(job.nc->text),
          .nc_dialect = std::string{control.dialect->name},
          .nc_lines = found.lines,
          .nc_blocks = found.blocks};
}

}  // namespace

Result<AnalyseReport> analyse_program(const AnalyseJob& job) {
  if (auto status = check_setup(job.job.setup); !status) return std::move(status).error();
  const auto prepared = prepare_for(job);
  if (!prepared) return prepared.error();
  const NcSource source{.text = job.nc->text,
                        .reader = *prepared->control.reader,
                        .setup = {.letters = plan::word_columns(prepared->model).letters,
                                  .options = prepared->control.options}};
  auto found = analyse_nc(prepared->model, source, prepared->settings,
                          {.share = job.zone_share, .most_samples = job.samples});
  if (!found) return std::move(found).error();
  warn_of_assumptions(job.job, *prepared, *found);

  AnalyseReport report;
  static_cast<ReportHead&>(report) = head_of(job, prepared->control, *found);
  report.points = found->blocks;
  const ReportFrame frame{
      .model = prepared->model,
      .ranges = prepared->ranges,
      .settings = prepared->settings,
      .to_cl = Mat3::Identity(),
      .linear_known = job.job.setup.origin_mm.has_value() || found->output == Output::axes};
  if (auto status = report_analysis(frame, std::move(found->analysis), report); !status)
    return std::move(status).error();
  report.diagnostics = std::move(found->diagnostics);
  return report;
}

}  // namespace pentapost::jobs
