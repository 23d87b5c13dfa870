#include "pentapost/jobs/quick_setup.hpp"

#include "pentapost/analysis/path_analysis.hpp"
#include "pentapost/jobs/clearances.hpp"
#include "pentapost/jobs/path_loads.hpp"
#include "pentapost/jobs/reorient.hpp"
#include "pentapost/jobs/setup_analysis.hpp"
#include "pentapost/jobs/setup_choices.hpp"
#include "pentapost/reorient/search.hpp"
#include "pentapost/reorient/setup_values.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace pentapost::jobs {
namespace {

using reorient::Goal;
using reorient::SetupPoint;
using reorient::SetupValues;
using reorient::Trial;

constexpr std::size_t most_points = 20'000;
constexpr std::size_t most_cells = 200;
constexpr std::size_t most_confirmed = 6;
constexpr double steps_per_deg = 10.0;

/// The angles and accuracy that reorient() takes where nothing is said of them.
ReorientJob with_defaults(const AnalyseJob& job) {
  return {.job = {.machine = job.job.machine, .path = ClText{}}};
}

/// The best of a coarse grid after the setup that the job has: no other is worth its name if it is
/// not better than that.
std::vector<Trial> first_trials(const SetupValues& values, const reorient::SetupDomain& domain,
                                const SetupPoint& own) {
  constexpr int steps_x = 6, steps_z = 12;
  constexpr std::size_t most_of_grid = 4;
  const auto place = [&](std::size_t dimension, int step, int steps) {
    const auto whole = domain.coordinates[dimension].whole();
    return whole.lower + (whole.upper - whole.lower) * step / steps;
  };
  std::vector<Trial> grid;
  reorient::Hints hints;
  for (int x = 0; x <= steps_x; ++x)
    for (int z = 0; z <= steps_z; ++z) {
      const SetupPoint setup{place(0, x, steps_x), place(1, z, steps_z), own.origin_mm};
      const double value = values.evaluate(setup, hints, reorient::coarse_tolerance).value;
      if (std::isfinite(value)) grid.push_back({setup, value});
    }
  std::stable_sort(grid.begin(), grid.end(),
                   [](const Trial& x, const Trial& y) { return x.value < y.value; });
  if (grid.size() > most_of_grid) grid.resize(most_of_grid);
  grid.insert(grid.begin(), {own, 0.0});
  return grid;
}

}  // namespace

std::optional<SetupPoint> quick_setup(const AnalyseJob& job, const PreparedJob& in_cl) {
  if (in_cl.model.rotary_count != 2 || in_cl.read.tool_path.size() > most_points ||
      !has_speed_limit(in_cl))
    return std::nullopt;
  const ReorientJob defaults = with_defaults(job);
  const auto domain = setup_choices(defaults, in_cl);
  Diagnostics unused;
  const auto clearance = clearance_check(job.job, in_cl, std::nullopt, false, unused);
  if (!domain || !clearance) return std::nullopt;

  const bool origin_known = job.job.setup.origin_mm.has_value();
  const reorient::PathLoads loads =
      path_loads(in_cl, origin_known && !missing_gauge_length(job.job, in_cl.read.tool_path));
  const SetupValues values{in_cl.model, loads, Goal::peak_ratio,
                           defaults.setup_accuracy_deg * rad_per_deg};
  const SetupAnalysis setups{in_cl, origin_known};
  const reorient::SetupChecks checks{
      .is_clear =
          [&](const SetupPoint& setup) {
            const Mat3 turn =
                turn_of({.theta_x_deg = setup.theta_x_deg, .theta_z_deg = setup.theta_z_deg});
            return !*clearance || !(*clearance)->first_collision(turn, setup.origin_mm);
          },
      .confirm = [&](const SetupPoint& setup, double value) -> std::optional<double> {
        const auto analysed = setups.analyse(setup, {});
        if (!analysed) return std::nullopt;
        return std::max(value, peak_ratio_of(*analysed));
      }};
  const SetupPoint own{job.job.setup.theta_x_deg, job.job.setup.theta_z_deg,
                       in_cl.settings.origin_mm};
  const auto found =
      reorient::find_best(values, *domain, first_trials(values, *domain, own), checks,
                          {.most_cells = most_cells,
                           .most_confirmed = most_confirmed,
                           .steps_per_unit = steps_per_deg});
  if (!found.best || found.best->setup == own) return std::nullopt;
  return found.best->setup;
}

}  // namespace pentapost::jobs
