#include "pentapost/jobs/post_zones.hpp"

#include "pentapost/analysis/cl_analysis.hpp"
#include "pentapost/cl/cycles.hpp"
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
  const std::string why = !zone.kind ? "too fast: " : *zone.kind == pole ? "pole: " : "reach: ";
  return why + zone.axis + " " + speed_text(zone.peak_speed) + " of " +
         speed_text(zone.peak_speed / zone.peak_ratio) + (zone.rotary ? " deg/s" : " mm/s") +
         " to CL line " + std::to_string(zone.to.line) + ", hold " +
         feed_text(zone.lowest_feed_mm_min) + " mm/min";
}

bool has_holes(const path::ToolPath& planned) {
  return std::find(planned.move.begin(), planned.move.end(), path::Move::hole) !=
         planned.move.end();
}

/// The holes of a native cycle are gone through as the control drills them.
Result<analysis::PathAnalysis> analysed(const PreparedJob& prepared, const path::ToolPath& planned,
                                        const plan::Program& program) {
  const analysis::AnalysisOptions options{.zones_only = true};
  if (!has_holes(planned))
    return analysis::analyse_choices(prepared.model, prepared.ranges, planned, prepared.settings,
                                     program.choices, options);
  const auto single = cl::expand_cycles(planned, [](std::uint32_t) { return false; });
  return analysis::analyse_path(prepared.model, prepared.ranges, single, prepared.settings,
                                options);
}

}  // namespace

void report_zones(const PostJob& job, const PreparedJob& prepared, const path::ToolPath& planned,
                  const plan::Program& program, PostReport& report) {
  const auto analysis = analysed(prepared, planned, program);
  // A move too short for the digits printed may lack a feed: such a path has no time.
  if (!analysis || !std::isfinite(analysis->predicted_time_s)) return;
  const ReportFrame frame{.model = prepared.model,
                          .ranges = prepared.ranges,
                          .settings = prepared.settings,
                          .to_cl = turn_of(job.setup).transpose(),
                          .linear_known = job.setup.origin_mm.has_value()};
  report.predicted_time_s = analysis->predicted_time_s;
  report.programmed_time_s = analysis->programmed_time_s;
  report.length_mm = analysis->length_mm;
  report.zones = report_zones(frame, analysis->zones, true);
  report.over_demands = report_zones(frame, analysis->over_demands, false);
}

void comment_zones(const PostReport& report, const path::ToolPath& planned, path::Motion& motion) {
  std::vector<const ZoneReport*> zones;
  for (const auto* each : {&report.zones, &report.over_demands})
    for (const ZoneReport& zone : each->zones) zones.push_back(&zone);
  std::stable_sort(zones.begin(), zones.end(), [](const ZoneReport* x, const ZoneReport* y) {
    return x->from.s_mm < y->from.s_mm;
  });
  // With native cycles the points of the zones are not those of the blocks.
  const bool by_line = has_holes(planned);
  const auto has_begun = [&](const path::Block& block, const PathPlace& place) {
    if (by_line) return block.cl_line >= place.line;
    return block.point > place.point ||
           (block.point == place.point && block.fraction > place.fraction);
  };
  std::vector<path::Action> comments;
  std::size_t block = 0;
  for (const ZoneReport* zone : zones) {
    while (block < motion.blocks.size() &&
           !(motion.blocks[block].on_path && has_begun(motion.blocks[block], zone->from)))
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
