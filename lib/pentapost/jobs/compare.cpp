#include "pentapost/jobs/compare.hpp"

#include "pentapost/jobs/analyse_prepared.hpp"
#include "pentapost/jobs/compare_rows.hpp"
#include "pentapost/jobs/job_domain.hpp"
#include "pentapost/jobs/prepared_job.hpp"
#include "pentapost/jobs/tool_path.hpp"
#include "pentapost/nc/dialect.hpp"
#include "pentapost/plan/program.hpp"

#include <algorithm>
#include <utility>

namespace pentapost::jobs {
namespace {

using machine::Definition;

const machine::Joint* find_joint(const Definition& machine, const std::string& name) {
  for (const auto joints : {machine.chain.table(), machine.chain.head()})
    for (const machine::Joint& joint : joints)
      if (joint.name == name) return &joint;
  return nullptr;
}

/// A limit is a number of mm or of degrees, so its axis is the same kind on every machine.
Status check_limit(const CompareJob& job, const std::string& name) {
  const auto refused = [&name](std::string message) {
    return Problem{
        .code = Code::out_of_domain, .message = std::move(message), .pointer = "/limits/" + name};
  };
  bool rotary = false, linear = false;
  for (const Definition& machine : job.machines)
    if (const auto* const joint = find_joint(machine, name))
      (joint->is_rotary() ? rotary : linear) = true;
  if (!rotary && !linear) return refused("no machine has an axis of that name");
  if (rotary && linear)
    return refused("the axis of that name is rotary on one machine and linear on another");
  return ok();
}

/// What is wrong with the job whatever the machine.
Status check_own_domain(const CompareJob& job) {
  if (job.machines.empty() || job.machines.size() > CompareJob::most_machines)
    return Problem{.code = Code::out_of_domain,
                   .message = "found " + std::to_string(job.machines.size()) +
                              " machines; expected 1 to " +
                              std::to_string(CompareJob::most_machines),
                   .pointer = "/machines"};
  if (auto status = check_domain(job.job); !status) return status;
  if (auto status = check_zone_share(job.zone_share); !status) return status;
  if (const auto& dialect = job.job.post.dialect; dialect && nc::find_dialect(*dialect) == nullptr)
    return Problem{.code = Code::unknown_dialect,
                   .message = "there is no dialect " + *dialect,
                   .pointer = "/post/dialect"};
  for (const auto& [name, limits] : job.job.limits)
    if (auto status = check_limit(job, name); !status) return status;
  return ok();
}

std::map<std::string, machine::AxisLimits> limits_for(const PostJob& job,
                                                      const Definition& machine) {
  auto limits = job.limits;
  std::erase_if(limits,
                [&](const auto& each) { return find_joint(machine, each.first) == nullptr; });
  return limits;
}

/// The job for one machine, without the path.
PostJob job_for(const PostJob& job, const Definition& machine) {
  return {.machine = machine,
          .path = ClText{},
          .setup = job.setup,
          .gauge_length_mm = job.gauge_length_mm,
          .tolerances = job.tolerances,
          .post = job.post,
          .limits = limits_for(job, machine)};
}

CompareFigures figures_of(AnalyseReport report) {
  CompareFigures figures{.programmed_time_s = report.programmed_time_s,
                         .predicted_time_s = report.predicted_time_s,
                         .repositioning_time_s = report.repositioning_time_s,
                         .closest_approach_deg = report.closest_approach_deg,
                         .pole_axis_change_deg = report.pole_axis_change_deg,
                         .zones = report.zones.total,
                         .over_demands = report.over_demands.total,
                         .zones_time_lost_s = report.zones.time_lost_s,
                         .over_demands_time_lost_s = report.over_demands.time_lost_s,
                         .diagnostics = std::move(report.diagnostics)};
  figures.retracts = static_cast<std::uint64_t>(std::count_if(
      report.repositionings.begin(), report.repositionings.end(),
      [](const auto& each) { return each.kind == analysis::Repositioning::Kind::retract; }));
  for (const AxisDemandReport& axis : report.axes) {
    if (!axis.peak_ratio)
      figures.axes_without_limit.push_back(axis.name);
    else if (!figures.peak || *axis.peak_ratio > *figures.peak->peak_ratio)
      figures.peak = axis;
  }
  figures.within_limits = !(report.peak_ratio.value_or(0.0) > 1.0);
  if (figures.axes_without_limit.empty())
    figures.limits_known = LimitsKnown::all;
  else if (figures.peak)
    figures.limits_known = LimitsKnown::some;
  return figures;
}

/// @param read  is copied: the holes and the setup change it.
Result<CompareFigures> figures_for(const CompareJob& job, const ReadPath& read,
                                   const Definition& machine) {
  const AnalyseJob own{.job = job_for(job.job, machine), .zone_share = job.zone_share};
  auto prepared = prepare_read(own.job, {.tool_path = read.tool_path,
                                         .cl_dialect = {},
                                         .cl_units = read.cl_units,
                                         .lines = read.lines,
                                         .points = read.points,
                                         .diagnostics = {}});
  if (!prepared) return std::move(prepared).error();
  const path::ToolPath& tool_path = prepared->read.tool_path;
  if (auto status = plan::check_plannable(prepared->model, tool_path, prepared->settings); !status)
    return std::move(status).error();
  const auto missing = missing_gauge_length(own.job, tool_path);
  if (const auto status = check_gauge_length(own.job, *prepared, missing); !status)
    prepared->read.diagnostics.add(
        {Severity::warning, status.error().code, 0, status.error().message});
  auto report = analyse_prepared(own, *prepared, CureSearch::none);
  if (!report) return std::move(report).error();
  return figures_of(std::move(*report));
}

Result<CompareReorientation> reorientation_for(ReorientJob& asked, const CompareJob& job,
                                               const Definition& machine) {
  asked.job.machine = machine;
  asked.job.limits = limits_for(job.job, machine);
  auto report = reorient(asked);
  if (!report) return std::move(report).error();
  return CompareReorientation{.best = std::move(report->best),
                              .optimality_gap = report->optimality_gap,
                              .obstacle = std::move(report->obstacle)};
}

/// What the job's numbers make impossible on every machine is the job's fault, not theirs.
std::optional<Problem> fault_of_the_job(const std::vector<CompareRow>& rows) {
  const bool everywhere = std::all_of(rows.begin(), rows.end(), [](const CompareRow& row) {
    return !row.figures && row.figures.error().code == Code::out_of_domain;
  });
  if (everywhere) return rows.front().figures.error();
  for (const CompareRow& row : rows) {
    if (!row.reorientation || *row.reorientation) continue;
    const Problem& problem = row.reorientation->error();
    const bool of_the_job =
        problem.code == Code::out_of_domain || problem.code == Code::conflicting_keys;
    if (!of_the_job || problem.pointer.empty()) continue;
    Problem placed = problem;
    placed.pointer.insert(0, "/reorient");
    return placed;
  }
  return std::nullopt;
}

}  // namespace

Result<CompareReport> compare(const CompareJob& job) {
  if (auto status = check_own_domain(job); !status) return std::move(status).error();
  auto read = read_path(job.job);
  if (!read) return std::move(read).error();
  CompareReport report;
  static_cast<ReportHead&>(report) = report_head(job.job, *read);
  report.machine_name = report.machine_version = report.machine_sha256 = {};
  report.diagnostics = std::move(read->diagnostics);

  RowWork work{
      .figures = [&](const Definition& machine) { return figures_for(job, *read, machine); }};
  auto asked = job.reorient;
  if (asked) {
    report.objective = asked->objective;
    asked->job = job.job;
    asked->candidates.clear();
    asked->map_step_deg.reset();
    work.reorientation = [&](const Definition& machine) {
      return reorientation_for(*asked, job, machine);
    };
  }
  report.rows = compare_rows(job, work);
  if (auto problem = fault_of_the_job(report.rows)) return *std::move(problem);
  return report;
}

}  // namespace pentapost::jobs
