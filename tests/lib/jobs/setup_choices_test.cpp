#include "lib/jobs/job_case.hpp"
#include "lib/jobs/setup_oracle.hpp"
#include "pentapost/jobs/reorient.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pentapost {
namespace {

using jobs::Objective;
using jobs::ReorientJob;
using jobs::ReorientReport;

/// From the pole of a C table outwards and back; the setup (0, 0) is a bad one.
ReorientJob pole_job(const std::string& machine) {
  jobs::PointPath path{.feed_mm_min = 1500.0, .tip_mm = {}, .axis = {}};
  for (int i = 0; i <= 20; ++i) {
    const double t = i / 20.0;
    path.tip_mm.emplace_back(40.0 * t, 5.0 * t * t, 0.0);
    path.axis.push_back(Vec3{0.5 * (t - 0.5), 0.02 + 0.3 * t * t, 1.0}.normalized());
  }
  return {.job = {.machine = sample::bundled_machine(machine), .path = std::move(path)}};
}

ReorientReport reoriented(const ReorientJob& job) {
  auto report = jobs::reorient(job);
  EXPECT_TRUE(report) << report.error().message;
  return report ? *std::move(report) : ReorientReport{};
}

std::vector<const jobs::SetupReport*> answers(const ReorientReport& report) {
  std::vector<const jobs::SetupReport*> found;
  if (report.best) found.push_back(&*report.best);
  if (report.smallest_tilt) found.push_back(&*report.smallest_tilt);
  for (const auto& each : report.pareto) found.push_back(&each);
  return found;
}

bool contains(const std::vector<double>& values, double value) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

/// With and without a map, whose setups the jig need not hold, and candidates that it does not.
std::vector<ReorientJob> asked_in_every_way(const ReorientJob& job) {
  ReorientJob with_map = job, with_candidates = job;
  with_map.map_step_deg = 3.0;
  with_candidates.candidates = {{7.0, 12.0}, {-22.5, 142.5}, {29.0, -37.0}};
  return {job, with_map, with_candidates};
}

void expect_best_of_lists(const ReorientJob& job, const std::vector<double>& theta_x_deg,
                          const std::vector<double>& theta_z_deg) {
  const sample::SetupOracle oracle{job.job};
  constexpr int round = 24;
  double least = std::numeric_limits<double>::infinity();
  for (const double x_deg : theta_x_deg)
    for (const double z_deg : theta_z_deg)
      least = std::min(least, oracle.value_about(job.objective, sample::paper_turn(x_deg, z_deg),
                                                 job.setup_accuracy_deg, round));
  for (const ReorientJob& each : asked_in_every_way(job)) {
    const auto report = reoriented(each);
    ASSERT_TRUE(report.best && report.best->peak_ratio) << each.job.machine.name;
    for (const auto* answer : answers(report)) {
      EXPECT_TRUE(contains(theta_x_deg, answer->setup.theta_x_deg)) << answer->setup.theta_x_deg;
      EXPECT_TRUE(contains(theta_z_deg, answer->setup.theta_z_deg)) << answer->setup.theta_z_deg;
    }
    constexpr double exact = 2e-3;
    EXPECT_NEAR(*report.best->peak_ratio, least, exact * least) << each.job.machine.name;
  }
}

TEST(SetupChoices, OfAListAreAllTriedAndNoOthers) {
  const std::vector<double> x_deg{-28.0, -9.0, 11.0, 17.0}, z_deg{-150.0, -31.0, 44.0, 100.0};
  for (const char* machine : {"hermle-c600u", "dmu-50-evolution", "pocket-nc-v2", "dmu-125p"}) {
    ReorientJob job = pole_job(machine);
    job.job.limits[job.job.machine.name == "pocket-nc-v2" ? "B" : "C"].max_speed = 1.0;
    job.theta_x.allowed_deg = x_deg;
    job.theta_z.allowed_deg = z_deg;
    expect_best_of_lists(job, x_deg, z_deg);
  }
}

TEST(SetupChoices, OfAStepAreAllTriedAndNoOthers) {
  ReorientJob job = pole_job("hermle-c600u");
  job.theta_x.step_deg = 20.0;
  job.theta_z.step_deg = 50.0;
  expect_best_of_lists(job, {-20.0, 0.0, 20.0}, {-150.0, -100.0, -50.0, 0.0, 50.0, 100.0, 150.0});
}

TEST(SetupChoices, MayBeOneAngle) {
  ReorientJob job = pole_job("hermle-c600u");
  job.theta_x.allowed_deg = {5.0};
  job.theta_z.allowed_deg = {0.0};
  expect_best_of_lists(job, {5.0}, {0.0});
}

TEST(SetupChoices, LeaveOutWhatIsForbidden) {
  ReorientJob job = pole_job("hermle-c600u");
  job.forbidden = {{.theta_x_deg = Range<double>{-5.0, 40.0}},
                   {.theta_z_deg = Range<double>{-90.0, 90.0}}};
  for (const ReorientJob& each : asked_in_every_way(job)) {
    const auto report = reoriented(each);
    for (const auto* answer : answers(report)) {
      EXPECT_LT(answer->setup.theta_x_deg, -5.0);
      EXPECT_GT(std::abs(answer->setup.theta_z_deg), 90.0);
    }
  }
}

TEST(SetupChoices, HaveNoTiltAtAllWhereNoneIsAllowed) {
  ReorientJob job = pole_job("hermle-c600u");
  job.max_tilt_deg = 0.0;
  for (const ReorientJob& each : asked_in_every_way(job)) {
    const auto report = reoriented(each);
    ASSERT_TRUE(report.best);
    EXPECT_EQ(report.best->setup.theta_x_deg, 0.0);
    EXPECT_FALSE(std::signbit(report.best->setup.theta_x_deg));
  }
}

/// A turn of the part is one of the table where C is endless: nothing is worse for it.
TEST(SetupChoices, TakeABaselineOfWholeTurnsForWhatItIs) {
  ReorientJob job = pole_job("hermle-c600u");
  job.max_tilt_deg = 12.0;
  const auto plain = reoriented(job);
  job.job.setup.theta_z_deg = 360.0;
  const auto turned = reoriented(job);
  ASSERT_TRUE(plain.best && turned.best);
  EXPECT_NEAR(*plain.best->peak_ratio, *turned.best->peak_ratio, 2e-3 * *plain.best->peak_ratio);
}

bool is_within(const std::array<Range<double>, 3>& bounds, const Vec3& origin_mm) {
  return bounds[0].contains(origin_mm.x()) && bounds[1].contains(origin_mm.y()) &&
         bounds[2].contains(origin_mm.z());
}

TEST(SetupChoices, KeepTheOriginWithinItsBounds) {
  const std::array<Range<double>, 3> bounds{{{10.0, 60.0}, {-20.0, -5.0}, {30.0, 30.0}}};
  for (const double accuracy_deg : {0.0, 0.02})
    for (const char* machine : {"hermle-c600u", "generic-ca-head"}) {
      ReorientJob job = pole_job(machine);
      job.setup_accuracy_deg = accuracy_deg;
      job.job.limits["C"].max_speed = 1.0;
      job.job.setup.origin_mm = Vec3{300.0, 0.0, 0.0};
      job.origin_mm = bounds;
      for (const ReorientJob& each : asked_in_every_way(job)) {
        const auto report = reoriented(each);
        EXPECT_TRUE(report.best) << machine;
        for (const auto* answer : answers(report))
          EXPECT_TRUE(is_within(bounds, answer->setup.origin_mm.value())) << machine;
      }
    }
}

/// Rotary axes alone have limits, and without a gauge length no range is known to hold: where the
/// part lies on the table is all the same.
TEST(SetupChoices, LeaveTheOriginWhereNothingTellsPlacesApart) {
  ReorientJob job = pole_job("dmu-50-evolution");
  job.job.limits["C"].max_speed = 1.0;
  job.job.setup.origin_mm = Vec3{20.0, -10.0, 50.0};
  const auto fixed = reoriented(job);
  job.origin_mm = {{{-100.0, 100.0}, {-100.0, 100.0}, {0.0, 40.0}}};
  const auto free = reoriented(job);
  ASSERT_TRUE(fixed.best && free.best && free.optimality_gap);
  EXPECT_EQ(free.best->setup.origin_mm.value(), Vec3(20.0, -10.0, 40.0));
  EXPECT_NEAR(*free.best->peak_ratio, *fixed.best->peak_ratio, 2e-3 * *fixed.best->peak_ratio);
  EXPECT_NEAR(*free.optimality_gap, *fixed.optimality_gap, 0.01 * *free.best->peak_ratio);
}

}  // namespace
}  // namespace pentapost
