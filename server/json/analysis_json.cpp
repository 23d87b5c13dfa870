#include "server/json/analysis_json.hpp"

#include "server/json/json_writer.hpp"
#include "server/json/problem_json.hpp"
#include "server/json/report_head_json.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

namespace pentapost::server {
namespace {

using RepositioningKind = analysis::Repositioning::Kind;

std::string_view name_of(kinematics::SingularityKind kind) {
  return kind == kinematics::SingularityKind::pole ? "pole" : "reach-boundary";
}

std::string_view name_of(RepositioningKind kind) {
  if (kind == RepositioningKind::rapid) return "rapid";
  return kind == RepositioningKind::retract ? "retract" : "turn-in-place";
}

void write_vector(JsonWriter& writer, const Vec3& vector) {
  writer.begin_array();
  for (const double component : vector) writer.number(component);
  writer.end_array();
}

void write_place(JsonWriter& writer, const jobs::PathPlace& place) {
  writer.begin_object();
  writer.key("point").integer(place.point);
  writer.key("cl_line").integer(place.line);
  writer.key("s_mm").number(place.s_mm);
  write_vector(writer.key("tip_mm"), place.tip_wp_mm);
  writer.end_object();
}

void write_summary(JsonWriter& writer, const jobs::AnalyseReport& report) {
  writer.key("summary").begin_object();
  writer.key("points").integer(report.points);
  writer.key("length_mm").number(report.length_mm);
  writer.key("programmed_time_s").number(report.programmed_time_s);
  writer.key("predicted_time_s").number(report.predicted_time_s);
  if (report.closest_approach_deg)
    writer.key("closest_approach_deg").number(*report.closest_approach_deg);
  if (report.peak_ratio) writer.key("peak_ratio").number(*report.peak_ratio);
  writer.end_object();
}

void write_operations(JsonWriter& writer, const jobs::AnalyseReport& report) {
  writer.key("operations").begin_array();
  for (const auto& each : report.operations) {
    writer.begin_object();
    writer.key("tool").integer(static_cast<std::uint64_t>(each.tool_number));
    if (!each.operation.empty()) writer.key("operation").string(each.operation);
    writer.key("length_mm").number(each.length_mm);
    writer.key("programmed_time_s").number(each.programmed_time_s);
    writer.key("predicted_time_s").number(each.predicted_time_s);
    writer.end_object();
  }
  writer.end_array();
}

void write_axes(JsonWriter& writer, const jobs::AnalyseReport& report) {
  writer.key("axes").begin_object();
  for (const auto& axis : report.axes) {
    writer.key(axis.name).begin_object();
    writer.key(axis.rotary ? "peak_deg_s" : "peak_mm_s").number(axis.peak_speed);
    if (axis.speed_limit)
      writer.key(axis.rotary ? "limit_deg_s" : "limit_mm_s").number(*axis.speed_limit);
    if (axis.peak_ratio) writer.key("peak_ratio").number(*axis.peak_ratio);
    if (axis.peak_at) write_place(writer.key("peak_at"), *axis.peak_at);
    writer.end_object();
  }
  writer.end_object();
}

void write_zones(JsonWriter& writer, std::string_view key,
                 const std::vector<jobs::ZoneReport>& zones) {
  writer.key(key).begin_array();
  for (const auto& zone : zones) {
    writer.begin_object();
    if (zone.kind) writer.key("kind").string(name_of(*zone.kind));
    writer.key("axis").string(zone.axis);
    write_place(writer.key("from"), zone.from);
    write_place(writer.key("to"), zone.to);
    if (zone.closest_deg) writer.key("closest_deg").number(*zone.closest_deg);
    writer.key(zone.rotary ? "peak_deg_s" : "peak_mm_s").number(zone.peak_speed);
    writer.key("peak_ratio").number(zone.peak_ratio);
    writer.key("lowest_feed_mm_min").number(zone.lowest_feed_mm_min);
    writer.key("time_lost_s").number(zone.time_lost_s);
    writer.end_object();
  }
  writer.end_array();
}

void write_repositionings(JsonWriter& writer, const jobs::AnalyseReport& report) {
  const auto& all = report.repositionings;
  writer.key("repositionings").begin_array();
  for (std::size_t i = 0; i < std::min(all.size(), most_repositionings); ++i) {
    writer.begin_object();
    writer.key("kind").string(name_of(all[i].kind));
    write_place(writer.key("at"), all[i].at);
    if (all[i].time_s) writer.key("time_s").number(*all[i].time_s);
    writer.end_object();
  }
  writer.end_array();
  writer.key("repositionings_total").integer(all.size());
}

void write_singular_directions(JsonWriter& writer, const jobs::AnalyseReport& report) {
  writer.key("singular_directions").begin_array();
  for (const auto& each : report.singular_directions) {
    writer.begin_object();
    writer.key("kind").string(name_of(each.kind));
    write_vector(writer.key("direction"), each.direction);
    writer.key("half_angle_deg").number(each.half_angle_deg);
    writer.end_object();
  }
  writer.end_array();
}

}  // namespace

std::string analysis_json(const jobs::AnalyseReport& report) {
  std::string text;
  JsonWriter writer{text};
  writer.begin_object();
  write_machine(writer, report);
  write_cl(writer, report);
  write_summary(writer, report);
  write_operations(writer, report);
  write_axes(writer, report);
  write_zones(writer, "zones", report.zones);
  write_zones(writer, "over_demands", report.over_demands);
  write_repositionings(writer, report);
  write_singular_directions(writer, report);
  write_diagnostics(writer, report.diagnostics);
  writer.end_object();
  return text;
}

}  // namespace pentapost::server
