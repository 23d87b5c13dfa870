#include "pentapost/jobs/post.hpp"

#include "pentapost/jobs/bends.hpp"
#include "pentapost/jobs/post_zones.hpp"
#include "pentapost/jobs/prepared_job.hpp"
#include "pentapost/jobs/unproven.hpp"
#include "pentapost/nc/dialect.hpp"
#include "pentapost/plan/drilling.hpp"
#include "pentapost/plan/program.hpp"
#include "pentapost/verify/proof.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

namespace pentapost::jobs {
namespace {

/// What the absence of a tool's gauge length means for the words.
Status check_gauge_lengths(const PostJob& job, PreparedJob& prepared) {
  const auto missing = missing_gauge_length(job, prepared.read.tool_path);
  if (auto status = check_gauge_length(job, prepared, missing); !status) return status;
  Diagnostics& diagnostics = prepared.read.diagnostics;
  if (missing && prepared.control.output == Output::axes)
    diagnostics.add(
        {Severity::warning, Code::gauge_length_assumed, 0,
         "the gauge length of tool " + std::to_string(*missing) + " is not given and counts as 0"});
  warn_of_unchecked_ranges(job, prepared.ranges, missing, diagnostics);
  return ok();
}

std::vector<AxisReport> axis_reports(const plan::JointRanges& ranges,
                                     const kinematics::Model& model, const plan::Settings& settings,
                                     const plan::WordColumns& columns, const verify::Proof& proof) {
  std::vector<AxisReport> axes;
  for (std::size_t column = 0; column < static_cast<std::size_t>(columns.count); ++column) {
    AxisReport axis;
    axis.name = columns.letters.substr(column, 1);
    axis.rotary = column >= 3;
    axis.min = proof.spans[column].min;
    axis.max = proof.spans[column].max;
    const double unit = axis.rotary ? deg_per_rad : 1.0;
    const std::size_t joint = axis.rotary && axis.name != model.rotary_names[0] ? 1 : 0;
    const auto& range = axis.rotary ? ranges.rotary_rad[joint] : ranges.linear_mm[column];
    if (range) axis.range = Range<double>{range->lower * unit, range->upper * unit};
    if (const auto limit = settings.limits.find(axis.name); limit != settings.limits.end())
      if (limit->second.max_speed) axis.speed_limit = *limit->second.max_speed * unit;
    axes.push_back(std::move(axis));
  }
  return axes;
}

path::ProgramHeader header_of(const PostJob& job, const path::ToolPath& tool_path) {
  constexpr std::size_t short_hash_digits = 12;
  const std::string& own =
      tool_path.program_name.empty() ? job.post.default_program_name : tool_path.program_name;
  return {.program_name = job.post.program_name.value_or(own),
          .machine = job.machine.name + "@" + job.machine.version,
          .machine_hash = job.machine.sha256.substr(0, short_hash_digits),
          .comments = {}};
}

/// The program of a job, and its proof.
Result<verify::Proof> write_and_prove(const PostJob& job, const Control& control,
                                      const kinematics::Model& model,
                                      const plan::Settings& settings,
                                      const path::ToolPath& tool_path,
                                      std::span<const Vec3> planned_axis_wp,
                                      const path::Motion& motion, std::string& nc) {
  const auto header = header_of(job, tool_path);
  verify::Claim claim{.tool_path = tool_path,
                      .model = model,
                      .motion = motion,
                      .reader_setup = {.letters = motion.letters},
                      .output = control.output,
                      .origin_mm = settings.origin_mm,
                      .gauge_length_mm = job.gauge_length_mm,
                      .tip_tolerance_mm = settings.tip_tolerance_mm,
                      .axis_tolerance_rad = settings.axis_tolerance_rad,
                      .planned_axis_wp = planned_axis_wp,
                      .pole_axis_rad = settings.pole_axis_rad,
                      .keep_text_lines = job.post.line_map};
  const auto with = [&](const machine::Options& options,
                        std::string& text) -> Result<verify::Proof> {
    if (auto status = control.dialect->write(motion, header, options, text); !status)
      return std::move(status).error();
    claim.reader_setup.options = options;
    return verify::prove(text, *control.reader, claim);
  };
  auto proof = with(control.options, nc);
  if (proof || proof.error().code != Code::proof_failed) return proof;
  return unproven(std::move(proof).error(), *control.dialect, control.options, tool_path,
                  [&](const machine::Options& options) {
                    std::string text;
                    return with(options, text).has_value();
                  });
}

/// The program of the bent path. Where its bends make it fail, or cost a retract, the CL's own path
/// is planned.
Result<plan::Program> plan_with_bends(const PreparedJob& prepared, plan::PoleBends& bent) {
  const auto& [control, read, model, ranges, settings] = prepared;
  if (bent.bends.empty()) return plan::plan_program(model, ranges, read.tool_path, settings);
  auto with_bends = plan::plan_program(model, ranges, bent.tool_path, settings);
  if (with_bends && with_bends->retracts.empty()) return with_bends;
  auto without = plan::plan_program(model, ranges, read.tool_path, settings);
  if (with_bends && (!without || with_bends->retracts.size() <= without->retracts.size()))
    return with_bends;
  bent = {};
  return without;
}

/// What the planning refuses, with the place in the job.
Problem placed(Problem problem) {
  if (problem.code == Code::tolerance_below_digits && problem.pointer.empty())
    problem.pointer = "/tolerances";
  return problem;
}

}  // namespace

Status check_options(const machine::Definition& definition) {
  const auto* const dialect = nc::find_dialect(definition.controller.dialect);
  if (dialect == nullptr)
    return Problem{.code = Code::unknown_dialect,
                   .message = "there is no dialect " + definition.controller.dialect,
                   .pointer = "/controller/dialect"};
  auto abilities = dialect->abilities(definition.controller.options);
  if (!abilities) return std::move(abilities).error();
  return ok();
}

Result<PostReport> post(const PostJob& job) {
  auto prepared = prepare(job);
  if (!prepared) return std::move(prepared).error();
  auto& [control, read, model, ranges, settings] = *prepared;
  expand_holes(*prepared, plan::native_holes(model, read.tool_path, settings));
  if (auto status = check_gauge_lengths(job, *prepared); !status) return std::move(status).error();
  auto bent = bend_at_poles(*prepared, settings);
  auto program = plan_with_bends(*prepared, bent);
  if (!program) return placed(std::move(program).error());

  PostReport report;
  report.length_mm = program->length_mm;
  report.programmed_time_s = program->programmed_time_s;
  const path::ToolPath& planned = bent.bends.empty() ? read.tool_path : bent.tool_path;
  report_zones(job, *prepared, planned, *program, report);
  if (job.post.zone_comments) comment_zones(report, planned, program->motion);
  // What is proven is how far the program leaves the CL data, not the plan.
  std::vector<Vec3> planned_axis_wp;
  if (!bent.bends.empty()) {
    read.tool_path = std::move(bent.tool_path);
    planned_axis_wp = std::exchange(read.tool_path.axis_wp, std::move(bent.cl_axis_wp));
  }
  const auto proof = write_and_prove(job, control, model, settings, read.tool_path, planned_axis_wp,
                                     program->motion, report.nc);
  if (!proof) return proof.error();

  static_cast<ReportHead&>(report) = report_head(job, read);
  if (const auto* const lint = nc::find_lint(control.dialect->name); lint && job.post.lint)
    report.lint =
        lint->look(report.nc, {.letters = program->motion.letters, .options = control.options});
  report.dialect = control.dialect->name;
  report.output = control.output;
  report.blocks = program->motion.blocks.size();
  report.inserted_points = program->inserted_points + bent.inserted_points;
  report.insertions = inserted_stretches(program->motion, read.tool_path);
  if (job.post.line_map)
    report.line_map = line_map(program->motion, read.tool_path, proof->text_lines);
  report.pole_axis_change_deg =
      std::max(program->axis_change_rad, bent.largest_change_rad) * deg_per_rad;
  for (const auto& bend : bent.bends)
    report.pole_bends.push_back({bend.cl_line, bend.change_rad * deg_per_rad});
  report.axes = axis_reports(ranges, model, settings, plan::word_columns(model), *proof);
  for (auto& retract : program->retracts)
    report.retracts.push_back({retract.cl_line, std::move(retract.reason)});
  report.diagnostics = read.diagnostics;
  report.diagnostics.append(program->diagnostics);
  report.verification = {.passed = true,
                         .tip_deviation_mm = proof->tip_deviation_mm,
                         .axis_deviation_deg = proof->axis_deviation_rad * deg_per_rad,
                         .blocks_read = proof->blocks_read};
  return report;
}

}  // namespace pentapost::jobs
