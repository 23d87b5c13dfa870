#include "pentapost/jobs/analyse.hpp"

#include "lib/jobs/job_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace pentapost {
namespace {

using kinematics::SingularityKind;

jobs::AnalyseJob cripps_job(const std::string& file) {
  return {.job = sample::cl_job("hermle-c600u", sample::papers_text(file))};
}

jobs::AnalyseReport analysed(const jobs::AnalyseJob& job) {
  auto report = jobs::analyse(job);
  EXPECT_TRUE(report) << report.error().message;
  return report ? *report : jobs::AnalyseReport{};
}

const jobs::AxisDemandReport& axis(const jobs::AnalyseReport& report, const std::string& name) {
  return *std::find_if(report.axes.begin(), report.axes.end(),
                       [&](const auto& each) { return each.name == name; });
}

bool warns(const jobs::AnalyseReport& report, Code code) {
  const auto& list = report.diagnostics.list();
  return std::any_of(list.begin(), list.end(), [&](const auto& each) { return each.code == code; });
}

/// A cut of `feed_mm_min` through two points that tilts by 30 deg over 10 mm.
jobs::AnalyseJob tilt_job(const std::string& machine, double feed_mm_min) {
  return {.job = {.machine = sample::bundled_machine(machine),
                  .path = jobs::PointPath{.feed_mm_min = feed_mm_min,
                                          .tip_mm = {Vec3{0, 0, 0}, Vec3{10, 0, 0}},
                                          .axis = {Vec3{0, 0.6, 0.8}, Vec3{0, 0.8, 0.6}}}}};
}

/// Cripps et al. 2017, section 2, on the polyline of 1 mm that the file holds.
TEST(AnalyseCripps, FindsTheZoneOfTheOriginalPath) {
  const auto report = analysed(cripps_job("cripps-2017-original.cl"));
  EXPECT_NEAR(report.closest_approach_deg.value(), 1.000, 0.0005);
  const auto& c = axis(report, "C");
  EXPECT_NEAR(c.peak_speed, 198.9 * 6.0, 0.6);
  EXPECT_NEAR(c.speed_limit.value(), 150.0, 1e-9);
  EXPECT_NEAR(c.peak_at.value().tip_wp_mm.x(), 25.0, 1e-3);
  ASSERT_EQ(report.zones.zones.size(), 1U);
  const auto& zone = report.zones.zones.front();
  EXPECT_EQ(zone.kind, SingularityKind::pole);
  EXPECT_EQ(zone.axis, "C");
  EXPECT_NEAR(zone.from.tip_wp_mm.x(), 21.61, 0.05);
  EXPECT_NEAR(zone.to.tip_wp_mm.x(), 28.39, 0.05);
  EXPECT_NEAR(zone.closest_deg.value(), 1.000, 0.0005);
  EXPECT_NEAR(report.peak_ratio.value(), 198.9 / 25.0, 0.005);
}

TEST(AnalyseCripps, FindsNoZoneInTheReorientedPath) {
  const auto report = analysed(cripps_job("cripps-2017-reoriented.cl"));
  EXPECT_NEAR(report.closest_approach_deg.value(), 11.000, 0.0005);
  EXPECT_NEAR(axis(report, "C").peak_speed, 18.2 * 6.0, 0.6);
  EXPECT_TRUE(report.zones.zones.empty());
}

/// A theta_x of -10 deg turns the part by +10 deg about +x. Where the path is nearest to the pole
/// its axis leans by 1 deg towards -y already.
TEST(AnalyseSetup, TurnsThePathAwayFromThePole) {
  auto job = cripps_job("cripps-2017-original.cl");
  job.job.setup.theta_x_deg = -10.0;
  const auto report = analysed(job);
  EXPECT_NEAR(report.closest_approach_deg.value(), 11.000, 0.0005);
  EXPECT_TRUE(report.zones.zones.empty());
}

/// Places and singular directions are those of the part, however it is clamped: turned by +10 deg
/// about +x, the table's +z is the part's (0, sin 10, cos 10).
TEST(AnalyseSetup, ReportsInClCoordinates) {
  auto job = cripps_job("cripps-2017-original.cl");
  job.job.setup.theta_x_deg = -10.0;
  const auto report = analysed(job);
  ASSERT_EQ(report.singular_directions.size(), 1U);
  EXPECT_NEAR(
      (report.singular_directions[0].direction - Vec3{0.0, 0.17364817766693, 0.98480775301221})
          .norm(),
      0.0, 1e-12);
  const Vec3& tip_mm = axis(report, "C").peak_at.value().tip_wp_mm;
  EXPECT_NEAR(tip_mm.y(), 0.0, 1e-9);
  EXPECT_NEAR(tip_mm.z(), -8.0, 1e-9);
}

/// C of the C600U turns about z; its A goes to 110 deg, short of the pole at 180 deg.
TEST(AnalyseSingularDirections, LeaveOutWhatTheRangesDoNotReach) {
  const auto report = analysed(tilt_job("hermle-c600u", 600.0));
  ASSERT_EQ(report.singular_directions.size(), 1U);
  EXPECT_EQ(report.singular_directions[0].kind, SingularityKind::pole);
  EXPECT_EQ(report.singular_directions[0].direction, Vec3::UnitZ());
  EXPECT_EQ(report.singular_directions[0].half_angle_deg, 0.0);
}

machine::Chain with_endless_table(const machine::Chain& chain) {
  std::vector<machine::Joint> table{chain.table().begin(), chain.table().end()};
  for (auto& joint : table)
    if (auto* rotary = std::get_if<machine::RotaryJoint>(&joint.kind)) rotary->range.reset();
  return *machine::Chain::make(table, {chain.head().begin(), chain.head().end()},
                               UnitVector::normalised(Vec3::UnitZ()));
}

TEST(AnalyseSingularDirections, HaveThePoleOfAnEndlessTilt) {
  auto job = tilt_job("hermle-c600u", 600.0);
  job.job.machine.chain = with_endless_table(job.job.machine.chain);
  const auto report = analysed(job);
  ASSERT_EQ(report.singular_directions.size(), 2U);
  EXPECT_EQ(report.singular_directions[1].direction, Vec3(0.0, 0.0, -1.0));
}

/// At 105 deg from the pole at z the other one would be nearer, but A stops at 110 deg.
TEST(AnalyseSingularDirections, AreApproachedOnlyWithinTheRanges) {
  jobs::AnalyseJob job{
      .job = sample::cl_job("hermle-c600u",
                            sample::cl_program("GOTO/0,0,0,0,0.96592583,-0.25881905\n"
                                               "GOTO/5,0,0,0,0.98480775,-0.17364818\n"))};
  EXPECT_NEAR(analysed(job).closest_approach_deg.value(), 100.0, 1e-6);
  job.job.machine.chain = with_endless_table(job.job.machine.chain);
  EXPECT_NEAR(analysed(job).closest_approach_deg.value(), 75.0, 1e-6);
}

TEST(AnalyseThreeAxes, HaveNoSingularity) {
  const jobs::AnalyseJob job{
      .job = sample::cl_job("generic-3axis",
                            sample::cl_program("GOTO/0,0,0,0,0,1\nGOTO/30,40,0,0,0,1\n"))};
  const auto report = analysed(job);
  EXPECT_TRUE(report.singular_directions.empty());
  EXPECT_TRUE(report.zones.zones.empty());
  EXPECT_EQ(report.closest_approach_deg, std::nullopt);
  ASSERT_EQ(report.axes.size(), 3U);
  EXPECT_NEAR(report.length_mm, 50.0, 1e-12);
  EXPECT_NEAR(report.programmed_time_s, 3.0, 1e-12);
  EXPECT_NEAR(axis(report, "Y").peak_speed, 1000.0 / 60.0 * 0.8, 1e-9);
  EXPECT_EQ(axis(report, "Z").peak_at, std::nullopt);
}

/// The axis turns by 16.26 deg over 10 mm in the plane of A alone: no amplification.
TEST(AnalyseOverDemand, IsNoZone) {
  const auto report = analysed(tilt_job("hermle-c600u", 12000.0));
  EXPECT_TRUE(report.zones.zones.empty());
  ASSERT_EQ(report.over_demands.zones.size(), 1U);
  EXPECT_EQ(report.over_demands.zones[0].axis, "A");
  EXPECT_EQ(report.over_demands.zones[0].kind, std::nullopt);
  EXPECT_NEAR(report.over_demands.zones[0].peak_speed, 16.2602047083 / 0.05, 1e-6);
  EXPECT_NEAR(report.over_demands.zones[0].lowest_feed_mm_min, 12000.0 * 150.0 / 325.204094166,
              1e-3);
}

TEST(AnalyseZoneShare, WidensAndNarrowsZones) {
  auto job = cripps_job("cripps-2017-original.cl");
  job.zone_share = 0.5;
  EXPECT_LT(analysed(job).zones.zones.at(0).from.tip_wp_mm.x(), 21.0);
  job.zone_share = 8.0;
  EXPECT_TRUE(analysed(job).zones.zones.empty());
}

TEST(AnalyseZoneShare, IsAboveZero) {
  for (const double share : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
    auto job = tilt_job("hermle-c600u", 600.0);
    job.zone_share = share;
    const auto report = jobs::analyse(job);
    ASSERT_FALSE(report) << share;
    EXPECT_EQ(report.error().code, Code::out_of_domain);
    EXPECT_EQ(report.error().pointer, "/zone_share");
  }
}

TEST(AnalyseNumbers, AreRefusedWhereTheyOverflow) {
  auto job = tilt_job("hermle-c600u", 1e-310);
  EXPECT_EQ(jobs::analyse(job).error().code, Code::out_of_domain);
  job = tilt_job("hermle-c600u", 1e300);
  EXPECT_TRUE(jobs::analyse(job));
  job.job.limits["A"].max_speed = 1e-300;
  EXPECT_EQ(jobs::analyse(job).error().code, Code::out_of_domain);
}

TEST(AnalyseAssumptions, AreNamed) {
  auto job = tilt_job("hermle-c600u", 600.0);
  EXPECT_TRUE(warns(analysed(job), Code::origin_assumed));
  EXPECT_FALSE(warns(analysed(job), Code::gauge_length_assumed));
  job.job.setup.origin_mm = Vec3{0.0, 0.0, 0.0};
  EXPECT_FALSE(warns(analysed(job), Code::origin_assumed));

  job = tilt_job("generic-ca-head", 600.0);
  EXPECT_TRUE(warns(analysed(job), Code::gauge_length_assumed));
  EXPECT_FALSE(warns(analysed(job), Code::origin_assumed));
  job.job.gauge_length_mm = {{1, 100.0}};
  EXPECT_FALSE(warns(analysed(job), Code::gauge_length_assumed));
}

TEST(AnalyseHoles, AreSingleMoves) {
  const jobs::AnalyseJob job{
      .job = sample::cl_job("generic-3axis", sample::cl_program("GOTO/0,0,10,0,0,1\n"
                                                                "CYCLE/DRILL,DEPTH,5,MMPM,300,"
                                                                "CLEAR,2\nGOTO/10,0,0,0,0,1\n"
                                                                "CYCLE/OFF\n"))};
  const auto report = analysed(job);
  EXPECT_GT(report.points, 2U);
  EXPECT_GT(report.length_mm, 0.0);
}

}  // namespace
}  // namespace pentapost
