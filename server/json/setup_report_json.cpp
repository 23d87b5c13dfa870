#include "server/json/setup_report_json.hpp"

#include "pentapost/core/codes.hpp"
#include "server/json/demand_json.hpp"
#include "server/json/zones_json.hpp"

namespace pentapost::server {
namespace {

std::string_view name_of(jobs::Obstacle::Kind kind) {
  if (kind == jobs::Obstacle::Kind::speed) return "speed";
  return kind == jobs::Obstacle::Kind::problem ? "problem" : "collision";
}

void write_angles(JsonWriter& writer, double theta_x_deg, double theta_z_deg) {
  writer.key("theta_x_deg").number(theta_x_deg);
  writer.key("theta_z_deg").number(theta_z_deg);
}

void write_place_of_setup(JsonWriter& writer, const jobs::SetupReport& report) {
  write_angles(writer, report.setup.theta_x_deg, report.setup.theta_z_deg);
  writer.key("twin");
  if (report.twin) {
    writer.begin_object();
    write_angles(writer, report.twin->theta_x_deg, report.twin->theta_z_deg);
    writer.end_object();
  } else {
    writer.null();
  }
  writer.key("tilt_deg").number(report.tilt_deg);
  writer.key("setup").begin_object();
  if (report.setup.origin_mm) write_vector(writer.key("origin_mm"), *report.setup.origin_mm);
  write_angles(writer, report.setup.theta_x_deg, report.setup.theta_z_deg);
  writer.end_object();
}

void write_peak(JsonWriter& writer, const jobs::SetupReport& report) {
  writer.key("peak");
  if (!report.peak_axis) {
    writer.null();
    return;
  }
  writer.begin_object();
  writer.key("axis").string(*report.peak_axis);
  writer.key(report.peak_rotary ? "deg_s" : "mm_s").number(report.peak_speed);
  if (report.peak_at) write_place(writer.key("at"), cl_place_keys, *report.peak_at);
  writer.end_object();
}

void write_axes(JsonWriter& writer, const jobs::SetupReport& report) {
  writer.key("axes").begin_object();
  for (const auto& axis : report.axes) {
    const bool rotary = axis.demand.rotary;
    writer.key(axis.demand.name).begin_object();
    write_demand(writer, cl_place_keys, axis.demand);
    if (axis.range) write_range(writer.key(in_unit(rotary, "range")), *axis.range);
    if (axis.margin) writer.key(in_unit(rotary, "margin")).number(*axis.margin);
    writer.end_object();
  }
  writer.end_object();
}

void write_figures(JsonWriter& writer, const jobs::SetupReport& report) {
  write_number(writer.key("peak_ratio"), report.peak_ratio);
  writer.key("peak_unbounded").boolean(report.peak_unbounded);
  write_number(writer.key("nominal_peak_ratio"), report.nominal_peak_ratio);
  write_peak(writer, report);
  writer.key("predicted_time_s").number(report.predicted_time_s);
  writer.key("programmed_time_s").number(report.programmed_time_s);
  writer.key("rotary_travel_deg").number(report.rotary_travel_deg);
  writer.key("repositioning_time_s").number(report.repositioning_time_s);
  writer.key("retracts").integer(report.retracts);
  writer.key("zones").integer(report.zones);
  write_number(writer.key("closest_approach_deg"), report.closest_approach_deg);
  write_singular_directions(writer, report.singular_directions);
  write_axes(writer, report);
}

}  // namespace

std::string_view objective_name(jobs::Objective objective) {
  if (objective == jobs::Objective::peak_ratio) return "peak_ratio";
  return objective == jobs::Objective::time ? "time" : "rotary_travel";
}

void write_obstacle(JsonWriter& writer, const std::optional<jobs::Obstacle>& obstacle) {
  if (!obstacle) {
    writer.null();
    return;
  }
  writer.begin_object();
  writer.key("kind").string(name_of(obstacle->kind));
  if (!obstacle->axis.empty()) writer.key("axis").string(obstacle->axis);
  if (obstacle->code) writer.key("code").string(row_of(*obstacle->code).name);
  writer.key("message").string(obstacle->message);
  if (obstacle->cl_line > 0) writer.key("cl_line").integer(obstacle->cl_line);
  writer.end_object();
}

void write_setup_report(JsonWriter& writer, const jobs::SetupReport& report) {
  writer.begin_object();
  write_place_of_setup(writer, report);
  writer.key("possible").boolean(report.possible);
  writer.key("within_limits").boolean(report.within_limits);
  write_obstacle(writer.key("obstacle"), report.obstacle);
  if (report.possible) write_figures(writer, report);
  writer.key("instructions").begin_array();
  for (const auto& step : report.instructions) writer.string(step);
  writer.end_array();
  writer.end_object();
}

void write_setup_report(JsonWriter& writer, const std::optional<jobs::SetupReport>& report) {
  if (report)
    write_setup_report(writer, *report);
  else
    writer.null();
}

}  // namespace pentapost::server
