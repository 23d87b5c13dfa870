#pragma once

#include "pentapost/json/definition_json.hpp"
#include "pentapost/machine/library.hpp"
#include "server/app.hpp"
#include "server/dialect_names.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pentapost::server::sample {

/// An A/C table with the name and version given.
inline std::string definition_text(std::string_view name, std::string_view version) {
  std::string text = R"({
  "schema_version": 1, "name": "NAME", "version": "VERSION", "title": "A sample", "sources": ["this test"],
  "chain": ["workpiece", "C", "A", "base", "Y", "X", "Z", "tool"],
  "axes": {
    "A": {"type": "rotary", "direction": [1, 0, 0], "point_mm": [0, 0, 0], "range_deg": [-110, 110]},
    "C": {"type": "rotary", "direction": [0, 0, 1], "point_mm": [0, 0, 0], "range_deg": null},
    "X": {"type": "linear", "direction": [1, 0, 0]},
    "Y": {"type": "linear", "direction": [0, 1, 0]},
    "Z": {"type": "linear", "direction": [0, 0, 1]}
  },
  "tool_axis": [0, 0, 1],
  "controller": {"dialect": "fanuc-30i", "output": "tcp", "options": {}}
})";
  text.replace(text.find("NAME"), 4, name);
  text.replace(text.find("VERSION"), 7, version);
  return text;
}

inline machine::Library library() {
  std::vector<machine::LibraryEntry> entries;
  const auto dialects = dialect_names();
  for (const auto& [name, version] : std::vector<std::pair<std::string, std::string>>{
           {"demo", "1.0.0"}, {"demo", "1.1.0"}, {"other", "2.0.0"}}) {
    const auto text = definition_text(name, version);
    entries.push_back(
        {.definition = json::definition_from_text(text, dialects).value(), .bytes = text});
  }
  return machine::Library{std::move(entries)};
}

/// A report whose numbers are all different, so that none can stand in for another.
inline jobs::PostReport report() {
  jobs::PostReport report;
  report.nc = "%\nO1 (A \"B\\C\")\nM30\n%\n";
  report.machine_name = "demo";
  report.machine_version = "1.1.0";
  report.machine_sha256 = std::string(64, 'a');
  report.dialect = "fanuc-30i";
  report.output = Output::axes;
  report.cl_sha256 = std::string(64, 'c');
  report.cl_dialect = "nx";
  report.cl_units = "inch";
  report.cl_lines = 11;
  report.cl_points = 12;
  report.blocks = 13;
  report.inserted_points = 14;
  report.insertions = {{.from_cl_line = 18,
                        .to_cl_line = 19,
                        .points = 14,
                        .reason = jobs::InsertedStretch::Reason::arc_as_lines}};
  report.lint = {.findings = {{7, "long_line", "too long"}}, .total = 8};
  report.line_map = {.nc_line = {5, 6},
                     .cl_line = {0, 18},
                     .fraction = {1.0, 0.5},
                     .kind = {jobs::LineMap::Kind::off_path, jobs::LineMap::Kind::arc}};
  report.length_mm = 15.5;
  report.programmed_time_s = 16.25;
  report.predicted_time_s = 17.25;
  report.zones.total = 1;
  report.zones.zones = {{.axis = "C",
                         .rotary = true,
                         .kind = kinematics::SingularityKind::pole,
                         .from = {20, 21, 22.5, {1.0, 2.0, 3.0}},
                         .to = {23, 24, 25.5, {4.0, 5.0, 6.0}},
                         .peak_speed = 26.5,
                         .peak_ratio = 27.5,
                         .lowest_feed_mm_min = 28.5,
                         .programmed_time_s = 29.5,
                         .time_lost_s = 30.5}};
  report.pole_axis_change_deg = 0.125;
  report.pole_bends = {{.cl_line = 16, .change_deg = 0.0625}};
  report.axes = {{.name = "A",
                  .rotary = true,
                  .min = -1.5,
                  .max = 2.5,
                  .range = Range<double>{-110.0, 110.0},
                  .speed_limit = 150.0},
                 {.name = "X", .rotary = false, .min = 3.5, .max = 4.5}};
  report.retracts = {{.cl_line = 17, .reason = "C is wound up"}};
  report.verification = {.passed = true,
                         .tip_deviation_mm = 0.0078125,
                         .axis_deviation_deg = 0.03125,
                         .blocks_read = 18};
  report.diagnostics.add({.severity = Severity::warning,
                          .code = Code::unit_assumed,
                          .cl_line = 19,
                          .message = "mm were assumed"});
  return report;
}

using PostFunction = std::function<Result<jobs::PostReport>(const jobs::PostJob&)>;

inline Services services(PostFunction post) {
  return {.machines = library(),
          .post = std::move(post),
          .analyse = jobs::analyse,
          .reorient = jobs::reorient,
          .compare = jobs::compare,
          .next_request_id = [] { return "new-id"; }};
}

inline Services services() {
  return services([](const jobs::PostJob&) -> Result<jobs::PostReport> { return report(); });
}

}  // namespace pentapost::server::sample
