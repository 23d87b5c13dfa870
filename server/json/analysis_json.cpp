#include "server/json/analysis_json.hpp"

#include "server/json/demand_json.hpp"
#include "server/json/json_writer.hpp"
#include "server/json/problem_json.hpp"
#include "server/json/report_head_json.hpp"
#include "server/json/zones_json.hpp"

#include <algorithm>
#include <string_view>

namespace pentapost::server {
namespace {

using RepositioningKind = analysis::Repositioning::Kind;

std::string_view name_of(RepositioningKind kind) {
  if (kind == RepositioningKind::rapid) return "rapid";
  return kind == RepositioningKind::retract ? "retract" : "turn-in-place";
}

PlaceKeys place_keys(const jobs::AnalyseReport& report) {
  return report.nc_sha256.empty() ? cl_place_keys : nc_place_keys;
}

/// Way and times of the whole path or of a part of it.
template <class Timed>
void write_times(JsonWriter& writer, const Timed& timed) {
  writer.key("length_mm").number(timed.length_mm);
  writer.key("programmed_time_s").number(timed.programmed_time_s);
  writer.key("predicted_time_s").number(timed.predicted_time_s);
}

void write_summary(JsonWriter& writer, const jobs::AnalyseReport& report) {
  writer.key("summary").begin_object();
  writer.key("points").integer(report.points);
  write_times(writer, report);
  writer.key("repositioning_time_s").number(report.repositioning_time_s);
  if (report.pole_axis_change_deg)
    writer.key("pole_axis_change_deg").number(*report.pole_axis_change_deg);
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
    write_times(writer, each);
    writer.end_object();
  }
  writer.end_array();
}

void write_tools(JsonWriter& writer, const jobs::AnalyseReport& report) {
  writer.key("tools").begin_object();
  for (const auto& [number, tool] : report.tools) {
    writer.key(std::to_string(number)).begin_object();
    write_times(writer, tool);
    writer.end_object();
  }
  writer.end_object();
}

void write_axes(JsonWriter& writer, const jobs::AnalyseReport& report) {
  writer.key("axes").begin_object();
  for (const auto& axis : report.axes) {
    writer.key(axis.name).begin_object();
    write_demand(writer, place_keys(report), axis);
    writer.end_object();
  }
  writer.end_object();
}

void write_repositionings(JsonWriter& writer, const jobs::AnalyseReport& report) {
  const auto& all = report.repositionings;
  writer.key("repositionings").begin_array();
  for (std::size_t i = 0; i < std::min(all.size(), most_repositionings); ++i) {
    writer.begin_object();
    writer.key("kind").string(name_of(all[i].kind));
    write_place(writer.key("at"), place_keys(report), all[i].at);
    if (all[i].time_s) writer.key("time_s").number(*all[i].time_s);
    writer.end_object();
  }
  writer.end_array();
  writer.key("repositionings_total").integer(all.size());
}

void write_samples(JsonWriter& writer, const PlaceKeys& keys, const jobs::SampleColumns& samples) {
  writer.key("samples").begin_object();
  write_numbers(writer.key("s_mm"), samples.s_mm);
  writer.key(keys.line).begin_array();
  for (const auto line : samples.line) writer.integer(line);
  writer.end_array();
  writer.key("goes_on").begin_array();
  for (const bool goes_on : samples.goes_on) writer.boolean(goes_on);
  writer.end_array();
  write_numbers(writer.key("feed_mm_min"), samples.feed_mm_min);
  write_numbers(writer.key("amplification"), samples.amplification);
  writer.key("axis_vectors").begin_array();
  for (const auto& axis : samples.axis) write_vector(writer, axis);
  writer.end_array();
  writer.key("axes").begin_object();
  for (const auto& axis : samples.axes) {
    writer.key(axis.name).begin_object();
    if (!axis.position.empty())
      write_numbers(writer.key(in_unit(axis.rotary, "position")), axis.position);
    write_numbers(writer.key(in_unit(axis.rotary, "speed", "_s")), axis.speed);
    write_numbers(writer.key(in_unit(axis.rotary, "acceleration", "_s2")), axis.acceleration);
    writer.end_object();
  }
  writer.end_object();
  writer.end_object();
}

}  // namespace

std::string analysis_json(const jobs::AnalyseReport& report) {
  std::string text;
  JsonWriter writer{text};
  const PlaceKeys keys = place_keys(report);
  writer.begin_object();
  write_machine(writer, report);
  if (report.nc_sha256.empty())
    write_cl(writer, report);
  else
    write_nc(writer, report);
  write_summary(writer, report);
  write_operations(writer, report);
  write_tools(writer, report);
  write_axes(writer, report);
  write_zones(writer, "zones", keys, report.zones);
  write_zones(writer, "over_demands", keys, report.over_demands);
  write_repositionings(writer, report);
  write_singular_directions(writer, report.singular_directions);
  if (report.samples) write_samples(writer, keys, *report.samples);
  write_diagnostics(writer, report.diagnostics);
  writer.end_object();
  return text;
}

}  // namespace pentapost::server
