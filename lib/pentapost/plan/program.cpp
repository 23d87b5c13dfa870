#include "pentapost/plan/program.hpp"

#include "pentapost/core/number_text.hpp"
#include "pentapost/plan/cutting.hpp"
#include "pentapost/plan/frame.hpp"
#include "pentapost/plan/sequences.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::plan {
namespace {

/// Words of a plausible machine; beyond it the digits of a double would be at risk.
constexpr double largest_coordinate_mm = 1e6;

Status check_coordinates(const path::ToolPath& tool_path) {
  for (std::size_t point = 0; point < tool_path.size(); ++point) {
    if (tool_path.tip_wp_mm[point].cwiseAbs().maxCoeff() <= largest_coordinate_mm) continue;
    const std::uint32_t line = tool_path.cl_line[point];
    return Problem{
        .code = Code::out_of_domain,
        .message = "a coordinate at CL line " + std::to_string(line) + " is larger than 1000000 mm",
        .cl_line = line};
  }
  return ok();
}

Status check_tolerances(const Settings& settings) {
  const auto below = [](const char* what, double tolerance, double digits, const char* unit) {
    return Problem{.code = Code::tolerance_below_digits,
                   .message = std::string{"the tolerance "} + what + " = " +
                              number_text(tolerance) + " " + unit +
                              " is finer than the digits printed allow (" + number_text(digits, 6) +
                              " " + unit + ")",
                   .pointer = std::string{"/tolerances/"} + what};
  };
  const double tip_mm = 0.5 * std::sqrt(3.0) * std::pow(10.0, -settings.decimals_mm);
  if (settings.tip_tolerance_mm < tip_mm)
    return below("tip_mm", settings.tip_tolerance_mm, tip_mm, "mm");
  const double axis_deg = std::pow(10.0, -settings.decimals_deg);
  const double asked_deg = settings.axis_tolerance_rad * deg_per_rad;
  if (asked_deg < axis_deg * (1.0 - 1e-9)) return below("axis_deg", asked_deg, axis_deg, "deg");
  return ok();
}

/// Without rotary axes X Y Z can only be the tip where the linear axes are those of the workpiece.
Status check_output(const kinematics::Model& model, const Settings& settings) {
  if (model.rotary_count > 0 || settings.output == Output::axes) return ok();
  const Mat3 directions =
      model.linear_columns[0] + model.linear_columns[1] + model.linear_columns[2];
  if ((directions - Mat3::Identity()).cwiseAbs().maxCoeff() <= 1e-12) return ok();
  return Problem{.code = Code::unsupported_output,
                 .message =
                     "the machine has no rotary axes, and its linear axes are not X Y Z of the "
                     "workpiece: output tcp is not possible, axes is"};
}

}  // namespace

Status check_plannable(const kinematics::Model& model, const path::ToolPath& tool_path,
                       const Settings& settings) {
  if (auto status = check_output(model, settings); !status) return status;
  if (auto status = check_tolerances(settings); !status) return status;
  return check_coordinates(tool_path);
}

Result<Program> plan_program(const kinematics::Model& model, const JointRanges& ranges,
                             const path::ToolPath& tool_path, const Settings& settings) {
  if (auto status = check_plannable(model, tool_path, settings); !status)
    return std::move(status).error();
  Program program;
  program.motion.letters = word_columns(model).letters;
  program.motion.decimals_mm = settings.decimals_mm;
  program.motion.decimals_deg = settings.decimals_deg;
  // Without rotary axes there is no TCP: the tip is where the linear axes are.
  program.motion.output = model.rotary_count == 0 ? Output::axes : settings.output;
  program.motion.length_offset = !model.head_turns || settings.adds_length_always;
  program.motion.blocks.reserve(tool_path.size() + tool_path.size() / 8 + 64);

  Frame frame{model, tool_path, settings, program.motion};
  frame.start();
  for (const Sequence& sequence : sequences(tool_path)) {
    const auto gauge = settings.gauge_length_mm.find(sequence.tool_number);
    const bool gauge_known = gauge != settings.gauge_length_mm.end();
    const double gauge_mm = gauge_known ? gauge->second : 0.0;
    const bool check_linear = settings.origin_known && gauge_known;
    if (auto status = cut_sequence(model, ranges, tool_path, settings, sequence, gauge_mm,
                                   check_linear, frame, program);
        !status)
      return std::move(status).error();
  }
  frame.finish();
  return program;
}

}  // namespace pentapost::plan
