#include "lib/jobs/window_jobs.hpp"
#include "pentapost/plan/candidates.hpp"
#include "pentapost/reorient/setup_values.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace pentapost {
namespace {

using jobs::Objective;
using reorient::Coordinate;
using reorient::Goal;
using reorient::SetupDomain;
using sample::SetupOracle;
using sample::WindowJob;

/// What jobs::reorient() makes of a job, for one goal.
struct Bounds {
  Bounds(const jobs::PreparedJob& prepared, Goal goal, double accuracy_deg)
      : loads{prepared.model, reorient::pieces_of(prepared.read.tool_path, prepared.settings),
              limits(prepared)},
        values{prepared.model, loads, goal, accuracy_deg * rad_per_deg} {}

  static reorient::PathLoads::Limits limits(const jobs::PreparedJob& prepared) {
    const analysis::Allowance allowance{analysis::speed_limits(prepared.model, prepared.settings),
                                        1.0};
    bool has_linear = false;
    for (std::size_t i = 0; i < analysis::first_axis; ++i)
      has_linear = has_linear || allowance.time_per_way_s[i] > 0.0;
    return {.shares = {.time_per_way_s = allowance.time_per_way_s, .has_linear = has_linear},
            .ranges = prepared.ranges,
            .check_linear = false,
            .slack_rad = std::max(prepared.read.tool_path.axis_rounding_rad,
                                  plan::axis_freedom_rad(prepared.settings.axis_tolerance_rad,
                                                         prepared.settings.flank)),
            .preferred_branch = 0,
            .rule = {prepared.model, prepared.ranges, prepared.settings, prepared.read.tool_path}};
  }

  reorient::PathLoads loads;
  reorient::SetupValues values;
};

/// Every setup of a random cell is worth at least what the bound of the cell says.
void expect_bounds_hold(std::uint64_t seed, Objective objective, Goal goal, double accuracy_deg,
                        int jobs_count) {
  const auto machines = sample::bundled_machines();
  sample::WindowJobs jobs{seed, machines};
  std::mt19937_64 random{seed};
  const auto real = [&](double lower, double upper) {
    return std::uniform_real_distribution<double>{lower, upper}(random);
  };
  int checked = 0;
  for (int i = 0; i < jobs_count; ++i) {
    WindowJob window = jobs.next(objective, accuracy_deg, 8);
    window.job.job.setup.origin_mm.reset();
    const SetupOracle oracle{window.job.job};
    const Bounds bounds{oracle.prepared_job(), goal, accuracy_deg};
    const Vec3 origin_mm = oracle.prepared_job().settings.origin_mm;
    for (int k = 0; k < 6; ++k) {
      const double size_deg = std::exp(real(std::log(0.003), std::log(4.0)));
      const double x_deg = window.theta_x_deg.front() + real(0.0, 2.0);
      const double z_deg = window.theta_z_deg.front() + real(0.0, 2.0);
      const SetupDomain domain{
          .coordinates = {Coordinate::interval(x_deg, x_deg + size_deg),
                          Coordinate::interval(z_deg, z_deg + size_deg),
                          Coordinate::list({origin_mm.x()}), Coordinate::list({origin_mm.y()}),
                          Coordinate::list({origin_mm.z()})},
          .forbidden = {}};
      const auto cell = reorient::whole(domain);
      reorient::Hints hints;
      const auto middle =
          bounds.values.evaluate(reorient::middle(domain, cell), hints, reorient::coarse_tolerance);
      const bool impossible = bounds.values.is_impossible(domain, cell, middle);
      const double least = bounds.values.least_value(domain, cell, middle, hints.places);
      for (int n = 0; n < 6; ++n) {
        const double at_x_deg = x_deg + size_deg * real(0.0, 1.0);
        const double at_z_deg = z_deg + size_deg * real(0.0, 1.0);
        const double found =
            oracle.value_about(objective, sample::paper_turn(at_x_deg, at_z_deg), accuracy_deg, 48);
        if (!std::isfinite(found)) continue;
        const auto name = [&] {
          return "job " + std::to_string(i) + " on " + window.job.job.machine.name + " cell " +
                 std::to_string(x_deg) + ", " + std::to_string(z_deg) + " size " +
                 std::to_string(size_deg) + " at " + std::to_string(at_x_deg) + ", " +
                 std::to_string(at_z_deg);
        };
        ASSERT_FALSE(impossible) << name();
        constexpr double rounding = 1.0 + 1e-9;
        EXPECT_LE(least, rounding * (goal == Goal::travel ? found * rad_per_deg : found)) << name();
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 10 * jobs_count);
}

TEST(SetupBounds, OfExactPeaksHoldInTheWholeCell) {
  expect_bounds_hold(201, Objective::peak_ratio, Goal::peak_ratio, 0.0, 200);
}

TEST(SetupBounds, OfPeaksHoldInTheWholeCell) {
  expect_bounds_hold(202, Objective::peak_ratio, Goal::peak_ratio, 0.02, 30);
  expect_bounds_hold(203, Objective::peak_ratio, Goal::peak_ratio, 0.2, 30);
}

TEST(SetupBounds, OfTimesHoldInTheWholeCell) {
  expect_bounds_hold(204, Objective::time, Goal::time, 0.0, 60);
  expect_bounds_hold(205, Objective::time, Goal::time, 0.1, 20);
}

TEST(SetupBounds, OfTravelsHoldInTheWholeCell) {
  expect_bounds_hold(206, Objective::rotary_travel, Goal::travel, 0.0, 60);
  expect_bounds_hold(207, Objective::rotary_travel, Goal::travel, 0.1, 20);
}

}  // namespace
}  // namespace pentapost
