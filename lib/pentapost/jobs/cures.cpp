#include "pentapost/jobs/cures.hpp"

#include "pentapost/analysis/cl_analysis.hpp"
#include "pentapost/jobs/bends.hpp"
#include "pentapost/jobs/quick_setup.hpp"
#include "pentapost/jobs/setup_analysis.hpp"
#include "pentapost/path/turn.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pentapost::jobs {
namespace {

using analysis::Window;
using analysis::WindowLoad;

/// Shares of a zone's ratio above which nothing is cured.
constexpr double cured_share = 0.99;

bool needs_cure(const ZoneReport& zone) { return zone.peak_ratio > 1.0; }

/// About each zone its own length on either side, at most half way to the next one: what a cure
/// changes there counts too.
std::vector<Window> windows_about(const std::vector<ZoneReport>& zones) {
  std::vector<Window> windows;
  for (std::size_t i = 0; i < zones.size(); ++i) {
    const double from_mm = zones[i].from.s_mm, to_mm = zones[i].to.s_mm;
    const double aside_mm = to_mm - from_mm;
    Window window{from_mm - aside_mm, to_mm + aside_mm};
    if (i > 0) window.from_mm = std::max(window.from_mm, 0.5 * (zones[i - 1].to.s_mm + from_mm));
    if (i + 1 < zones.size())
      window.to_mm = std::min(window.to_mm, 0.5 * (to_mm + zones[i + 1].from.s_mm));
    windows.push_back(window);
  }
  return windows;
}

/// Loads within the windows of another way to cut the path; empty: the machine cannot go it.
std::vector<WindowLoad> loads_of(const PreparedJob& prepared, const plan::Settings& settings,
                                 const path::ToolPath& tool_path, double share,
                                 std::vector<Window> windows) {
  auto analysis =
      analysis::analyse_path(prepared.model, prepared.ranges, tool_path, settings,
                             {.share = share, .zones_only = true, .windows = std::move(windows)});
  return analysis ? std::move(analysis->window_loads) : std::vector<WindowLoad>{};
}

/// What the other tilt leaves.
std::vector<WindowLoad> loads_of_other_tilt(const AnalyseJob& job, const PreparedJob& prepared,
                                            const path::ToolPath& tool_path,
                                            std::vector<Window> windows) {
  using Tilt = machine::Preferences::Tilt;
  if (prepared.model.rotary_count != 2) return {};
  plan::Settings settings = prepared.settings;
  const Tilt tilt = settings.preferences.tilt.value_or(Tilt::positive);
  settings.preferences.tilt = tilt == Tilt::positive ? Tilt::negative : Tilt::positive;
  return loads_of(prepared, settings, tool_path, job.zone_share, std::move(windows));
}

/// A pole_axis_deg with which the passage of a zone is led through its pole; nullopt: there is
/// none.
std::optional<double> pole_axis_deg(const AnalyseJob& job, const ZoneReport& zone) {
  // A bend changes the axis a little more than the passage is off the pole.
  constexpr double steps_per_deg = 100.0, margin = 1.05;
  if (job.job.post.flank || zone.kind != kinematics::SingularityKind::pole || !zone.closest_deg)
    return std::nullopt;
  const double wanted_deg = std::ceil(margin * *zone.closest_deg * steps_per_deg) / steps_per_deg;
  if (wanted_deg > largest_pole_axis_deg || *zone.closest_deg <= job.job.post.pole_axis_deg)
    return std::nullopt;
  return wanted_deg;
}

class Cures {
 public:
  Cures(const AnalyseJob& job, const PreparedJob& prepared, const path::ToolPath& analysed,
        ZonesReport& zones)
      : job_{job},
        prepared_{prepared},
        analysed_{analysed},
        zones_{zones.zones},
        windows_{windows_about(zones.zones)} {}

  void find() {
    offer_other_tilt();
    offer_axis_change();
    offer_reorientation();
    for (ZoneReport& zone : zones_)
      std::stable_sort(zone.cures.begin(), zone.cures.end(),
                       [](const Cure& x, const Cure& y) { return x.time_lost_s < y.time_lost_s; });
  }

 private:
  void offer_other_tilt() {
    const auto loads = loads_of_other_tilt(job_, prepared_, analysed_, windows_);
    if (loads.empty()) return;
    for (std::size_t i = 0; i < zones_.size(); ++i)
      offer(zones_[i], {.kind = Cure::Kind::solution}, loads[i]);
  }

  void offer_axis_change() {
    double largest_deg = 0.0;
    for (const ZoneReport& zone : zones_)
      if (needs_cure(zone))
        largest_deg = std::max(largest_deg, pole_axis_deg(job_, zone).value_or(0.0));
    if (largest_deg == 0.0) return;
    plan::Settings settings = prepared_.settings;
    settings.pole_axis_rad = std::max(largest_deg, job_.job.post.pole_axis_deg) * rad_per_deg;
    const auto bent = bend_at_poles(prepared_, settings);
    if (bent.bends.empty()) return;
    const auto loads = loads_of(prepared_, settings, bent.tool_path, job_.zone_share, windows_);
    if (loads.empty()) return;
    for (std::size_t i = 0; i < zones_.size(); ++i)
      if (const auto change_deg = pole_axis_deg(job_, zones_[i]))
        offer(zones_[i], {.kind = Cure::Kind::axis_change, .axis_change_deg = *change_deg},
              loads[i]);
  }

  void offer_reorientation() {
    PreparedJob in_cl = prepared_;
    path::turn(in_cl.read.tool_path, turn_of(job_.job.setup).transpose());
    const auto setup = quick_setup(job_, in_cl);
    if (!setup) return;
    const auto analysis = SetupAnalysis{in_cl, job_.job.setup.origin_mm.has_value()}.analyse(
        *setup, {.share = job_.zone_share, .zones_only = true, .windows = windows_});
    if (!analysis) return;
    for (std::size_t i = 0; i < zones_.size(); ++i)
      offer(zones_[i],
            {.kind = Cure::Kind::reorientation,
             .theta_x_deg = setup->theta_x_deg,
             .theta_z_deg = setup->theta_z_deg},
            analysis->window_loads[i]);
  }

  static void offer(ZoneReport& zone, Cure cure, const WindowLoad& load) {
    if (!needs_cure(zone) || load.peak_ratio > cured_share * zone.peak_ratio) return;
    cure.peak_ratio = load.peak_ratio;
    cure.time_lost_s = load.time_lost_s;
    zone.cures.push_back(cure);
  }

  const AnalyseJob& job_;
  const PreparedJob& prepared_;
  const path::ToolPath& analysed_;
  std::vector<ZoneReport>& zones_;
  std::vector<Window> windows_;
};

}  // namespace

void find_cures(const AnalyseJob& job, const PreparedJob& prepared, const path::ToolPath& analysed,
                ZonesReport& zones) {
  if (std::none_of(zones.zones.begin(), zones.zones.end(), needs_cure)) return;
  Cures{job, prepared, analysed, zones}.find();
}

}  // namespace pentapost::jobs
