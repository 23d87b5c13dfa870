#include "pentapost/jobs/post_zones.hpp"

#include "pentapost/analysis/cl_analysis.hpp"
#include "pentapost/core/number_text.hpp"
#include "pentapost/jobs/analysis_reporter.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace pentapost::jobs {
namespace {

std::string speed_text(double speed) { return number_text(speed, speed < 100.0 ? 1 : 0); }

/// Rounded down; never to 0 where a feed of thousandths can be held.
std::string feed_text(double feed_mm_min) {
  return feed_mm_min < 10.0 ? number_text(std::floor(1000.0 * feed_mm_min) / 1000.0, 3)
                            : number_text(std::floor(feed_mm_min), 0);
}

/// Short enough for one line of every control.
std::string warning_of(const ZoneReport& zone) {
  using enum kinematics::SingularityKind;
  const std::string where = !zone.kind ? "" : *zone.kind == pole ? ", pole" : ", reach";
  return "warning" + where + ": " + zone.axis + " " + speed_text(zone.peak_speed) + " of " +
         speed_text(zone.peak_speed / zone.peak_ratio) + (zone.rotary ? " deg/s" : " mm/s") +
         " to CL line " + std::to_string(zone.to.line) + "; hold F" +
         feed_text(zone.lowest_feed_mm_min);
}

}  // namespace

void report_zones(const PostJob& job, const PreparedJob& prepared, const path::ToolPath& planned,
                  const plan::Program& program, PostReport& report) {
  const auto analysis =
      analysis::analyse_choices(prepared.model, prepared.ranges, planned, prepared.settings,
                                program.choices, {.zones_only = true});
  // A move too short for the digits printed may lack a feed: such a path has no time.
  if (!analysis || !std::isfinite(analysis->predicted_time_s)) return;
  const ReportFrame frame{.model = prepared.model,
                          .ranges = prepared.ranges,
                          .settings = prepared.settings,
                          .to_cl = turn_of(job.setup).transpose(),
                          .linear_known = job.setup.origin_mm.has_value()};
  report.predicted_time_s = analysis->predicted_time_s;
  report.zones = report_zones(frame, analysis->zones, true);
  report.over_demands = report_zones(frame, analysis->over_demands, false);
}

void comment_zones(const PostReport& report, path::Motion& motion) {
  std::vector<const ZoneReport*> zones;
  for (const auto* each : {&report.zones, &report.over_demands})
    for (const ZoneReport& zone : each->zones) zones.push_back(&zone);
  std::stable_sort(zones.begin(), zones.end(), [](const ZoneReport* x, const ZoneReport* y) {
    return x->from.s_mm < y->from.s_mm;
  });
  std::vector<path::Action> comments;
  std::size_t block = 0;
  for (const ZoneReport* zone : zones) {
    while (block < motion.blocks.size() &&
           !(motion.blocks[block].on_path && motion.blocks[block].point >= zone->from.point))
      ++block;
    if (block == motion.blocks.size()) break;
    comments.push_back(
        {static_cast<std::uint32_t>(block), zone->from.line, path::Comment{warning_of(*zone)}});
  }
  std::vector<path::Action> all;
  all.reserve(motion.actions.size() + comments.size());
  std::merge(
      comments.begin(), comments.end(), std::make_move_iterator(motion.actions.begin()),
      std::make_move_iterator(motion.actions.end()), std::back_inserter(all),
      [](const path::Action& x, const path::Action& y) { return x.before_block < y.before_block; });
  motion.actions = std::move(all);
}

}  // namespace pentapost::jobs
