#include "pentapost/jobs/setup_analysis.hpp"

#include "pentapost/analysis/cl_analysis.hpp"
#include "pentapost/core/number_text.hpp"
#include "pentapost/jobs/analysis_reporter.hpp"
#include "pentapost/jobs/setup_steps.hpp"
#include "pentapost/path/turn.hpp"
#include "pentapost/reorient/clamping.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pentapost::jobs {
namespace {

using reorient::SetupPoint;

Mat3 turn_to(const SetupPoint& setup) {
  return path::setup_turn(setup.theta_x_deg * rad_per_deg, setup.theta_z_deg * rad_per_deg);
}

/// The range of an axis of the model, mm or degrees.
std::optional<Range<double>> range_of(const PreparedJob& prepared, std::size_t axis) {
  const auto& range = axis < analysis::first_axis
                          ? prepared.ranges.linear_mm[axis]
                          : prepared.ranges.rotary_rad[axis - analysis::first_axis];
  if (!range || axis < analysis::first_axis) return range;
  return Range<double>{range->lower * deg_per_rad, range->upper * deg_per_rad};
}

/// Angles of the same setup: the part and its jig turned by half a turn on an endless first axis.
std::optional<SetupAngles> twin_of(const PreparedJob& prepared, const SetupPoint& setup) {
  if (!reorient::has_twins(prepared.model, prepared.ranges, setup.origin_mm)) return std::nullopt;
  const double turned_deg = setup.theta_z_deg > 0.0 ? -180.0 : 180.0;
  // Zero keeps its sign out of the answer.
  return SetupAngles{0.0 - setup.theta_x_deg, setup.theta_z_deg + turned_deg};
}

void set_speed_obstacle(SetupReport& report, const std::string& unit, double limit) {
  report.obstacle =
      Obstacle{.kind = Obstacle::Kind::speed,
               .axis = *report.peak_axis,
               .message = *report.peak_axis + " would need " + number_text(report.peak_speed, 2) +
                          " of " + number_text(limit, 2) + " " + unit + " at CL line " +
                          std::to_string(report.peak_at->line),
               .cl_line = report.peak_at->line,
               .code = {}};
}

}  // namespace

Obstacle obstacle_of(const Problem& problem) {
  return {.kind = Obstacle::Kind::problem,
          .axis = {},
          .message = problem.message,
          .cl_line = problem.cl_line.value_or(0),
          .code = problem.code};
}

bool is_within_limits(std::optional<double> peak_ratio) {
  // A feed that was lowered to a limit is not over it.
  constexpr double rounding = 1.0 + 1e-9;
  return peak_ratio.value_or(0.0) <= rounding;
}

double peak_ratio_of(const analysis::PathAnalysis& analysis) {
  double largest = 0.0;
  for (const analysis::AxisPeak& peak : analysis.peaks) largest = std::max(largest, peak.ratio);
  return largest;
}

plan::Settings SetupAnalysis::settings(const SetupPoint& setup) const {
  plan::Settings settings = prepared_.settings;
  settings.origin_mm = setup.origin_mm;
  settings.origin_known = origin_known_;
  // What a bend at a pole would gain comes on top.
  settings.pole_axis_rad = 0.0;
  return settings;
}

Result<analysis::PathAnalysis> SetupAnalysis::analyse(
    const SetupPoint& setup, const analysis::AnalysisOptions& options) const {
  path::ToolPath turned = prepared_.read.tool_path;
  path::turn(turned, turn_to(setup));
  return analysis::analyse_path(prepared_.model, prepared_.ranges, turned, settings(setup),
                                options);
}

SetupReport SetupAnalysis::report(const SetupPoint& setup) const {
  SetupReport report;
  report.setup = {.origin_mm = origin_known_ ? std::optional{setup.origin_mm} : std::nullopt,
                  .theta_x_deg = setup.theta_x_deg,
                  .theta_z_deg = setup.theta_z_deg};
  report.twin = twin_of(prepared_, setup);
  report.tilt_deg = std::abs(setup.theta_x_deg);
  report.instructions = setup_steps(report.setup);
  auto analysis = analyse(setup, {});
  if (!analysis) {
    report.obstacle = obstacle_of(analysis.error());
    return report;
  }
  fill(report, setup, *std::move(analysis));
  return report;
}

void SetupAnalysis::fill(SetupReport& report, const SetupPoint& setup,
                         analysis::PathAnalysis analysis) const {
  const plan::Settings own = settings(setup);
  const ReportFrame frame{.model = prepared_.model,
                          .ranges = prepared_.ranges,
                          .settings = own,
                          .to_cl = turn_to(setup).transpose(),
                          .linear_known = origin_known_};
  const auto& travel = analysis.spans.travel();
  report.rotary_travel_deg =
      (travel[analysis::first_axis] + travel[analysis::second_axis]) * deg_per_rad;
  AnalyseReport whole;
  if (auto status = report_analysis(frame, std::move(analysis), whole); !status) {
    report.obstacle = obstacle_of(status.error());
    return;
  }
  report.possible = true;
  report.peak_ratio = report.nominal_peak_ratio = whole.peak_ratio;
  report.programmed_time_s = whole.programmed_time_s;
  report.predicted_time_s = whole.predicted_time_s;
  report.repositioning_time_s = whole.repositioning_time_s;
  report.zones = whole.zones.total;
  report.closest_approach_deg = whole.closest_approach_deg;
  report.singular_directions = std::move(whole.singular_directions);
  report.retracts = static_cast<std::uint64_t>(std::count_if(
      whole.repositionings.begin(), whole.repositionings.end(),
      [](const auto& each) { return each.kind == analysis::Repositioning::Kind::retract; }));
  std::optional<double> limit;
  double largest = 0.0;
  for (std::size_t axis = 0; axis < whole.axes.size(); ++axis) {
    SetupAxisReport each{
        .demand = std::move(whole.axes[axis]), .range = range_of(prepared_, axis), .margin = {}};
    if (each.range && each.demand.span)
      each.margin = std::min(each.demand.span->lower - each.range->lower,
                             each.range->upper - each.demand.span->upper);
    if (each.demand.peak_ratio.value_or(0.0) > largest && each.demand.peak_at) {
      largest = *each.demand.peak_ratio;
      limit = each.demand.speed_limit;
      report.peak_axis = each.demand.name;
      report.peak_rotary = each.demand.rotary;
      report.peak_speed = each.demand.peak_speed;
      report.peak_at = each.demand.peak_at;
    }
    report.axes.push_back(std::move(each));
  }
  report.within_limits = is_within_limits(report.peak_ratio);
  if (!report.within_limits && limit)
    set_speed_obstacle(report, report.peak_rotary ? "deg/s" : "mm/s", *limit);
}

}  // namespace pentapost::jobs
