#include "server/json/report_json.hpp"

#include "server/json/json_writer.hpp"
#include "server/json/problem_json.hpp"
#include "server/json/report_head_json.hpp"
#include "server/json/zones_json.hpp"

namespace pentapost::server {
namespace {

void write_axes(JsonWriter& writer, const jobs::PostReport& report) {
  writer.key("axes").begin_object();
  for (const auto& axis : report.axes) {
    writer.key(axis.name).begin_object();
    writer.key("unit").string(axis.rotary ? "deg" : "mm");
    writer.key("min").number(axis.min);
    writer.key("max").number(axis.max);
    if (axis.range) write_range(writer.key("range"), *axis.range);
    if (axis.speed_limit) writer.key("speed_limit").number(*axis.speed_limit);
    writer.end_object();
  }
  writer.end_object();
}

void write_retracts(JsonWriter& writer, const jobs::PostReport& report) {
  writer.key("retracts").begin_array();
  for (const auto& retract : report.retracts) {
    writer.begin_object();
    if (retract.cl_line > 0) writer.key("cl_line").integer(retract.cl_line);
    writer.key("reason").string(retract.reason);
    writer.end_object();
  }
  writer.end_array();
}

void write_verification(JsonWriter& writer, const jobs::Verification& verification) {
  writer.key("verification").begin_object();
  writer.key("passed").boolean(verification.passed);
  writer.key("tip_deviation_mm").number(verification.tip_deviation_mm);
  writer.key("axis_deviation_deg").number(verification.axis_deviation_deg);
  writer.key("blocks_read").integer(verification.blocks_read);
  writer.end_object();
}

}  // namespace

std::string report_json(const jobs::PostReport& report) {
  std::string text;
  JsonWriter writer{text};
  writer.begin_object();
  write_machine(writer, report);
  writer.key("dialect").string(report.dialect);
  writer.key("output").string(report.output == Output::tcp ? "tcp" : "axes");
  write_cl(writer, report);
  writer.key("blocks").integer(report.blocks);
  writer.key("length_mm").number(report.length_mm);
  writer.key("programmed_time_s").number(report.programmed_time_s);
  if (report.predicted_time_s) writer.key("predicted_time_s").number(*report.predicted_time_s);
  write_axes(writer, report);
  write_zones(writer, "zones", cl_place_keys, report.zones);
  write_zones(writer, "over_demands", cl_place_keys, report.over_demands);
  writer.key("inserted_points").integer(report.inserted_points);
  writer.key("pole_axis_change_deg").number(report.pole_axis_change_deg);
  writer.key("pole_bends").begin_array();
  for (const auto& bend : report.pole_bends) {
    writer.begin_object();
    writer.key("cl_line").integer(bend.cl_line);
    writer.key("change_deg").number(bend.change_deg);
    writer.end_object();
  }
  writer.end_array();
  write_retracts(writer, report);
  write_verification(writer, report.verification);
  write_diagnostics(writer, report.diagnostics);
  writer.end_object();
  return text;
}

std::string post_answer_json(const jobs::PostReport& report) {
  const std::string report_text = report_json(report);
  std::string text;
  text.reserve(report.nc.size() + report.nc.size() / 16 + report_text.size() + 64);
  JsonWriter writer{text};
  writer.begin_object();
  writer.key("nc").string(report.nc);
  writer.key("report").raw(report_text);
  writer.end_object();
  return text;
}

}  // namespace pentapost::server
