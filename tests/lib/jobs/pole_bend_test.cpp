#include "lib/jobs/job_case.hpp"

#include "pentapost/jobs/analyse.hpp"
#include "pentapost/kinematics/model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace pentapost {
namespace {

using sample::span;
using sample::words;

/// Tool axis on a great circle that passes +Z at `miss_deg`, `along_deg` from the nearest place.
std::string goto_line(double x_mm, double along_deg, double miss_deg, double sense = 1.0) {
  const double u = along_deg * rad_per_deg, v = miss_deg * rad_per_deg;
  char text[160];
  std::snprintf(text, sizeof text, "GOTO/%.4f,0.0,0.0,%.12f,%.12f,%.12f\n", x_mm, std::sin(u),
                std::cos(u) * std::sin(v), sense * std::cos(u) * std::cos(v));
  return text;
}

/// One long move over 60 mm, from 30 deg on one side of the pole to 30 deg on the other.
std::string sparse_pass(double miss_deg, double sense = 1.0) {
  return goto_line(0, -30, miss_deg, sense) + goto_line(60, 30, miss_deg, sense);
}

jobs::PostJob bent_job(const std::string& machine, const std::string& gotos, double eps_deg) {
  jobs::PostJob job = sample::cl_job(machine, sample::cl_program(gotos));
  job.post.pole_axis_deg = eps_deg;
  job.gauge_length_mm = {{1, 100.0}};
  return job;
}

jobs::PostJob cripps_job(double eps_deg, Output output) {
  jobs::PostJob job =
      sample::cl_job("hermle-c600u", sample::papers_text("cripps-2017-original.cl"));
  job.tolerances.axis_deg = 0.1;
  job.post.pole_axis_deg = eps_deg;
  job.post.output = output;
  return job;
}

/// Largest turn of C for each mm of X in the cutting blocks.
double fastest_c_deg_mm(const std::string& nc) {
  double fastest = 0.0;
  std::optional<std::array<double, 2>> before;
  for (const std::string& block : sample::motion_words(nc)) {
    const auto x = block.find('X'), c = block.find('C');
    if (x == std::string::npos || c == std::string::npos) continue;
    const std::array<double, 2> here{std::strtod(block.c_str() + x + 1, nullptr),
                                     std::strtod(block.c_str() + c + 1, nullptr)};
    if (before && here[0] != (*before)[0])
      fastest =
          std::max(fastest, std::abs(here[1] - (*before)[1]) / std::abs(here[0] - (*before)[0]));
    before = here;
  }
  return fastest;
}

void expect_left_alone(jobs::PostJob job) {
  const auto with = jobs::post(job);
  ASSERT_TRUE(with) << with.error().message;
  job.post.pole_axis_deg = 0.0;
  const auto without = jobs::post(job);
  ASSERT_TRUE(without) << without.error().message;
  EXPECT_TRUE(with->pole_bends.empty());
  EXPECT_EQ(with->nc, without->nc);
}

/// The path of Cripps et al. passes the pole at 1.000 deg; C may turn at 150 deg/s, which at 2000
/// mm/min are 4.5 deg a mm (of the original path: 1193 deg/s).
TEST(PoleBend, TamesCOnThePathOfCripps) {
  const auto posted = jobs::post(cripps_job(1.05, Output::tcp));
  ASSERT_TRUE(posted) << posted.error().message;
  EXPECT_LT(fastest_c_deg_mm(posted->nc), 4.5);
  const auto a = words(posted->nc, 'A');
  const auto [least, most] = std::minmax_element(a.begin(), a.end());
  EXPECT_LT(*least, -14.0);
  EXPECT_GT(*most, 14.0);
}

/// On the continuous path, whose corners are CL points: below 150 deg/s all along.
TEST(PoleBend, TheAnalysisSeesTheBentPath) {
  const auto report = jobs::analyse({.job = cripps_job(1.05, Output::tcp)});
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_TRUE(report->zones.zones.empty());
  EXPECT_TRUE(report->over_demands.zones.empty());
  ASSERT_TRUE(report->pole_axis_change_deg);
  EXPECT_NEAR(*report->pole_axis_change_deg, 1.0, 0.01);
  const auto original = jobs::analyse({.job = cripps_job(0.0, Output::tcp)});
  ASSERT_TRUE(original) << original.error().message;
  EXPECT_EQ(original->zones.total, 1U);
  EXPECT_FALSE(original->pole_axis_change_deg);
}

/// The CL's corner of 3.6 deg at the nearest place is rounded off: a little more than 1.000 deg.
TEST(PoleBend, ChangesThePathOfCrippsByOneDegree) {
  const auto posted = jobs::post(cripps_job(1.05, Output::tcp));
  ASSERT_TRUE(posted) << posted.error().message;
  ASSERT_EQ(posted->pole_bends.size(), 1U);
  EXPECT_NEAR(posted->pole_bends.front().change_deg, 1.0, 0.01);
  EXPECT_EQ(posted->pole_axis_change_deg, posted->pole_bends.front().change_deg);
  EXPECT_GE(posted->verification.axis_deviation_deg, 0.999);
  EXPECT_LE(posted->verification.axis_deviation_deg, 1.05);
  EXPECT_TRUE(posted->retracts.empty());
}

TEST(PoleBend, ProvesThePathOfCrippsInJointValues) {
  const auto posted = jobs::post(cripps_job(1.05, Output::axes));
  ASSERT_TRUE(posted) << posted.error().message;
  EXPECT_EQ(posted->pole_bends.size(), 1U);
  EXPECT_LE(posted->verification.tip_deviation_mm, 0.01);
  EXPECT_LE(posted->verification.axis_deviation_deg, 1.05);
}

TEST(PoleBend, APassageFartherThanAllowedIsLeftAlone) {
  expect_left_alone(cripps_job(0.9, Output::tcp));
  expect_left_alone(cripps_job(0.9, Output::axes));
}

/// Without bending C turns by 179 deg; now by delta / rho (2 x - x^3) <= 1.089 sqrt(delta /
/// 2), 3.19 deg, either way.
TEST(PoleBend, ASparseMovePassesThroughThePole) {
  for (const Output output : {Output::tcp, Output::axes}) {
    jobs::PostJob job = bent_job("hermle-c600u", sparse_pass(0.3), 0.5);
    job.post.output = output;
    const auto posted = jobs::post(job);
    ASSERT_TRUE(posted) << posted.error().message;
    ASSERT_EQ(posted->pole_bends.size(), 1U);
    EXPECT_NEAR(posted->pole_bends.front().change_deg, 0.3, 1e-4);
    EXPECT_GT(posted->inserted_points, 20U);
    EXPECT_EQ(posted->cl_points, 2U);
    auto c = words(posted->nc, 'C');
    EXPECT_LT(span(c), 6.4);
    EXPECT_NEAR(posted->length_mm, 60.0, 1e-9);
  }
}

TEST(PoleBend, TheProgramSaysSo) {
  const auto posted = jobs::post(bent_job("hermle-c600u", sparse_pass(0.3), 0.5));
  ASSERT_TRUE(posted) << posted.error().message;
  EXPECT_NE(posted->nc.find("changed by up to 0.3 deg near the pole at"), std::string::npos)
      << posted->nc.substr(0, 1500);
}

/// The other pole of a machine whose head reaches below the horizon.
TEST(PoleBend, BothPolesOfAChainAreBent) {
  for (const double sense : {1.0, -1.0}) {
    jobs::PostJob job = bent_job("linuxcnc-xyzac-trt", sparse_pass(0.3, sense), 0.5);
    std::vector<machine::Joint> table{job.machine.chain.table().begin(),
                                      job.machine.chain.table().end()};
    for (machine::Joint& joint : table)
      if (auto* rotary = std::get_if<machine::RotaryJoint>(&joint.kind)) rotary->range.reset();
    const auto head = job.machine.chain.head();
    job.machine.chain =
        machine::Chain::make(table, {head.begin(), head.end()}, job.machine.chain.tool_axis())
            .value();
    for (const char* name : {"A", "C"}) job.limits[name].max_speed = 1.0;
    const auto posted = jobs::post(job);
    ASSERT_TRUE(posted) << posted.error().message;
    EXPECT_EQ(posted->pole_bends.size(), 1U) << sense;
    EXPECT_TRUE(posted->retracts.empty());
  }
}

/// There C turns by -1/2 cos(45 deg) of B by nature: 0.354 of 85 deg (B is 2 asin(sin 15 / sin 45)
/// on each side) where the tool tilts by 30 deg on both sides, and a little more farther out.
TEST(PoleBend, ANutatingTableIsTamedToo) {
  jobs::PostJob job =
      bent_job("dmu-80p-duoblock", goto_line(0, -8, 0.3) + goto_line(60, 8, 0.3), 0.5);
  std::vector<machine::Joint> table{job.machine.chain.table().begin(),
                                    job.machine.chain.table().end()};
  std::vector<machine::Joint> head{job.machine.chain.head().begin(),
                                   job.machine.chain.head().end()};
  for (auto* joints : {&table, &head})
    for (machine::Joint& joint : *joints)
      if (auto* rotary = std::get_if<machine::RotaryJoint>(&joint.kind)) rotary->range.reset();
  job.machine.chain = machine::Chain::make(table, head, job.machine.chain.tool_axis()).value();
  const auto posted = jobs::post(job);
  ASSERT_TRUE(posted) << posted.error().message;
  ASSERT_EQ(posted->pole_bends.size(), 1U);
  auto c = words(posted->nc, 'C');
  c.pop_back();  // the way out along the tool axis
  EXPECT_LT(span(c), 0.36 * 23.0 + 4.3 + 1.0);
}

TEST(PoleBend, AHeadHeadMachineIsTamedToo) {
  for (const auto& each : sample::bundled_machines()) {
    const machine::Definition& definition = each.definition;
    const kinematics::Model model{definition.chain};
    const auto table = definition.chain.table();
    const bool turns = std::any_of(table.begin(), table.end(),
                                   [](const auto& joint) { return joint.is_rotary(); });
    if (model.rotary_count != 2 || turns || std::abs(model.a.z()) < 0.99) continue;
    jobs::PostJob job = bent_job("hermle-c600u", sparse_pass(0.3), 0.5);
    job.machine = definition;
    const auto posted = jobs::post(job);
    ASSERT_TRUE(posted) << definition.name << ": " << posted.error().message;
    EXPECT_EQ(posted->pole_bends.size(), 1U) << definition.name;
  }
}

TEST(PoleBend, APathThatEndsNearThePoleIsLeftAlone) {
  expect_left_alone(
      bent_job("hermle-c600u", goto_line(0, -30, 0.3) + goto_line(30, 0.1, 0.3), 0.5));
}

TEST(PoleBend, ARapidBesideThePoleIsLeftAlone) {
  expect_left_alone(bent_job("hermle-c600u",
                             goto_line(0, -30, 0.3) + goto_line(30, -0.1, 0.3) + "RAPID\n" +
                                 goto_line(31, 0.1, 0.3) + goto_line(60, 30, 0.3),
                             0.5));
}

/// Below 3 times 0.3 deg of straight feed on one side there is no room.
TEST(PoleBend, ARapidShortlyAfterThePassageLeavesNoRoom) {
  expect_left_alone(bent_job(
      "hermle-c600u",
      goto_line(0, -30, 0.3) + goto_line(30, 0.8, 0.3) + "RAPID\n" + goto_line(60, 30, 0.3), 0.5));
}

TEST(PoleBend, ARangeWithoutNegativeTiltLeavesThePassageAlone) {
  jobs::PostJob job = bent_job("hermle-c600u", sparse_pass(0.3), 0.5);
  std::vector<machine::Joint> table{job.machine.chain.table().begin(),
                                    job.machine.chain.table().end()};
  for (machine::Joint& joint : table)
    if (joint.name == "A")
      std::get<machine::RotaryJoint>(joint.kind).range =
          Range<Angle>{Angle::degrees(-5.0), Angle::degrees(110.0)};
  const auto head = job.machine.chain.head();
  job.machine.chain =
      machine::Chain::make(table, {head.begin(), head.end()}, job.machine.chain.tool_axis())
          .value();
  expect_left_alone(job);
}

/// In to 0.3 deg from the pole and out again the same way: C hardly turns without a bend.
TEST(PoleBend, APathThatTurnsAboutBesideThePoleIsLeftAlone) {
  expect_left_alone(
      bent_job("hermle-c600u",
               goto_line(0, 0, 20) + goto_line(20, 0.01, 0.3) + goto_line(40, 0.02, 20), 0.5));
}

TEST(PoleBend, AFlankCutHasNoFreedom) {
  jobs::PostJob job = bent_job("hermle-c600u", sparse_pass(0.3), 0.5);
  job.post.flank = true;
  const auto posted = jobs::post(job);
  ASSERT_FALSE(posted);
  EXPECT_EQ(posted.error().code, Code::conflicting_keys);
  EXPECT_EQ(posted.error().pointer, "/post/pole_axis_deg");
}

/// Events stay before the move that they were before.
TEST(PoleBend, AFeedChangedBeforeThePassageHoldsForItsInsertedPoints) {
  const auto posted =
      jobs::post(bent_job("hermle-c600u",
                          goto_line(-5, -35, 0.3) + goto_line(0, -30, 0.3) + "FEDRAT/321,MMPM\n" +
                              goto_line(60, 30, 0.3) + "FEDRAT/123,MMPM\n" + goto_line(70, 35, 0.3),
                          0.5));
  ASSERT_TRUE(posted) << posted.error().message;
  ASSERT_EQ(posted->pole_bends.size(), 1U);
  const auto first = posted->nc.find("F321"), second = posted->nc.find("F123");
  ASSERT_NE(first, std::string::npos);
  ASSERT_NE(second, std::string::npos);
  const std::string between = posted->nc.substr(first, second - first);
  EXPECT_GT(std::count(between.begin(), between.end(), '\n'), 20);
  EXPECT_EQ(posted->nc.substr(second).find("F321"), std::string::npos);
}

}  // namespace
}  // namespace pentapost
