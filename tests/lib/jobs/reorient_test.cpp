#include "pentapost/jobs/reorient.hpp"

#include "lib/jobs/job_case.hpp"
#include "lib/jobs/setup_oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pentapost {
namespace {

using jobs::Objective;
using jobs::ReorientJob;
using jobs::ReorientReport;

ReorientJob cripps_job() {
  ReorientJob job{
      .job = sample::cl_job("hermle-c600u", sample::papers_text("cripps-2017-original.cl"))};
  job.setup_accuracy_deg = 0.0;
  return job;
}

ReorientReport reoriented(const ReorientJob& job) {
  auto report = jobs::reorient(job);
  EXPECT_TRUE(report) << report.error().message;
  return report ? *std::move(report) : ReorientReport{};
}

const jobs::SetupAxisReport& axis(const jobs::SetupReport& setup, const std::string& name) {
  return *std::find_if(setup.axes.begin(), setup.axes.end(),
                       [&](const auto& each) { return each.demand.name == name; });
}

/// A cut of `feed_mm_min` along X that tilts towards +Y.
ReorientJob tilt_job(const std::string& machine, double feed_mm_min) {
  return {.job = {.machine = sample::bundled_machine(machine),
                  .path = jobs::PointPath{.feed_mm_min = feed_mm_min,
                                          .tip_mm = {Vec3{0, 0, 0}, Vec3{10, 0, 0}},
                                          .axis = {Vec3{0, 0.6, 0.8}, Vec3{0, 0.8, 0.6}}}}};
}

/// Cripps et al. 2017: 18.2 rpm are 109.1 deg/s.
TEST(ReorientCripps, EvaluatesTheSetupOfThePaper) {
  ReorientJob job = cripps_job();
  job.candidates = {{-10.0, 0.0}, {10.0, 0.0}};
  const auto report = reoriented(job);
  ASSERT_EQ(report.candidates.size(), 2U);
  EXPECT_NEAR(axis(report.candidates[0], "C").demand.peak_speed, 109.1, 0.3);
  EXPECT_NEAR(report.candidates[0].closest_approach_deg.value(), 11.0, 0.05);
  EXPECT_NEAR(axis(report.candidates[1], "C").demand.peak_speed / 6.0, 22.2, 0.05);
  EXPECT_NEAR(report.candidates[1].closest_approach_deg.value(), 9.0, 0.05);
}

TEST(ReorientCripps, FindsNothingWorseThanTheSetupOfThePaper) {
  ReorientJob job = cripps_job();
  job.max_tilt_deg = 10.0;
  const auto report = reoriented(job);
  ASSERT_TRUE(report.best && report.best->peak_ratio);
  EXPECT_LE(report.best->tilt_deg, 10.0);
  const double of_paper =
      sample::SetupOracle{job.job}.value(Objective::peak_ratio, sample::paper_turn(-10.0, 0.0));
  EXPECT_NEAR(of_paper, 109.1 / 150.0, 0.002);
  EXPECT_LE(*report.best->peak_ratio, (1.0 + 1e-9) * of_paper);
  EXPECT_TRUE(report.best->within_limits);
}

TEST(ReorientCripps, SetupCanBePosted) {
  ReorientJob job = cripps_job();
  job.max_tilt_deg = 10.0;
  const auto report = reoriented(job);
  ASSERT_TRUE(report.best);
  jobs::PostJob posted_job = job.job;
  posted_job.setup = report.best->setup;
  const auto posted = jobs::post(posted_job);
  ASSERT_TRUE(posted) << posted.error().message;
  EXPECT_TRUE(posted->verification.passed);
}

/// Against a scan of all turns at tilts about the one found.
TEST(ReorientCripps, FindsTheSmallestTiltToAHundredthOfADegree) {
  const ReorientJob job = cripps_job();
  const auto report = reoriented(job);
  ASSERT_TRUE(report.smallest_tilt && report.smallest_tilt->peak_ratio);
  EXPECT_LE(*report.smallest_tilt->peak_ratio, 1.0 + 1e-9);
  const sample::SetupOracle oracle{job.job};
  const double smaller_deg = report.smallest_tilt->tilt_deg - 0.01;
  for (const double sign : {-1.0, 1.0})
    for (double z_deg = -180.0; z_deg < 180.0; z_deg += 0.5)
      ASSERT_GT(oracle.value(Objective::peak_ratio, sample::paper_turn(sign * smaller_deg, z_deg)),
                1.0)
          << sign * smaller_deg << ", " << z_deg;
}

TEST(ReorientMachine, NeedsTwoRotaryAxes) {
  const auto report = jobs::reorient(tilt_job("generic-3axis", 600.0));
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, Code::not_reorientable);
}

TEST(ReorientMachine, NeedsASpeedLimitButForTheTravel) {
  ReorientJob job = tilt_job("linuxcnc-bridgemill", 600.0);
  for (const Objective objective : {Objective::peak_ratio, Objective::time}) {
    job.objective = objective;
    const auto report = jobs::reorient(job);
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().code, Code::no_speed_limit);
  }
  job.objective = Objective::rotary_travel;
  EXPECT_TRUE(reoriented(job).best);
}

TEST(ReorientObstacle, NamesTheAxisThatIsTooSlow) {
  ReorientJob job = tilt_job("hermle-c600u", 60'000.0);
  job.max_tilt_deg = 1.0;
  const auto report = reoriented(job);
  ASSERT_TRUE(report.best && report.obstacle);
  EXPECT_FALSE(report.best->within_limits);
  EXPECT_EQ(report.obstacle->kind, jobs::Obstacle::Kind::speed);
  EXPECT_FALSE(report.obstacle->axis.empty());
}

/// From below nothing reaches the part.
TEST(ReorientObstacle, IsThereWhereNoSetupIsPossible) {
  ReorientJob job = tilt_job("dmu-50-evolution", 600.0);
  job.job.limits["C"].max_speed = 1.0;
  job.job.path = jobs::PointPath{.feed_mm_min = 600.0,
                                 .tip_mm = {Vec3{0, 0, 0}, Vec3{1, 0, 0}},
                                 .axis = {Vec3{0, 0, -1}, Vec3{0, 0.1, -1}}};
  const auto report = reoriented(job);
  EXPECT_FALSE(report.best);
  EXPECT_FALSE(report.baseline.possible);
  EXPECT_TRUE(report.obstacle);
}

/// So far off that its length is no number.
TEST(ReorientObstacle, IsThereWhereThePathIsTooLong) {
  ReorientJob job = tilt_job("hermle-c600u", 600.0);
  job.job.path = jobs::PointPath{.feed_mm_min = 600.0,
                                 .tip_mm = {Vec3{-1e308, 0, 0}, Vec3{1e308, 0, 0}},
                                 .axis = {Vec3{0, 0.6, 0.8}, Vec3{0, 0.8, 0.6}}};
  const auto report = jobs::reorient(job);
  if (!report) return;
  EXPECT_FALSE(report->best);
  EXPECT_FALSE(report->smallest_tilt);
  EXPECT_TRUE(report->obstacle);
}

TEST(ReorientPath, MayBeOnePoint) {
  ReorientJob job = tilt_job("hermle-c600u", 600.0);
  job.job.path =
      jobs::PointPath{.feed_mm_min = 600.0, .tip_mm = {Vec3{0, 0, 0}}, .axis = {Vec3{0, 0, 1}}};
  EXPECT_TRUE(reoriented(job).best);
}

TEST(ReorientPath, MayKeepTheToolAxisAtRest) {
  ReorientJob job = tilt_job("hermle-c600u", 600.0);
  job.job.path = jobs::PointPath{.feed_mm_min = 600.0,
                                 .tip_mm = {Vec3{0, 0, 0}, Vec3{10, 0, 0}, Vec3{10, 10, 0}},
                                 .axis = {Vec3{0, 0, 1}, Vec3{0, 0, 1}, Vec3{0, 0, 1}}};
  const auto report = reoriented(job);
  ASSERT_TRUE(report.best && report.best->peak_ratio);
  EXPECT_EQ(*report.best->peak_ratio, 0.0);
}

}  // namespace
}  // namespace pentapost
