#include "pentapost/jobs/analysis_reporter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pentapost::jobs {
namespace {

using analysis::first_axis;
using analysis::PathAnalysis;

bool is_rotary(std::size_t axis) { return axis >= first_axis; }

std::size_t count_of(const kinematics::Model& model) {
  return first_axis + static_cast<std::size_t>(model.rotary_count);
}

const std::string& name_of(const kinematics::Model& model, std::size_t axis) {
  return is_rotary(axis) ? model.rotary_names[axis - first_axis] : model.linear_names[axis];
}

/// Degrees for rotary axes.
double in_unit(std::size_t axis, double value) {
  return is_rotary(axis) ? value * deg_per_rad : value;
}

std::optional<double> finite(double number) {
  return std::isfinite(number) ? std::optional{number} : std::nullopt;
}

PathPlace in_cl(const ReportFrame& frame, PathPlace place) {
  place.tip_wp_mm = frame.to_cl * place.tip_wp_mm;
  return place;
}

std::optional<double> acceleration_limit(const ReportFrame& frame, std::size_t axis) {
  const auto found = frame.settings.limits.find(name_of(frame.model, axis));
  if (found == frame.settings.limits.end() || !found->second.max_acceleration) return std::nullopt;
  return in_unit(axis, *found->second.max_acceleration);
}

AxisDemandReport report_axis(const ReportFrame& frame, const PathAnalysis& analysis,
                             std::size_t axis) {
  const analysis::AxisPeak& peak = analysis.peaks[axis];
  AxisDemandReport report{.name = name_of(frame.model, axis),
                          .rotary = is_rotary(axis),
                          .peak_speed = in_unit(axis, peak.speed)};
  if (const auto& spans = analysis.spans.of_axes(); spans && (report.rotary || frame.linear_known))
    report.span = {in_unit(axis, (*spans)[axis].lower), in_unit(axis, (*spans)[axis].upper)};
  if (const auto limit = analysis::speed_limits(frame.model, frame.settings)[axis]) {
    report.speed_limit = in_unit(axis, *limit);
    report.peak_ratio = peak.ratio;
  }
  if (peak.speed > 0.0) report.peak_at = in_cl(frame, peak.at);
  if (report.rotary && frame.model.rotary_count == 2 && peak.speed > 0.0) {
    report.amplification =
        finite(analysis::amplification(frame.model, axis, peak.opening_sine, peak.axis));
    if (report.amplification) report.asked_speed = report.peak_speed / *report.amplification;
  }
  if (analysis.peak_accelerations)
    report.peak_acceleration = in_unit(axis, (*analysis.peak_accelerations)[axis]);
  report.acceleration_limit = acceleration_limit(frame, axis);
  return report;
}

/// The cure that every zone over a limit has.
Cure lower_feed(const analysis::Zone& zone) {
  const double length_mm = zone.to.s_mm - zone.from.s_mm;
  return {.kind = Cure::Kind::feed,
          .time_lost_s =
              std::max(0.0, 60.0 * length_mm / zone.lowest_feed_mm_min - zone.programmed_time_s),
          .peak_ratio = 1.0,
          .feed_mm_min = zone.lowest_feed_mm_min};
}

ZoneReport report_zone(const ReportFrame& frame, const analysis::Zone& zone, bool singular) {
  ZoneReport report{.axis = name_of(frame.model, zone.axis),
                    .rotary = is_rotary(zone.axis),
                    .from = in_cl(frame, zone.from),
                    .to = in_cl(frame, zone.to),
                    .peak_speed = in_unit(zone.axis, zone.peak_speed),
                    .peak_ratio = zone.peak_ratio,
                    .lowest_feed_mm_min = zone.lowest_feed_mm_min,
                    .programmed_time_s = zone.programmed_time_s,
                    .time_lost_s = zone.time_lost_s};
  if (zone.closest) report.closest_deg = zone.closest->distance_rad * deg_per_rad;
  if (singular && zone.closest) report.kind = zone.closest->kind;
  if (singular && zone.peak_ratio > 1.0) report.cures.push_back(lower_feed(zone));
  if (frame.model.rotary_count == 2 && report.rotary)
    report.amplification =
        finite(analysis::amplification(frame.model, zone.axis, zone.opening_sine, zone.tool_axis));
  return report;
}

/// Whether the second joint reaches the value that it has at the singularity.
bool is_in_range(const ReportFrame& frame, const kinematics::Singularity& singularity) {
  const auto& range = frame.ranges.rotary_rad[1];
  if (!range) return true;
  constexpr double slack_rad = 1e-9;
  const double turn_rad = 2.0 * pi;
  const double any_rad = frame.model.beta_zero_rad + singularity.opening_rad;
  const double lowest_rad =
      any_rad + turn_rad * std::ceil((range->lower - slack_rad - any_rad) / turn_rad);
  return lowest_rad <= range->upper + slack_rad;
}

/// Singularities that the machine can take its tool axis to, and the way to the nearest of them.
void report_singularities(const ReportFrame& frame, const PathAnalysis& analysis,
                          AnalyseReport& report) {
  for (std::size_t i = 0; i < analysis.singularities.size(); ++i) {
    const kinematics::Singularity& each = analysis.singularities[i];
    if (!is_in_range(frame, each)) continue;
    report.singular_directions.push_back(
        {each.kind, frame.to_cl * each.centre, each.half_angle_rad * deg_per_rad});
    if (const auto& approach = analysis.approaches[i])
      report.closest_approach_deg = std::min(report.closest_approach_deg.value_or(HUGE_VAL),
                                             approach->distance_rad * deg_per_rad);
  }
}

SampleColumns report_samples(const ReportFrame& frame,
                             const std::vector<analysis::Sample>& samples) {
  SampleColumns columns;
  for (std::size_t axis = 0; axis < count_of(frame.model); ++axis)
    columns.axes.push_back({.name = name_of(frame.model, axis),
                            .rotary = is_rotary(axis),
                            .position = {},
                            .speed = {},
                            .acceleration = {}});
  for (const analysis::Sample& sample : samples) {
    columns.s_mm.push_back(sample.at.s_mm);
    columns.feed_mm_min.push_back(sample.feed_mm_min);
    columns.line.push_back(sample.at.line);
    columns.goes_on.push_back(sample.goes_on);
    columns.amplification.push_back(finite(1.0 / sample.opening_sine));
    columns.axis.emplace_back(frame.to_cl * sample.axis);
    for (std::size_t axis = 0; axis < columns.axes.size(); ++axis) {
      AxisColumns& column = columns.axes[axis];
      if (column.rotary || frame.linear_known)
        column.position.push_back(in_unit(axis, sample.joints[axis]));
      column.speed.push_back(in_unit(axis, sample.speed[axis]));
      column.acceleration.push_back(sample.has_acceleration
                                        ? std::optional{in_unit(axis, sample.acceleration[axis])}
                                        : std::nullopt);
    }
  }
  return columns;
}

std::map<int, ToolTime> by_tool(const std::vector<analysis::OperationTime>& operations) {
  std::map<int, ToolTime> tools;
  for (const auto& each : operations) {
    ToolTime& tool = tools[each.tool_number];
    tool.length_mm += each.length_mm;
    tool.programmed_time_s += each.programmed_time_s;
    tool.predicted_time_s += each.predicted_time_s;
  }
  return tools;
}

/// Whether all that follows from feeds and limits is a number: what is reported of zones and
/// operations is bounded by the sums and peaks.
bool is_finite(const AnalyseReport& report) {
  bool finite = std::isfinite(report.length_mm) && std::isfinite(report.programmed_time_s) &&
                std::isfinite(report.predicted_time_s) &&
                std::isfinite(report.repositioning_time_s);
  for (const auto& axis : report.axes)
    finite = finite && std::isfinite(axis.peak_speed) &&
             std::isfinite(axis.peak_ratio.value_or(0.0)) &&
             std::isfinite(axis.speed_limit.value_or(0.0)) &&
             std::isfinite(axis.peak_acceleration.value_or(0.0)) &&
             std::isfinite(axis.acceleration_limit.value_or(0.0));
  return finite;
}

}  // namespace

ZonesReport report_zones(const ReportFrame& frame, const std::vector<analysis::Zone>& zones,
                         bool singular) {
  ZonesReport report;
  report.total = zones.size();
  std::vector<std::size_t> worst(zones.size());
  for (std::size_t i = 0; i < zones.size(); ++i) {
    worst[i] = i;
    report.time_lost_s += zones[i].time_lost_s;
  }
  if (worst.size() > ZonesReport::most) {
    const auto end = worst.begin() + static_cast<std::ptrdiff_t>(ZonesReport::most);
    std::nth_element(worst.begin(), end, worst.end(), [&](std::size_t x, std::size_t y) {
      return zones[x].peak_ratio > zones[y].peak_ratio;
    });
    worst.erase(end, worst.end());
    std::sort(worst.begin(), worst.end());
  }
  for (const std::size_t i : worst) report.zones.push_back(report_zone(frame, zones[i], singular));
  return report;
}

Status report_analysis(const ReportFrame& frame, PathAnalysis analysis, AnalyseReport& report) {
  report.length_mm = analysis.length_mm;
  report.programmed_time_s = analysis.programmed_time_s;
  report.predicted_time_s = analysis.predicted_time_s;
  for (std::size_t axis = 0; axis < count_of(frame.model); ++axis) {
    report.axes.push_back(report_axis(frame, analysis, axis));
    if (const auto ratio = report.axes.back().peak_ratio)
      report.peak_ratio = std::max(report.peak_ratio.value_or(0.0), *ratio);
  }
  report.zones = report_zones(frame, analysis.zones, true);
  report.over_demands = report_zones(frame, analysis.over_demands, false);
  report.tools = by_tool(analysis.operations);
  report.operations = std::move(analysis.operations);
  report.repositionings = std::move(analysis.repositionings);
  for (auto& each : report.repositionings) {
    each.at = in_cl(frame, each.at);
    report.repositioning_time_s += each.time_s.value_or(0.0);
  }
  report_singularities(frame, analysis, report);
  if (!is_finite(report))
    return Problem{.code = Code::out_of_domain,
                   .message =
                       "a speed, ratio or time of the path is no number any more: a feed or "
                       "an axis limit is too large or too small"};
  if (!analysis.samples.empty()) report.samples = report_samples(frame, analysis.samples);
  return ok();
}

}  // namespace pentapost::jobs
