#include "lib/jobs/job_case.hpp"
#include "pentapost/jobs/analyse.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

namespace pentapost {
namespace {

constexpr double step_deg = 10.0;

std::string goto_line(double x_mm, double tilt_deg, double azimuth_deg) {
  const double tilt = tilt_deg * rad_per_deg, azimuth = azimuth_deg * rad_per_deg;
  char text[160];
  std::snprintf(text, sizeof text, "GOTO/%.4f,0.0,0.0,%.9f,%.9f,%.9f\n", x_mm,
                std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth),
                std::cos(tilt));
  return text;
}

/// The tool axis goes round the z axis at a tilt of 20 deg, one point each 10 deg; rapid moves to
/// the points `air`. Point i stands on CL line i + 5 and the number of rapid moves up to it.
std::string winding(int steps, const std::set<int>& air = {}) {
  std::string path;
  for (int i = 0; i <= steps; ++i)
    path += (air.contains(i) ? "RAPID\n" : "") + goto_line(0.5 * i, 20.0, step_deg * i);
  return sample::cl_program(path);
}

jobs::PostReport post(const std::string& machine, const std::string& cl) {
  auto posted = jobs::post(sample::cl_job(machine, cl));
  if (!posted) throw std::runtime_error{posted.error().message};
  return std::move(posted).value();
}

const jobs::AxisReport& axis(const jobs::PostReport& report, const std::string& name) {
  for (const auto& axis : report.axes)
    if (axis.name == name) return axis;
  throw std::runtime_error{"no axis " + name};
}

/// C within +-190 can start at -180 and is turned back by 360 at most: `steps` * 10 deg need
/// (path - 370) / 360 retracts, rounded up.
TEST(Winding, RetractsAsOftenAsTheRangeMakesNecessary) {
  EXPECT_EQ(post("huron-kx100", winding(37)).retracts.size(), 0U);
  EXPECT_EQ(post("huron-kx100", winding(38)).retracts.size(), 1U);
  EXPECT_EQ(post("huron-kx100", winding(360)).retracts.size(), 9U);
}

/// C within +-360 can start at -270 (the head tilts about x) and is turned back by 720 at most:
/// (path - 630) / 720 retracts, rounded up.
TEST(Winding, RewindsOverTheWholeRange) {
  EXPECT_EQ(post("makino-mag3", winding(63)).retracts.size(), 0U);
  EXPECT_EQ(post("makino-mag3", winding(64)).retracts.size(), 1U);
  EXPECT_EQ(post("makino-mag3", winding(1044)).retracts.size(), 14U);
}

/// More turns than any table of states holds.
TEST(Winding, HundredsOfTurnsAreRewoundAsWell) {
  EXPECT_EQ(post("huron-kx100", winding(7200)).retracts.size(), 199U);
  EXPECT_EQ(post("makino-mag3", winding(7200)).retracts.size(), 100U);
}

TEST(Winding, AWideRangeThatIsExceededAfterAllIsRewoundOnce) {
  EXPECT_EQ(post("dmu-50-evolution", winding(7200)).retracts.size(), 1U);
}

TEST(Winding, AWideRangeNeedsNoRetract) {
  EXPECT_TRUE(post("dmu-50-evolution", winding(720)).retracts.empty());
}

/// The analysis sees the program's own retracts, and C within its range all the way.
TEST(Winding, IsAnalysedAsItIsPosted) {
  for (const int steps : {37, 38, 360}) {
    const auto job = sample::cl_job("huron-kx100", winding(steps));
    const auto report = jobs::analyse({.job = job});
    ASSERT_TRUE(report) << report.error().message;
    const auto retracts = std::count_if(
        report->repositionings.begin(), report->repositionings.end(),
        [](const auto& each) { return each.kind == analysis::Repositioning::Kind::retract; });
    EXPECT_EQ(static_cast<std::size_t>(retracts),
              post("huron-kx100", winding(steps)).retracts.size());
    const auto c = std::find_if(report->axes.begin(), report->axes.end(),
                                [](const auto& each) { return each.name == "C"; });
    ASSERT_NE(c, report->axes.end());
    EXPECT_GE(c->span.value().lower, -190.0 - 1e-6);
    EXPECT_LE(c->span.value().upper, 190.0 + 1e-6);
  }
}

TEST(Winding, AnEndlessAxisRunsPastAFullTurn) {
  const auto report = post("hermle-c600u", winding(720));

  EXPECT_TRUE(report.retracts.empty());
  EXPECT_NEAR(axis(report, "C").max - axis(report, "C").min, 7200.0, 0.01);
}

/// With C from -180 a path of 684 deg can be rewound at 350 to 370 deg only: points 35 to 37.
TEST(Winding, TheRetractLiesWithinTheFeasibleStretch) {
  const auto report = post("huron-kx100", winding(68));

  ASSERT_EQ(report.retracts.size(), 1U);
  EXPECT_GE(report.retracts[0].cl_line, 5U + 34U);
  EXPECT_LE(report.retracts[0].cl_line, 5U + 38U);
}

/// With C from -270 a path of 1000 deg can be turned back by 540 at 450 to 630 deg, by 720 at 630;
/// the rapid to point 50 is in the midst.
TEST(Winding, AnAirMoveIsTheCheapestPlace) {
  const auto report = post("makino-mag3", winding(100, {50}));

  ASSERT_EQ(report.retracts.size(), 1U);
  // The rapid starts at point 49 and ends at point 50.
  EXPECT_TRUE(report.retracts[0].cl_line == 5U + 49U || report.retracts[0].cl_line == 6U + 50U)
      << report.retracts[0].cl_line;
}

/// Fanuc: G49 may move the axes by the tool length, so that the tool is at its safe end before.
TEST(Winding, TheProgramSaysWhyItRetractsAndTurnsWithoutTcp) {
  const std::string nc = post("huron-kx100", winding(38)).nc;
  const auto comment = nc.find("RETRACT TO REPOSITION") != std::string::npos
                           ? nc.find("RETRACT TO REPOSITION")
                           : nc.find("retract to reposition");
  ASSERT_NE(comment, std::string::npos);
  const auto off = nc.find("G49", comment);
  const auto home = nc.find("G28", comment);
  const auto on = nc.find("G43.4", comment);
  EXPECT_LT(home, off);
  EXPECT_LT(off, on);
  EXPECT_NE(on, std::string::npos);
}

TEST(Winding, TheReportWarnsOfARetract) {
  const auto report = post("huron-kx100", winding(38));
  int warnings = 0;
  for (const auto& diagnostic : report.diagnostics.list())
    if (diagnostic.code == Code::retract_inserted) ++warnings;
  EXPECT_EQ(warnings, 1);
}

/// Through the pole to the other side: B has one sign only, so C turns by 180 deg in place.
TEST(Winding, WithOneSidedTiltCTurnsAtThePole) {
  std::string path;
  for (int i = 0; i <= 20; ++i) path += goto_line(i, 5.0 * std::abs(10 - i), i < 10 ? 30.0 : 210.0);
  for (const char* const machine : {"haas-umc-750", "dmu-70-evo"}) {
    auto job = sample::cl_job(machine, sample::cl_program(path));
    job.limits["C"].max_speed = 1.0;
    const auto posted = jobs::post(job);
    ASSERT_TRUE(posted) << posted.error().message;

    EXPECT_TRUE(posted->retracts.empty()) << machine;
    EXPECT_GE(axis(*posted, "B").min, -0.001) << machine;
    EXPECT_GE(axis(*posted, "C").max - axis(*posted, "C").min, 179.0) << machine;
  }
}

/// The second axis could go on with the other sign, but the first one would leave its range at the
/// pole: the start that the preference wants leads nowhere, another one does.
TEST(Winding, ThePoleItselfHasToLieWithinTheRange) {
  std::string path;
  for (int i = 0; i <= 4; ++i) path += goto_line(i, 2.0 * (4 - i), 179.0);
  auto job = sample::cl_job("generic-ca-head", sample::cl_program(path));
  const auto posted = jobs::post(job);
  ASSERT_TRUE(posted) << posted.error().message;

  EXPECT_GE(axis(*posted, "C").min, -200.0);
  EXPECT_LE(axis(*posted, "C").max, 200.0);
}

TEST(Winding, AfterHomeATouchDownByFeedIsProven) {
  const std::string path = goto_line(0, 5, 0) + goto_line(1, 6, 0) + "GOHOME\n" +
                           goto_line(20, 7, 40) + goto_line(21, 8, 40) + "LOADTL/2\n" +
                           goto_line(5, 3, 10) + goto_line(6, 3, 10);
  EXPECT_TRUE(post("hermle-c600u", sample::cl_program(path)).verification.passed);
}

}  // namespace
}  // namespace pentapost
