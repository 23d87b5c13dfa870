#include "pentapost/jobs/prepared_job.hpp"

#include "pentapost/cl/cycles.hpp"
#include "pentapost/core/sha256.hpp"
#include "pentapost/jobs/job_domain.hpp"
#include "pentapost/path/turn.hpp"
#include "pentapost/plan/sequences.hpp"

#include <algorithm>
#include <utility>

namespace pentapost::jobs {
namespace {

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
  settings.pole_axis_rad = job.post.pole_axis_deg * rad_per_deg;
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

void take_path(const PostJob& job, ReadPath read, PreparedJob& prepared) {
  prepared.read = std::move(read);
  if (job.setup.theta_x_deg != 0.0 || job.setup.theta_z_deg != 0.0)
    path::turn(prepared.read.tool_path, turn_of(job.setup));
}

}  // namespace

Result<PreparedJob> prepare_unread(const PostJob& job) {
  if (auto status = check_domain(job); !status) return std::move(status).error();
  auto control = control_of(job);
  if (!control) return std::move(control).error();
  const kinematics::Model model{job.machine.chain};
  return PreparedJob{.control = *control,
                     .read = {},
                     .model = model,
                     .ranges = plan::joint_ranges(job.machine.chain, model),
                     .settings = settings_of(job, *control)};
}

Result<PreparedJob> prepare(const PostJob& job) {
  auto prepared = prepare_unread(job);
  if (!prepared) return prepared;
  auto read = read_path(job);
  if (!read) return std::move(read).error();
  take_path(job, std::move(*read), *prepared);
  return prepared;
}

Result<PreparedJob> prepare_read(const PostJob& job, ReadPath read) {
  auto prepared = prepare_unread(job);
  if (prepared) take_path(job, std::move(read), *prepared);
  return prepared;
}

Mat3 turn_of(const Setup& setup) {
  return path::setup_turn(setup.theta_x_deg * rad_per_deg, setup.theta_z_deg * rad_per_deg);
}

void expand_holes(PreparedJob& prepared,
                  const std::function<bool(std::uint32_t point)>& stays_native) {
  path::ToolPath& tool_path = prepared.read.tool_path;
  if (std::find(tool_path.move.begin(), tool_path.move.end(), path::Move::hole) !=
      tool_path.move.end())
    tool_path = cl::expand_cycles(tool_path, stays_native, &prepared.read.diagnostics);
}

std::optional<int> missing_gauge_length(const PostJob& job, const path::ToolPath& tool_path) {
  for (const auto& sequence : plan::sequences(tool_path))
    if (!job.gauge_length_mm.contains(sequence.tool_number)) return sequence.tool_number;
  return std::nullopt;
}

Status check_gauge_length(const PostJob& job, const PreparedJob& prepared,
                          std::optional<int> missing_gauge) {
  if (!missing_gauge || !prepared.model.head_turns || prepared.control.output != Output::axes)
    return ok();
  return Problem{.code = Code::gauge_length_missing,
                 .message = "the gauge length of tool " + std::to_string(*missing_gauge) +
                            " is needed: the head of " + job.machine.name +
                            " turns, and the axis words depend on it",
                 .pointer = "/tools/" + std::to_string(*missing_gauge)};
}

void warn_of_unchecked_ranges(const PostJob& job, const plan::JointRanges& ranges,
                              std::optional<int> missing_gauge, Diagnostics& diagnostics) {
  const bool has_ranges = std::any_of(ranges.linear_mm.begin(), ranges.linear_mm.end(),
                                      [](const auto& range) { return range.has_value(); });
  if (!has_ranges || (!missing_gauge && job.setup.origin_mm)) return;
  diagnostics.add({Severity::warning, Code::linear_range_unchecked, 0,
                   std::string{"the ranges of the linear axes were not checked: "} +
                       (job.setup.origin_mm ? "a gauge length is not given"
                                            : "the setup's origin is not given")});
}

ReportHead report_head(const PostJob& job, const ReadPath& read) {
  const auto* const cl = std::get_if<ClText>(&job.path);
  return {.machine_name = job.machine.name,
          .machine_version = job.machine.version,
          .machine_sha256 = job.machine.sha256,
          .cl_sha256 = cl != nullptr ? sha256_hex(cl->text) : std::string{},
          .cl_dialect = read.cl_dialect,
          .cl_units = read.cl_units,
          .cl_lines = read.lines,
          .cl_points = read.points};
}

}  // namespace pentapost::jobs
