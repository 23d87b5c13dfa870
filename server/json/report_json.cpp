#include "server/json/report_json.hpp"

#include "server/json/json_writer.hpp"
#include "server/json/problem_json.hpp"
#include "server/json/report_head_json.hpp"
#include "server/json/zones_json.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string_view>

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

std::string_view word_of(jobs::InsertedStretch::Reason reason) {
  using Reason = jobs::InsertedStretch::Reason;
  switch (reason) {
    case Reason::turning:
      return "turning";
    case Reason::arc_as_lines:
      return "arc_as_lines";
    case Reason::arc_in_parts:
      return "arc_in_parts";
  }
  throw std::logic_error{"word_of: no such reason"};
}

std::string_view word_of(jobs::LineMap::Kind kind) {
  using Kind = jobs::LineMap::Kind;
  switch (kind) {
    case Kind::rapid:
      return "rapid";
    case Kind::line:
      return "line";
    case Kind::arc:
      return "arc";
    case Kind::hole:
      return "hole";
    case Kind::off_path:
      return "off_path";
  }
  throw std::logic_error{"word_of: no such kind"};
}

/// The first ones: a path that turns all along has one.
void write_insertions(JsonWriter& writer, const jobs::PostReport& report) {
  constexpr std::size_t most = 1000;
  writer.key("insertions").begin_array();
  for (const auto& each :
       std::span{report.insertions}.first(std::min(most, report.insertions.size()))) {
    writer.begin_object();
    if (each.from_cl_line > 0) writer.key("from_cl_line").integer(each.from_cl_line);
    if (each.to_cl_line > 0) writer.key("to_cl_line").integer(each.to_cl_line);
    writer.key("points").integer(each.points);
    writer.key("reason").string(word_of(each.reason));
    writer.end_object();
  }
  writer.end_array();
  writer.key("insertions_total").integer(report.insertions.size());
}

void write_lint(JsonWriter& writer, const nc::LintReport& lint) {
  writer.key("lint").begin_array();
  for (const auto& finding : lint.findings) {
    writer.begin_object();
    writer.key("nc_line").integer(finding.nc_line);
    writer.key("rule").string(finding.rule);
    writer.key("message").string(finding.message);
    writer.end_object();
  }
  writer.end_array();
  writer.key("lint_total").integer(lint.total);
}

void write_line_map(JsonWriter& writer, const jobs::LineMap& map) {
  writer.key("line_map").begin_object();
  writer.key("nc_line").begin_array();
  for (const auto line : map.nc_line) writer.integer(line);
  writer.end_array();
  writer.key("cl_line").begin_array();
  for (const auto line : map.cl_line) writer.integer(line);
  writer.end_array();
  writer.key("fraction").begin_array();
  for (const double fraction : map.fraction) writer.number(fraction);
  writer.end_array();
  writer.key("kind").begin_array();
  for (const auto kind : map.kind) writer.string(word_of(kind));
  writer.end_array();
  writer.end_object();
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
  write_insertions(writer, report);
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
  write_lint(writer, report.lint);
  if (report.line_map) write_line_map(writer, *report.line_map);
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
