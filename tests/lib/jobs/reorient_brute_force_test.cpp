#include "lib/jobs/window_jobs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace pentapost {
namespace {

using jobs::Objective;
using sample::SetupOracle;
using sample::WindowJob;
using sample::WindowJobs;

constexpr double infinite = std::numeric_limits<double>::infinity();

double best_of_grid(const SetupOracle& oracle, const WindowJob& window) {
  constexpr int round = 24;
  double best = infinite;
  for (const double x_deg : window.theta_x_deg)
    for (const double z_deg : window.theta_z_deg) {
      const Mat3 to_table = sample::paper_turn(x_deg, z_deg);
      // Most setups are worse than the best so far by themselves.
      if (oracle.value(window.job.objective, to_table) >= best) continue;
      best = std::min(best, oracle.value_about(window.job.objective, to_table,
                                               window.job.setup_accuracy_deg, round));
    }
  return best;
}

double value_of(Objective objective, const jobs::SetupReport& setup) {
  switch (objective) {
    case Objective::time:
      return setup.predicted_time_s;
    case Objective::rotary_travel:
      return setup.rotary_travel_deg;
    case Objective::peak_ratio:
      break;
  }
  return setup.peak_unbounded ? infinite : setup.peak_ratio.value_or(0.0);
}

bool is_of_choice(const jobs::AngleChoice& choice, double angle_deg) {
  if (choice.step_deg && std::remainder(angle_deg, *choice.step_deg) != 0.0) return false;
  const auto& list = choice.allowed_deg;
  return list.empty() || std::find(list.begin(), list.end(), angle_deg) != list.end();
}

bool is_allowed(const jobs::ReorientJob& job, const jobs::Setup& setup) {
  if (std::abs(setup.theta_x_deg) > job.max_tilt_deg) return false;
  if (!is_of_choice(job.theta_x, setup.theta_x_deg) ||
      !is_of_choice(job.theta_z, setup.theta_z_deg))
    return false;
  for (const auto& each : job.forbidden)
    if ((!each.theta_x_deg || each.theta_x_deg->contains(setup.theta_x_deg)) &&
        (!each.theta_z_deg || each.theta_z_deg->contains(setup.theta_z_deg)))
      return false;
  return true;
}

std::string name_of(const WindowJob& window, int index) {
  return "job " + std::to_string(index) + " on " + window.job.job.machine.name + ", theta_x from " +
         std::to_string(window.theta_x_deg.front()) + ", theta_z from " +
         std::to_string(window.theta_z_deg.front()) + ", accuracy " +
         std::to_string(window.job.setup_accuracy_deg);
}

/// Searches `count` windows and tries every setup of a grid in them.
void expect_none_better(std::uint64_t seed, Objective objective, double accuracy_deg, int steps,
                        int count) {
  const auto machines = sample::bundled_machines();
  WindowJobs jobs{seed, machines};
  int possible = 0;
  for (int i = 0; i < count; ++i) {
    const WindowJob window = jobs.next(objective, accuracy_deg, steps);
    const std::string name = name_of(window, i);
    const auto report = jobs::reorient(window.job);
    ASSERT_TRUE(report) << name << ": " << report.error().message;
    const SetupOracle oracle{window.job.job};
    const double grid = best_of_grid(oracle, window);
    if (!report->best) {
      EXPECT_EQ(grid, infinite) << name;
      EXPECT_TRUE(report->obstacle) << name;
      continue;
    }
    EXPECT_TRUE(is_allowed(window.job, report->best->setup)) << name;
    const double best = value_of(objective, *report->best);
    if (!std::isfinite(grid)) continue;
    ++possible;
    EXPECT_LE(best, grid + report->optimality_gap.value_or(0.0) + 1e-6 * grid)
        << name << " gap " << report->optimality_gap.value_or(-1.0);
    const Mat3 to_table =
        sample::paper_turn(report->best->setup.theta_x_deg, report->best->setup.theta_z_deg);
    EXPECT_GE(best, (1.0 - 1e-9) * oracle.value(objective, to_table)) << name;
  }
  EXPECT_GT(possible, count / 3);
}

TEST(ReorientBruteForce, NoExactSetupHasALowerPeak) {
  expect_none_better(101, Objective::peak_ratio, 0.0, 10, 120);
}

TEST(ReorientBruteForce, NoSetupOfFineAccuracyHasALowerPeak) {
  expect_none_better(102, Objective::peak_ratio, 0.02, 8, 60);
}

TEST(ReorientBruteForce, NoSetupOfCoarseAccuracyHasALowerPeak) {
  expect_none_better(103, Objective::peak_ratio, 0.2, 8, 60);
}

/// The ratio of a setup once depended on which places of the path were tried first.
TEST(ReorientBruteForce, NoSetupIsTakenForBetterThanItIs) {
  expect_none_better(6103, Objective::peak_ratio, 0.2, 8, 31);
  expect_none_better(7103, Objective::peak_ratio, 0.2, 8, 37);
}

TEST(ReorientBruteForce, NoSetupTakesLessTime) {
  expect_none_better(104, Objective::time, 0.0, 8, 50);
  expect_none_better(105, Objective::time, 0.1, 6, 20);
}

TEST(ReorientBruteForce, NoSetupTravelsLess) {
  expect_none_better(106, Objective::rotary_travel, 0.0, 8, 50);
  expect_none_better(107, Objective::rotary_travel, 0.1, 6, 20);
}

}  // namespace
}  // namespace pentapost
