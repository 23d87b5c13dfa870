#include "pentapost/jobs/post.hpp"

#include "pentapost/cl/cycles.hpp"
#include "pentapost/core/number_text.hpp"
#include "pentapost/core/sha256.hpp"
#include "pentapost/jobs/job_domain.hpp"
#include "pentapost/jobs/tool_path.hpp"
#include "pentapost/jobs/unproven.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/nc/dialect.hpp"
#include "pentapost/nc/reader.hpp"
#include "pentapost/path/turn.hpp"
#include "pentapost/plan/drilling.hpp"
#include "pentapost/plan/program.hpp"
#include "pentapost/plan/sequences.hpp"
#include "pentapost/verify/proof.hpp"

#include <algorithm>
#include <stdexcept>

namespace pentapost::jobs {
namespace {

/// The control of a job: its language, and what it can do.
struct Control {
  const nc::Dialect* dialect;
  const nc::Reader* reader;
  machine::Options options;
  nc::Abilities abilities;
  Output output;
};

Result<Control> control_of(const PostJob& job) {
  Control control;
  const std::string& name = job.post.dialect.value_or(job.machine.controller.dialect);
  control.dialect = nc::find_dialect(name);
  control.reader = nc::find_reader(name);
  if (control.dialect == nullptr || control.reader == nullptr)
    return Problem{.code = Code::unknown_dialect,
                   .message = "there is no dialect " + name,
                   .pointer = job.post.dialect ? "/post/dialect" : ""};
  // Options are words of the definition's own control.
  if (name == job.machine.controller.dialect) control.options = job.machine.controller.options;
  auto abilities = control.dialect->abilities(control.options);
  if (!abilities) {
    Problem problem = std::move(abilities).error();
    problem.pointer.insert(0, "/machine");
    return problem;
  }
  control.abilities = *abilities;
  control.output = job.post.output.value_or(job.machine.controller.output);
  return control;
}

std::map<std::string, machine::AxisLimits> limits_of(const PostJob& job) {
  auto limits = job.machine.limits;
  for (const auto& [name, over] : job.limits) {
    machine::AxisLimits& limit = limits[name];
    if (over.max_speed) limit.max_speed = over.max_speed;
    if (over.max_acceleration) limit.max_acceleration = over.max_acceleration;
    if (over.max_jerk) limit.max_jerk = over.max_jerk;
  }
  return limits;
}

plan::Settings settings_of(const PostJob& job, const Control& control) {
  const nc::Abilities& can = control.abilities;
  plan::Settings settings;
  settings.tip_tolerance_mm = job.tolerances.tip_mm;
  settings.axis_tolerance_rad = job.tolerances.axis_deg * rad_per_deg;
  settings.flank = job.post.flank;
  settings.output = control.output;
  settings.origin_mm = job.setup.origin_mm.value_or(Vec3::Zero());
  settings.origin_known = job.setup.origin_mm.has_value();
  settings.gauge_length_mm = job.gauge_length_mm;
  settings.preferences = job.machine.preferences;
  if (job.post.prefer) {
    if (job.post.prefer->tilt) settings.preferences.tilt = job.post.prefer->tilt;
    if (job.post.prefer->first_turn) settings.preferences.first_turn = job.post.prefer->first_turn;
  }
  settings.limits = limits_of(job);
  settings.decimals_mm = can.decimals_mm;
  settings.decimals_deg = can.decimals_deg;
  settings.feed_decimals = can.feed_decimals;
  settings.largest_feed = can.largest_feed;
  settings.inverse_time = can.inverse_time;
  settings.largest_inverse_time = can.largest_inverse_time;
  settings.adds_length_always = can.adds_length_always;
  settings.retracts_with_tcp = can.retracts_with_tcp;
  settings.retract_needs_tool = can.retract_needs_tool;
  settings.arcs = can.arcs;
  settings.helices = can.helices;
  settings.arcs_with_tcp = can.arcs_with_tcp;
  settings.native_cycles = can.native_cycles;
  settings.rotary_feed_rad_min = can.rotary_feed_deg_min * rad_per_deg;
  settings.retract_mm = can.retract_mm;
  settings.plunge_feed_mm_min = can.plunge_feed_mm_min;
  return settings;
}

/// Gauge lengths of the tools that the path uses, and what their absence means.
Status check_gauge_lengths(const PostJob& job, const kinematics::Model& model, Output output,
                           const path::ToolPath& tool_path, bool has_linear_ranges,
                           Diagnostics& diagnostics) {
  std::optional<int> missing;
  for (const auto& sequence : plan::sequences(tool_path))
    if (!job.gauge_length_mm.contains(sequence.tool_number)) {
      missing = sequence.tool_number;
      break;
    }
  if (missing && model.head_turns && output == Output::axes)
    return Problem{.code = Code::gauge_length_missing,
                   .message = "the gauge length of tool " + std::to_string(*missing) +
                              " is needed: the head of " + job.machine.name +
                              " turns, and the axis words depend on it",
                   .pointer = "/tools/" + std::to_string(*missing)};
  if (missing && output == Output::axes)
    diagnostics.add(
        {Severity::warning, Code::gauge_length_assumed, 0,
         "the gauge length of tool " + std::to_string(*missing) + " is not given and counts as 0"});
  if (has_linear_ranges && (missing || !job.setup.origin_mm))
    diagnostics.add({Severity::warning, Code::linear_range_unchecked, 0,
                     std::string{"the ranges of the linear axes were not checked: "} +
                         (job.setup.origin_mm ? "a gauge length is not given"
                                              : "the setup's origin is not given")});
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
                                      const path::ToolPath& tool_path, const path::Motion& motion,
                                      std::string& nc) {
  const auto header = header_of(job, tool_path);
  verify::Claim claim{.tool_path = tool_path,
                      .model = model,
                      .motion = motion,
                      .reader_setup = {.letters = motion.letters},
                      .output = control.output,
                      .origin_mm = settings.origin_mm,
                      .gauge_length_mm = job.gauge_length_mm,
                      .tip_tolerance_mm = settings.tip_tolerance_mm,
                      .axis_tolerance_rad = settings.axis_tolerance_rad};
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
  if (auto status = check_domain(job); !status) return std::move(status).error();
  auto control = control_of(job);
  if (!control) return std::move(control).error();
  auto read = read_path(job);
  if (!read) return std::move(read).error();
  path::ToolPath tool_path = std::move(read->tool_path);
  if (job.setup.theta_x_deg != 0.0 || job.setup.theta_z_deg != 0.0)
    path::turn(tool_path, path::setup_turn(job.setup.theta_x_deg * rad_per_deg,
                                           job.setup.theta_z_deg * rad_per_deg));

  const kinematics::Model model{job.machine.chain};
  const plan::JointRanges ranges = plan::joint_ranges(job.machine.chain, model);
  const plan::Settings settings = settings_of(job, *control);
  if (std::find(tool_path.move.begin(), tool_path.move.end(), path::Move::hole) !=
      tool_path.move.end())
    tool_path = cl::expand_cycles(tool_path, plan::native_holes(model, tool_path, settings),
                                  &read->diagnostics);

  PostReport report;
  report.diagnostics = std::move(read->diagnostics);
  const bool has_linear_ranges = std::any_of(ranges.linear_mm.begin(), ranges.linear_mm.end(),
                                             [](const auto& range) { return range.has_value(); });
  if (auto status = check_gauge_lengths(job, model, control->output, tool_path, has_linear_ranges,
                                        report.diagnostics);
      !status)
    return std::move(status).error();
  auto program = plan::plan_program(model, ranges, tool_path, settings);
  if (!program) return placed(std::move(program).error());

  const auto proof =
      write_and_prove(job, *control, model, settings, tool_path, program->motion, report.nc);
  if (!proof) return proof.error();

  report.machine_name = job.machine.name;
  report.machine_version = job.machine.version;
  report.machine_sha256 = job.machine.sha256;
  report.dialect = control->dialect->name;
  report.output = control->output;
  if (const auto* cl = std::get_if<ClText>(&job.path)) report.cl_sha256 = sha256_hex(cl->text);
  report.cl_dialect = std::move(read->cl_dialect);
  report.cl_units = std::move(read->cl_units);
  report.cl_lines = read->lines;
  report.cl_points = read->points;
  report.blocks = program->motion.blocks.size();
  report.inserted_points = program->inserted_points;
  report.length_mm = program->length_mm;
  report.programmed_time_s = program->programmed_time_s;
  report.pole_axis_change_deg = program->axis_change_rad * deg_per_rad;
  report.axes = axis_reports(ranges, model, settings, plan::word_columns(model), *proof);
  for (auto& retract : program->retracts)
    report.retracts.push_back({retract.cl_line, std::move(retract.reason)});
  report.diagnostics.append(program->diagnostics);
  report.verification = {.passed = true,
                         .tip_deviation_mm = proof->tip_deviation_mm,
                         .axis_deviation_deg = proof->axis_deviation_rad * deg_per_rad,
                         .blocks_read = proof->blocks_read};
  return report;
}

}  // namespace pentapost::jobs
