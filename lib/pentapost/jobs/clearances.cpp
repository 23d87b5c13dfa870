#include "pentapost/jobs/clearances.hpp"

#include "pentapost/cl/cycles.hpp"
#include "pentapost/core/number_text.hpp"
#include "pentapost/path/turn.hpp"
#include "pentapost/plan/sequences.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pentapost::jobs {
namespace {

using machine::largest_clearance_coordinate_mm;
using machine::largest_clearance_size_mm;

Problem out_of_domain(const std::string& pointer, const std::string& message) {
  return {.code = Code::out_of_domain, .message = message, .pointer = "/clearance/" + pointer};
}

bool is_size(double length_mm) { return length_mm > 0.0 && length_mm <= largest_clearance_size_mm; }
bool is_point(const Vec3& point_mm) {
  return (point_mm.array().abs() <= largest_clearance_coordinate_mm).all();
}

Status check_cylinders(const std::vector<machine::ToolCylinder>& cylinders,
                       const std::string& pointer) {
  if (cylinders.size() > machine::most_tool_cylinders)
    return out_of_domain(pointer, "found " + std::to_string(cylinders.size()) +
                                      " cylinders, expected at most " +
                                      std::to_string(machine::most_tool_cylinders));
  for (std::size_t i = 0; i < cylinders.size(); ++i) {
    const auto& [radius_mm, from_mm, to_mm] = cylinders[i];
    if (!is_size(radius_mm) || !(from_mm < to_mm) ||
        !(std::abs(from_mm) <= largest_clearance_size_mm) ||
        !(std::abs(to_mm) <= largest_clearance_size_mm))
      return out_of_domain(pointer + "/" + std::to_string(i),
                           "expected a radius above 0, an end above the start, and at most " +
                               number_text(largest_clearance_size_mm) + " mm each");
  }
  return ok();
}

Status check_jig(const std::vector<clearance::JigBox>& jig) {
  if (jig.size() > clearance::most_jig_boxes)
    return out_of_domain("jig", "found " + std::to_string(jig.size()) +
                                    " boxes, expected at most " +
                                    std::to_string(clearance::most_jig_boxes));
  for (std::size_t i = 0; i < jig.size(); ++i)
    if (!is_point(jig[i].min_mm) || !is_point(jig[i].max_mm) ||
        !((jig[i].max_mm - jig[i].min_mm).minCoeff() > 0.0))
      return out_of_domain("jig/" + std::to_string(i),
                           "expected max_mm above min_mm, and coordinates of at most " +
                               number_text(largest_clearance_coordinate_mm) + " mm");
  return ok();
}

Status check_domain_of(const clearance::Model& model) {
  if (auto status = check_cylinders(model.holder, "holder"); !status) return status;
  if (const auto& spindle = model.machine.spindle)
    if (auto status = check_cylinders(*spindle, "spindle"); !status) return status;
  if (const auto& table = model.machine.table)
    if (!is_size(table->radius_mm) || !is_size(table->thickness_mm) || !is_point(table->centre_mm))
      return out_of_domain("table", "expected a radius and a thickness above 0 and of at most " +
                                        number_text(largest_clearance_size_mm) + " mm");
  if (auto status = check_jig(model.jig); !status) return status;
  if (!(model.safety_mm >= 0.0 && model.safety_mm <= clearance::largest_safety_mm))
    return out_of_domain("safety_mm", "found " + number_text(model.safety_mm) + ", expected 0 to " +
                                          number_text(clearance::largest_safety_mm) + " mm");
  return ok();
}

clearance::Model model_in_effect(const std::optional<clearance::Model>& requested,
                                 const machine::Clearance& defined) {
  clearance::Model model = requested.value_or(clearance::Model{});
  if (!model.machine.spindle) model.machine.spindle = defined.spindle;
  if (!model.machine.table) model.machine.table = defined.table;
  return model;
}

bool has_spindle(const clearance::Model& model) {
  return model.machine.spindle && !model.machine.spindle->empty();
}

bool can_collide(const clearance::Model& model) {
  return (!model.holder.empty() || has_spindle(model)) &&
         (model.machine.table.has_value() || !model.jig.empty());
}

bool needs_origin(const clearance::Model& model) {
  if (model.machine.table) return true;
  for (const clearance::JigBox& box : model.jig)
    if (box.frame == clearance::JigBox::Frame::table) return true;
  return false;
}

/// What the check lacks.
Status check_given(const PostJob& job, const clearance::Model& model,
                   const path::ToolPath& tool_path, bool origin_known) {
  if (needs_origin(model) && !origin_known)
    return Problem{.code = Code::origin_missing,
                   .message =
                       "where table and jig are relative to the part needs the place of the "
                       "CL origin, setup.origin_mm",
                   .pointer = "/setup/origin_mm"};
  if (!has_spindle(model)) return ok();
  if (const auto tool = missing_gauge_length(job, tool_path))
    return Problem{
        .code = Code::gauge_length_missing,
        .message = "where the spindle is needs the gauge length of tool " + std::to_string(*tool),
        .pointer = "/tools"};
  return ok();
}

std::vector<clearance::Stretch> stretches_of(const PostJob& job, const path::ToolPath& tool_path) {
  std::vector<clearance::Stretch> stretches;
  for (const plan::Sequence& sequence : plan::sequences(tool_path)) {
    const auto length = job.gauge_length_mm.find(sequence.tool_number);
    stretches.push_back(
        {.begin = sequence.range.begin,
         .end = sequence.range.end,
         .gauge_length_mm = length != job.gauge_length_mm.end() ? length->second : 0.0});
  }
  return stretches;
}

/// The path in CL coordinates with its holes as single moves.
path::ToolPath path_to_check(const PostJob& job, const path::ToolPath& turned) {
  path::ToolPath tool_path =
      cl::expand_cycles(turned, [](std::uint32_t /*point*/) { return false; });
  if (job.setup.theta_x_deg != 0.0 || job.setup.theta_z_deg != 0.0)
    path::turn(tool_path, turn_of(job.setup).transpose());
  return tool_path;
}

}  // namespace

Result<std::optional<clearance::Check>> clearance_check(
    const PostJob& job, const PreparedJob& prepared,
    const std::optional<clearance::Model>& requested, bool origin_bounded,
    Diagnostics& diagnostics) {
  if (requested)
    if (auto status = check_domain_of(*requested); !status) return std::move(status).error();
  const clearance::Model model = model_in_effect(requested, job.machine.clearance);
  if (!can_collide(model)) {
    if (!requested) return std::optional<clearance::Check>{};
    return Problem{.code = Code::missing_key,
                   .message = "nothing can collide: expected holder or spindle, and table or jig",
                   .pointer = "/clearance"};
  }
  const bool origin_known = origin_bounded || job.setup.origin_mm.has_value();
  if (auto given = check_given(job, model, prepared.read.tool_path, origin_known); !given) {
    if (requested) return std::move(given).error();
    diagnostics.add({Severity::warning, Code::clearance_unchecked, 0,
                     "collisions of spindle and table were not checked: " + given.error().message});
    return std::optional<clearance::Check>{};
  }
  const path::ToolPath tool_path = path_to_check(job, prepared.read.tool_path);
  return std::optional<clearance::Check>{std::in_place, tool_path, stretches_of(job, tool_path),
                                         model};
}

}  // namespace pentapost::jobs
