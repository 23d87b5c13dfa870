#include "server/json/compare_json.hpp"

#include "server/json/json_writer.hpp"
#include "server/json/problem_json.hpp"
#include "server/json/report_head_json.hpp"
#include "server/json/setup_report_json.hpp"
#include "server/json/zones_json.hpp"

#include <string_view>

namespace pentapost::server {
namespace {

std::string_view name_of(jobs::LimitsKnown known) {
  if (known == jobs::LimitsKnown::all) return "all";
  return known == jobs::LimitsKnown::some ? "some" : "none";
}

/// Empty: no place in the request.
std::string pointer_of(const Problem& problem, const jobs::CompareRow& row,
                       const machine::Library& machines) {
  constexpr std::string_view own = "/machine/";
  if (!problem.pointer.starts_with(own)) return problem.pointer;
  const auto* const entry = machines.find(row.name, row.version);
  if (entry != nullptr && entry->definition.sha256 == row.sha256) return {};
  return "/machines/" + std::to_string(row.index) + '/' + problem.pointer.substr(own.size());
}

void write_problem(JsonWriter& writer, const Problem& problem, const jobs::CompareRow& row,
                   const machine::Library& machines) {
  const bool defect = problem.code == Code::defect;
  writer.key("problem").begin_object();
  writer.key("code").string(row_of(problem.code).name);
  writer.key("detail").string(defect ? "a defect of the service, which its log has more about"
                                     : std::string_view{problem.message});
  if (const auto pointer = pointer_of(problem, row, machines); !pointer.empty())
    writer.key("pointer").string(pointer);
  if (problem.cl_line) writer.key("cl_line").integer(*problem.cl_line);
  writer.end_object();
}

void write_limits(JsonWriter& writer, const jobs::CompareFigures& figures) {
  writer.key("within_limits");
  if (figures.limits_known == jobs::LimitsKnown::none)
    writer.null();
  else
    writer.boolean(figures.within_limits);
  writer.key("limits_known").string(name_of(figures.limits_known));
  writer.key("axes_without_limit").begin_array();
  for (const auto& name : figures.axes_without_limit) writer.string(name);
  writer.end_array();
}

void write_peak(JsonWriter& writer, const std::optional<jobs::AxisDemandReport>& peak) {
  write_number(writer.key("peak_ratio"), peak ? peak->peak_ratio : std::nullopt);
  writer.key("peak");
  if (!peak) {
    writer.null();
    return;
  }
  const std::string_view unit = peak->rotary ? "deg_s" : "mm_s";
  writer.begin_object();
  writer.key("axis").string(peak->name);
  writer.key(unit).number(peak->peak_speed);
  if (peak->speed_limit) writer.key("limit_" + std::string{unit}).number(*peak->speed_limit);
  if (peak->peak_at) write_place(writer.key("at"), cl_place_keys, *peak->peak_at);
  writer.end_object();
}

void write_figures(JsonWriter& writer, const jobs::CompareFigures& figures) {
  write_limits(writer, figures);
  writer.key("predicted_time_s").number(figures.predicted_time_s);
  writer.key("programmed_time_s").number(figures.programmed_time_s);
  writer.key("repositioning_time_s").number(figures.repositioning_time_s);
  writer.key("retracts").integer(figures.retracts);
  write_peak(writer, figures.peak);
  write_number(writer.key("closest_approach_deg"), figures.closest_approach_deg);
  if (figures.pole_axis_change_deg)
    writer.key("pole_axis_change_deg").number(*figures.pole_axis_change_deg);
  writer.key("zones").integer(figures.zones);
  writer.key("zones_time_lost_s").number(figures.zones_time_lost_s);
  writer.key("over_demands").integer(figures.over_demands);
  writer.key("over_demands_time_lost_s").number(figures.over_demands_time_lost_s);
  write_diagnostics(writer, figures.diagnostics);
}

void write_reorientation(JsonWriter& writer, const jobs::CompareRow& row,
                         const machine::Library& machines) {
  writer.key("reorientation").begin_object();
  if (const auto& found = *row.reorientation; found) {
    write_setup_report(writer.key("best"), found->best);
    write_number(writer.key("optimality_gap"), found->optimality_gap);
    write_obstacle(writer.key("obstacle"), found->obstacle);
  } else {
    write_problem(writer, found.error(), row, machines);
  }
  writer.end_object();
}

void write_row(JsonWriter& writer, const jobs::CompareRow& row, const machine::Library& machines) {
  writer.begin_object();
  writer.key("name").string(row.name);
  writer.key("version").string(row.version);
  writer.key("title").string(row.title);
  writer.key("sha256").string(row.sha256);
  writer.key("dialect").string(row.dialect);
  writer.key("output").string(row.output == Output::tcp ? "tcp" : "axes");
  writer.key("possible").boolean(row.figures.has_value());
  if (row.figures)
    write_figures(writer, *row.figures);
  else
    write_problem(writer, row.figures.error(), row, machines);
  if (row.reorientation) write_reorientation(writer, row, machines);
  writer.end_object();
}

}  // namespace

std::string compare_json(const jobs::CompareReport& report, const machine::Library& machines) {
  std::string text;
  JsonWriter writer{text};
  writer.begin_object();
  write_cl(writer, report);
  if (report.objective) writer.key("objective").string(objective_name(*report.objective));
  writer.key("machines").begin_array();
  for (const auto& row : report.rows) write_row(writer, row, machines);
  writer.end_array();
  write_diagnostics(writer, report.diagnostics);
  writer.end_object();
  return text;
}

std::string defects_of(const jobs::CompareReport& report) {
  std::string text;
  const auto add = [&text](const jobs::CompareRow& row, const auto& result) {
    if (result || result.error().code != Code::defect) return;
    text +=
        (text.empty() ? "" : "\n") + row.name + '@' + row.version + ": " + result.error().message;
  };
  for (const auto& row : report.rows) {
    add(row, row.figures);
    if (row.reorientation) add(row, *row.reorientation);
  }
  return text;
}

}  // namespace pentapost::server
