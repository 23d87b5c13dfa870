#include "pentapost/jobs/analyse.hpp"

#include "pentapost/core/number_text.hpp"
#include "pentapost/jobs/prepared_job.hpp"
#include "pentapost/kinematics/singularity.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pentapost::jobs {
namespace {

using analysis::first_axis;
using analysis::PathAnalysis;

/// Turns an analysis into what its caller sees: CL coordinates, degrees, names of axes.
class Reporter {
 public:
  Reporter(const AnalyseJob& job, const PreparedJob& prepared)
      : prepared_{prepared}, to_cl_{turn_of(job.job.setup).transpose()} {}

  void report(PathAnalysis& analysis, AnalyseReport& report) {
    report.points = prepared_.read.tool_path.size();
    report.length_mm = finite(analysis.length_mm);
    report.programmed_time_s = finite(analysis.programmed_time_s);
    report.predicted_time_s = finite(analysis.predicted_time_s);
    if (analysis.closest) report.closest_approach_deg = degrees(analysis.closest->distance_rad);
    report_axes(analysis, report);
    for (const auto& each : analysis.zones) {
      report.zones.push_back(zone(each));
      if (each.closest) report.zones.back().kind = each.closest->kind;
    }
    for (const auto& each : analysis.over_demands) report.over_demands.push_back(zone(each));
    report.operations = std::move(analysis.operations);
    for (const auto& each : report.operations)
      for (const double number : {each.length_mm, each.programmed_time_s, each.predicted_time_s})
        finite(number);
    report.repositionings = std::move(analysis.repositionings);
    for (auto& each : report.repositionings) {
      each.at = place(each.at);
      if (each.time_s) finite(*each.time_s);
    }
    for (const auto& each : analysis.singularities)
      if (is_in_range(each))
        report.singular_directions.push_back(
            {each.kind, to_cl_ * each.centre, degrees(each.half_angle_rad)});
  }

  /// Whether all that was reported is a number.
  bool is_finite() const { return is_finite_; }

 private:
  double finite(double number) {
    is_finite_ = is_finite_ && std::isfinite(number);
    return number;
  }

  double degrees(double angle_rad) { return finite(angle_rad * deg_per_rad); }

  PathPlace place(PathPlace at) {
    finite(at.s_mm);
    at.tip_wp_mm = to_cl_ * at.tip_wp_mm;
    return at;
  }

  static bool is_rotary(std::size_t axis) { return axis >= first_axis; }

  const std::string& name_of(std::size_t axis) const {
    const kinematics::Model& model = prepared_.model;
    return is_rotary(axis) ? model.rotary_names[axis - first_axis] : model.linear_names[axis];
  }

  double speed(std::size_t axis, double model_speed) {
    return is_rotary(axis) ? degrees(model_speed) : finite(model_speed);
  }

  void report_axes(const PathAnalysis& analysis, AnalyseReport& report) {
    const auto limits = analysis::speed_limits(prepared_.model, prepared_.settings);
    const auto count = first_axis + static_cast<std::size_t>(prepared_.model.rotary_count);
    for (std::size_t i = 0; i < count; ++i) {
      const analysis::AxisPeak& peak = analysis.peaks[i];
      AxisDemandReport axis{
          .name = name_of(i), .rotary = is_rotary(i), .peak_speed = speed(i, peak.speed)};
      if (limits[i]) {
        axis.speed_limit = speed(i, *limits[i]);
        axis.peak_ratio = finite(peak.ratio);
        report.peak_ratio = std::max(report.peak_ratio.value_or(0.0), peak.ratio);
      }
      if (peak.speed > 0.0) axis.peak_at = place(peak.at);
      report.axes.push_back(std::move(axis));
    }
  }

  ZoneReport zone(const analysis::Zone& zone) {
    ZoneReport report{.axis = name_of(zone.axis),
                      .rotary = is_rotary(zone.axis),
                      .from = place(zone.from),
                      .to = place(zone.to),
                      .peak_speed = speed(zone.axis, zone.peak_speed),
                      .peak_ratio = finite(zone.peak_ratio),
                      .lowest_feed_mm_min = finite(zone.lowest_feed_mm_min),
                      .time_lost_s = finite(zone.time_lost_s)};
    if (zone.closest) report.closest_deg = degrees(zone.closest->distance_rad);
    return report;
  }

  /// Whether the second joint reaches the value that it has at the singularity.
  bool is_in_range(const kinematics::Singularity& singularity) const {
    const auto& range = prepared_.ranges.rotary_rad[1];
    if (!range) return true;
    constexpr double slack_rad = 1e-9;
    const double turn_rad = 2.0 * pi;
    const double any_rad = prepared_.model.beta_zero_rad + singularity.opening_rad;
    const double lowest_rad =
        any_rad + turn_rad * std::ceil((range->lower - slack_rad - any_rad) / turn_rad);
    return lowest_rad <= range->upper + slack_rad;
  }

  const PreparedJob& prepared_;
  Mat3 to_cl_;
  bool is_finite_ = true;
};

Status check_zone_share(double share) {
  if (share > 0.0 && std::isfinite(share)) return ok();
  return Problem{.code = Code::out_of_domain,
                 .message = "found " + number_text(share) + "; expected a number above 0",
                 .pointer = "/zone_share"};
}

/// What the speeds of the linear axes rest on and the job does not say.
void warn_of_assumptions(const PostJob& job, PreparedJob& prepared) {
  Diagnostics& diagnostics = prepared.read.diagnostics;
  const auto missing = missing_gauge_length(job, prepared.read.tool_path);
  if (missing && prepared.model.head_turns)
    diagnostics.add({Severity::warning, Code::gauge_length_assumed, 0,
                     "the gauge length of tool " + std::to_string(*missing) +
                         " is not given and counts as 0: the speeds of the linear axes depend on "
                         "it"});
  const auto table = job.machine.chain.table();
  const bool table_turns = std::any_of(table.begin(), table.end(),
                                       [](const machine::Joint& each) { return each.is_rotary(); });
  if (table_turns && !job.setup.origin_mm)
    diagnostics.add({Severity::warning, Code::origin_assumed, 0,
                     "the setup's origin is not given and counts as 0, 0, 0: the speeds of the "
                     "linear axes depend on it"});
  warn_of_unchecked_ranges(job, prepared.ranges, missing, diagnostics);
}

}  // namespace

Result<AnalyseReport> analyse(const AnalyseJob& job) {
  if (auto status = check_zone_share(job.zone_share); !status) return std::move(status).error();
  auto prepared = prepare(job.job);
  if (!prepared) return std::move(prepared).error();
  expand_holes(*prepared, [](std::uint32_t) { return false; });
  warn_of_assumptions(job.job, *prepared);
  auto analysis =
      analysis::analyse_path(prepared->model, prepared->ranges, prepared->read.tool_path,
                             prepared->settings, {.share = job.zone_share});
  if (!analysis) return std::move(analysis).error();

  AnalyseReport report;
  static_cast<ReportHead&>(report) = report_head(job.job, prepared->read);
  Reporter reporter{job, *prepared};
  reporter.report(*analysis, report);
  if (!reporter.is_finite())
    return Problem{.code = Code::out_of_domain,
                   .message =
                       "a speed, ratio or time of the path is no number any more: a feed or "
                       "an axis limit is too large or too small"};
  report.diagnostics = std::move(prepared->read.diagnostics);
  return report;
}

}  // namespace pentapost::jobs
