#include "pentapost/reorient/branch_rule.hpp"

#include "lib/jobs/job_case.hpp"
#include "lib/jobs/window_jobs.hpp"
#include "pentapost/plan/choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace pentapost {
namespace {

using sample::SetupOracle;

/// Angles between the pole and the tool axes all along the moves, great circles.
Range<double> gammas(const path::ToolPath& tool_path, const Vec3& pole) {
  Range<double> found{pi, 0.0};
  constexpr int steps = 50;
  for (std::size_t i = 0; i < tool_path.size(); ++i) {
    const Vec3& to = tool_path.axis_wp[i];
    const Vec3& from = i == 0 ? to : tool_path.axis_wp[i - 1];
    for (int k = 0; k <= steps; ++k) {
      const double share = static_cast<double>(k) / steps;
      const double gamma = angle_between_rad(pole, (1.0 - share) * from + share * to);
      found = {std::min(found.lower, gamma), std::max(found.upper, gamma)};
    }
  }
  constexpr double between = 1e-4;
  return {std::max(0.0, found.lower - between), std::min(pi, found.upper + between)};
}

/// In random setups of random paths, on machines of every topology.
TEST(BranchRule, SettlesOnTheBranchThatThePlanTakesAllAlong) {
  const auto machines = sample::bundled_machines();
  sample::WindowJobs jobs{31, machines};
  std::map<std::string, int> settled_on;
  for (int i = 0; i < 600; ++i) {
    const auto window = jobs.next(jobs::Objective::peak_ratio, 0.0, 8);
    const SetupOracle oracle{window.job.job};
    const jobs::PreparedJob& prepared = oracle.prepared_job();
    const Mat3 to_table =
        sample::paper_turn(window.theta_x_deg.front(), window.theta_z_deg.front());
    path::ToolPath turned = prepared.read.tool_path;
    path::turn(turned, to_table);
    const reorient::BranchRule rule{prepared.model, prepared.ranges, prepared.settings,
                                    prepared.read.tool_path};
    const reorient::AxisRates rates{prepared.model, 0.0};
    const auto branch =
        rule.settled(rates, gammas(turned, prepared.model.fixed.a_drawn),
                     (prepared.settings.origin_mm - prepared.model.a_point_mm).norm());
    if (!branch) continue;
    const auto size = static_cast<std::uint32_t>(turned.size());
    const auto choice = plan::choose(prepared.model, prepared.ranges, turned, {0, size},
                                     prepared.settings, 0.0, false);
    ASSERT_TRUE(choice) << window.job.job.machine.name << ": " << choice.error().message;
    for (const auto each : choice->axis_path.branch)
      ASSERT_EQ(each, *branch) << "job " << i << " on " << window.job.job.machine.name;
    ++settled_on[window.job.job.machine.name];
  }
  for (const char* machine : {"hermle-c600u", "dmu-50-evolution", "dmu-125p", "dmu-80-monoblock"})
    EXPECT_GE(settled_on[machine], 5) << machine;
}

/// Both branches of an A from -120 to 120 deg serve: nothing tells them apart.
TEST(BranchRule, SettlesNothingWithoutAPreference) {
  auto job = sample::cl_job("hermle-c600u", sample::papers_text("cripps-2017-reoriented.cl"));
  job.machine.preferences.tilt.reset();
  const SetupOracle oracle{job};
  const jobs::PreparedJob& prepared = oracle.prepared_job();
  const reorient::BranchRule rule{prepared.model, prepared.ranges, prepared.settings,
                                  prepared.read.tool_path};
  const reorient::AxisRates rates{prepared.model, 0.0};
  EXPECT_EQ(rule.settled(rates, {0.3, 0.6}, 0.0), std::nullopt);
}

/// The wrong tilt costs 10,000 s: a path of 3,000 km at 250 mm/s costs more than that.
TEST(BranchRule, SettlesNothingWhereTheWayCostsMoreThanTheTilt) {
  const auto settled = [](double length_mm) {
    jobs::PostJob job{.machine = sample::bundled_machine("hermle-c600u"),
                      .path = jobs::PointPath{.feed_mm_min = 1000.0,
                                              .tip_mm = {Vec3{0, 0, 0}, Vec3{length_mm, 0, 0}},
                                              .axis = {Vec3{0, 0.6, 0.8}, Vec3{0, 0.7, 0.8}}}};
    job.machine.limits.clear();
    const SetupOracle oracle{job};
    const jobs::PreparedJob& prepared = oracle.prepared_job();
    const reorient::AxisRates rates{prepared.model, 0.0};
    return reorient::BranchRule{prepared.model, prepared.ranges, prepared.settings,
                                prepared.read.tool_path}
        .settled(rates, {0.5, 0.8}, 0.0);
  };
  EXPECT_TRUE(settled(1e3));
  EXPECT_FALSE(settled(3e6));
}

}  // namespace
}  // namespace pentapost
