#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

namespace pentapost::sample {

/// Dialects that the tests of definitions know.
inline constexpr std::array<std::string_view, 2> dialects{"fanuc-30i", "heidenhain-iso"};

/// A definition that fits, with every key there is.
inline const std::string demo_definition = R"({
  "$schema": "../../api/schemas/machine.schema.json",
  "schema_version": 1,
  "name": "demo",
  "version": "1.0.0",
  "title": "Demo, A/C table",
  "sources": ["assumed"],
  "chain": ["workpiece", "C", "A", "base", "Y", "X", "Z", "tool"],
  "axes": {
    "A": {"type": "rotary", "direction": [1, 0, 0], "point_mm": [0, 20, 10], "range_deg": [-110, 90],
          "max_speed_deg_s": 150, "max_acceleration_deg_s2": 500, "max_jerk_deg_s3": 5000},
    "C": {"type": "rotary", "direction": [0, 0, -1], "point_mm": [0, 0, 0], "range_deg": null},
    "X": {"type": "linear", "direction": [1, 0, 0], "range_mm": [-300, 310], "max_speed_mm_s": 250,
          "max_acceleration_mm_s2": 2000, "max_jerk_mm_s3": 30000},
    "Y": {"type": "linear", "direction": [0, 1, 0]},
    "Z": {"type": "linear", "direction": [0, 0, 1]}
  },
  "tool_axis": [0, 0, 1],
  "preferences": {"tilt": "negative", "first_turn_deg": [0, 360]},
  "clearance": {"spindle": [{"radius_mm": 40, "from_mm": -5, "to_mm": 60}, {"radius_mm": 110, "from_mm": 60, "to_mm": 400}],
                "table": {"radius_mm": 160, "centre_mm": [1, 2, 3], "normal": [0, 0, -1], "thickness_mm": 45}},
  "controller": {"dialect": "heidenhain-iso", "output": "tcp",
                 "options": {"comments": true, "decimals_mm": 4, "coolant_flood": "M8", "end_lines": ["M5", "M30"]}}
}
)";

/// `text` with `part`, which must be in it once, replaced.
inline std::string with(std::string text, std::string_view part, std::string_view replacement) {
  const auto found = text.find(part);
  if (found == std::string::npos || text.find(part, found + 1) != std::string::npos)
    throw std::logic_error{"with: the part is not in the text once: " + std::string{part}};
  return text.replace(found, part.size(), replacement);
}

}  // namespace pentapost::sample
