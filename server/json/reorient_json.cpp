#include "server/json/reorient_json.hpp"

#include "server/json/json_writer.hpp"
#include "server/json/problem_json.hpp"
#include "server/json/report_head_json.hpp"
#include "server/json/setup_report_json.hpp"

#include <string_view>
#include <vector>

namespace pentapost::server {
namespace {

void write_setups(JsonWriter& writer, std::string_view key,
                  const std::vector<jobs::SetupReport>& setups) {
  writer.key(key).begin_array();
  for (const auto& setup : setups) write_setup_report(writer, setup);
  writer.end_array();
}

void write_map(JsonWriter& writer, const jobs::SetupMap& map) {
  writer.key("map").begin_object();
  write_numbers(writer.key("theta_x_deg"), map.theta_x_deg);
  write_numbers(writer.key("theta_z_deg"), map.theta_z_deg);
  writer.key("value").begin_array();
  for (const auto& row : map.value) write_numbers(writer, row);
  writer.end_array();
  writer.end_object();
}

}  // namespace

std::string reorient_json(const jobs::ReorientReport& report) {
  std::string text;
  JsonWriter writer{text};
  writer.begin_object();
  write_machine(writer, report);
  write_cl(writer, report);
  writer.key("objective").string(objective_name(report.objective));
  write_setup_report(writer.key("baseline"), report.baseline);
  write_setup_report(writer.key("best"), report.best);
  write_setup_report(writer.key("smallest_tilt"), report.smallest_tilt);
  write_number(writer.key("smallest_tilt_gap_deg"), report.smallest_tilt_gap_deg);
  write_setups(writer, "pareto", report.pareto);
  write_setups(writer, "candidates", report.candidates);
  if (report.map) write_map(writer, *report.map);
  write_number(writer.key("optimality_gap"), report.optimality_gap);
  writer.key("setups_evaluated").integer(report.setups_evaluated);
  writer.key("setups_colliding").integer(report.setups_colliding);
  write_obstacle(writer.key("obstacle"), report.obstacle);
  write_diagnostics(writer, report.diagnostics);
  writer.end_object();
  return text;
}

}  // namespace pentapost::server
