#include "lib/jobs/job_case.hpp"
#include "lib/jobs/random_job.hpp"

#include "pentapost/jobs/analyse.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace pentapost {
namespace {

using kinematics::SingularityKind;
using RepositioningKind = analysis::Repositioning::Kind;

jobs::AnalyseJob nc_job(const std::string& machine, std::string text,
                        std::optional<std::string> dialect = {}) {
  return {.job = {.machine = sample::bundled_machine(machine), .path = {}},
          .nc = jobs::NcProgram{std::move(text), std::move(dialect)}};
}

jobs::AnalyseReport analysed(const jobs::AnalyseJob& job) {
  auto report = jobs::analyse(job);
  EXPECT_TRUE(report) << report.error().message;
  return report ? *report : jobs::AnalyseReport{};
}

Problem refused(const jobs::AnalyseJob& job) {
  auto report = jobs::analyse(job);
  EXPECT_FALSE(report);
  return report ? Problem{.code = Code::count_, .message = {}} : report.error();
}

jobs::AxisDemandReport axis(const jobs::AnalyseReport& report, const std::string& name) {
  const auto found = std::find_if(report.axes.begin(), report.axes.end(),
                                  [&](const auto& each) { return each.name == name; });
  return found == report.axes.end() ? jobs::AxisDemandReport{} : *found;
}

std::size_t count_of(const jobs::AnalyseReport& report, Code code) {
  const auto& list = report.diagnostics.list();
  return static_cast<std::size_t>(
      std::count_if(list.begin(), list.end(), [&](const auto& each) { return each.code == code; }));
}

/// A program for the C600U with TCP on, at `words` beyond its opening.
std::string tcp_program(const std::string& words) {
  return "%TEST G71 *\nN10 G90 *\nN20 T5 G17 S8000 *\nN30 M13 *\nN40 M128 *\n" + words +
         "N900 M129 *\nN910 M30 *\nN99999999 %TEST G71 *\n";
}

/// Cripps et al. 2017, appendix, as published: the control moves A and C linearly within a block.
TEST(AnalyseNcCripps, FindsTheZoneOfTheOriginalProgram) {
  const auto report =
      analysed(nc_job("hermle-c600u", sample::papers_text("cripps-2017-appendix-2.nc")));
  EXPECT_NEAR(report.closest_approach_deg.value(), 1.000, 0.0005);
  EXPECT_NEAR(axis(report, "C").peak_speed / 6.0, 175.0, 0.1);
  ASSERT_EQ(report.zones.zones.size(), 1U);
  const auto& zone = report.zones.zones.front();
  EXPECT_EQ(zone.kind, SingularityKind::pole);
  EXPECT_EQ(zone.axis, "C");
  EXPECT_NEAR(zone.from.tip_wp_mm.x(), 22.0, 1e-9);
  EXPECT_NEAR(zone.to.tip_wp_mm.x(), 28.0, 1e-9);
  EXPECT_NEAR(zone.closest_deg.value(), 1.000, 0.0005);
  EXPECT_TRUE(report.over_demands.zones.empty());
}

TEST(AnalyseNcCripps, FindsNoZoneInTheReorientedProgram) {
  const auto report =
      analysed(nc_job("hermle-c600u", sample::papers_text("cripps-2017-appendix-1.nc")));
  EXPECT_NEAR(report.closest_approach_deg.value(), 11.000, 0.0005);
  EXPECT_NEAR(axis(report, "C").peak_speed / 6.0, 18.1, 0.1);
  EXPECT_TRUE(report.zones.zones.empty());
  EXPECT_TRUE(report.over_demands.zones.empty());
}

/// In block N70 the tool stands in the posture of the pole; N80 turns it in place.
TEST(AnalyseNcCripps, ListTheirTurnInPlaceAsRepositioning) {
  const auto report =
      analysed(nc_job("hermle-c600u", sample::papers_text("cripps-2017-appendix-1.nc")));
  ASSERT_FALSE(report.repositionings.empty());
  const auto turn = std::find_if(report.repositionings.begin(), report.repositionings.end(),
                                 [](const auto& each) { return each.at.line == 13; });
  ASSERT_NE(turn, report.repositionings.end());
  EXPECT_EQ(turn->kind, RepositioningKind::turn_in_place);
  EXPECT_NEAR(turn->time_s.value(), 333.802 / 150.0, 1e-9);
  EXPECT_EQ(turn->at.tip_wp_mm, Vec3(50.0, 50.0, 100.0));
}

/// Two lead-ins of 20 and 108 mm and one of 20 mm, 50 mm of cut, 20 mm out, at 2000 mm/min.
TEST(AnalyseNcCripps, HaveTheLengthAndTimeOfTheirBlocks) {
  const auto report =
      analysed(nc_job("hermle-c600u", sample::papers_text("cripps-2017-appendix-1.nc")));
  EXPECT_NEAR(report.length_mm, 218.0, 1e-9);
  EXPECT_NEAR(report.programmed_time_s, 218.0 * 60.0 / 2000.0, 1e-9);
  EXPECT_EQ(report.operations.size(), 1U);
  EXPECT_EQ(report.operations.at(0).tool_number, 5);
  EXPECT_EQ(report.nc_dialect, "heidenhain-iso");
  EXPECT_EQ(report.nc_lines, 77U);
  EXPECT_EQ(report.nc_sha256.size(), 64U);
  EXPECT_TRUE(report.cl_sha256.empty());
}

/// Along X with C turning by a quarter of a turn: C turns evenly, and is no zone far from its pole.
TEST(AnalyseNcBlocks, TurnTheirRotaryAxesEvenly) {
  const auto report = analysed(nc_job("hermle-c600u", tcp_program("N50 G01 X0 Y0 Z0 A60 C0 F600 *\n"
                                                                  "N60 X10 C90 *\n")));
  EXPECT_NEAR(axis(report, "C").peak_speed, 90.0, 1e-9);
  EXPECT_NEAR(axis(report, "A").peak_speed, 0.0, 1e-12);
  EXPECT_NEAR(report.length_mm, 10.0, 1e-12);
  EXPECT_NEAR(report.programmed_time_s, 1.0, 1e-12);
  EXPECT_NEAR(report.closest_approach_deg.value(), 60.0, 1e-9);
}

/// A passes zero in the middle of the block, where its ends are 10 and 20 deg off.
TEST(AnalyseNcBlocks, AreNearestToThePoleInside) {
  const auto report = analysed(
      nc_job("hermle-c600u", tcp_program("N50 G01 X0 Y0 Z0 A-10 C0 F600 *\nN60 X30 A20 C720 *\n")));
  EXPECT_NEAR(report.closest_approach_deg.value(), 0.0, 1e-9);
  EXPECT_EQ(report.over_demands.total, 0U);
  ASSERT_EQ(report.zones.total, 1U);
  EXPECT_NEAR(report.zones.zones[0].peak_speed, 240.0, 1e-9);
  EXPECT_NEAR(report.zones.zones[0].closest_deg.value(), 0.0, 1e-9);
  // |sin A| * 240 deg/s stays below 150 deg/s all through.
  EXPECT_NEAR(report.zones.zones[0].to.tip_wp_mm.x(), 30.0, 1e-9);
}

/// Places are named by the motion blocks of the program and the lines of its text.
TEST(AnalyseNcBlocks, AreCountedFromZero) {
  const auto report = analysed(nc_job(
      "hermle-c600u",
      tcp_program("N50 G01 X0 Y0 Z0 A10 C0 F600 *\nN60 X30 A20 C720 *\nN70 X30 A20 C0 *\n")));
  EXPECT_EQ(report.nc_blocks, 3U);
  EXPECT_EQ(report.zones.zones.at(0).from.point, 1U);
  EXPECT_EQ(report.zones.zones.at(0).from.line, 7U);
  ASSERT_EQ(report.repositionings.size(), 1U);
  EXPECT_EQ(report.repositionings[0].at.point, 2U);
  EXPECT_EQ(report.repositionings[0].kind, RepositioningKind::turn_in_place);
  EXPECT_NEAR(report.repositionings[0].time_s.value(), 720.0 / 150.0, 1e-9);
}

/// C of the C600U has no end: it winds up, and all of its way counts.
TEST(AnalyseNcBlocks, WindEndlessAxesUp) {
  const auto report = analysed(nc_job(
      "hermle-c600u",
      tcp_program("N50 G01 X0 Y0 Z0 A60 C3600 F600 *\nN60 X100 C7200 *\nN70 X200 C3600 *\n")));
  EXPECT_NEAR(axis(report, "C").peak_speed, 360.0, 1e-9);
  EXPECT_NEAR(axis(report, "C").span.value().lower, 3600.0, 1e-9);
  EXPECT_NEAR(axis(report, "C").span.value().upper, 7200.0, 1e-9);
  EXPECT_NEAR(report.predicted_time_s, 20.0 * 360.0 / 150.0, 0.05);
}

/// A rapid is a repositioning, and s counts its way.
TEST(AnalyseNcBlocks, ThatAreRapidHaveNoFeedDemand) {
  const auto report = analysed(
      nc_job("hermle-c600u", tcp_program("N50 G00 X0 Y0 Z50 A0 C0 *\nN60 G00 Z0 A30 C90 *\n"
                                         "N70 G01 X10 F600 *\n")));
  EXPECT_NEAR(report.length_mm, 10.0, 1e-12);
  EXPECT_NEAR(report.closest_approach_deg.value(), 30.0, 1e-9);
  ASSERT_EQ(report.repositionings.size(), 1U);
  EXPECT_EQ(report.repositionings[0].kind, RepositioningKind::rapid);
  EXPECT_NEAR(report.repositionings[0].at.s_mm, 50.0, 1e-12);
  EXPECT_NEAR(axis(report, "X").peak_at.value().s_mm, 50.0, 10.0 + 1e-9);
}

/// A half circle of radius 10 at 600 mm/min on a table that is tilted.
TEST(AnalyseNcArcs, TakeTheTimeOfTheirLength) {
  const auto report = analysed(
      nc_job("hermle-c600u",
             tcp_program("N50 G01 X0 Y0 Z0 A30 C0 F600 *\nN60 I10 J0 *\nN70 G02 X20 Y0 *\n")));
  EXPECT_NEAR(report.length_mm, 31.41592653589793, 1e-9);
  EXPECT_NEAR(report.programmed_time_s, 3.141592653589793, 1e-9);
}

/// The rotary axes stand: X and Y follow the circle at 10 mm/s.
TEST(AnalyseNcArcs, AskTheFeedOfTheAxesOfTheirPlane) {
  const auto report = analysed(nc_job("generic-3axis",
                                      "%\nO1\nG21 G17 G90 G94 G54\nT1 M6\nG43 H1\nG0 X0. Y0. Z0.\n"
                                      "G3 X0. Y0. I10. J0. F600.\nM30\n%\n",
                                      "fanuc-30i"));
  EXPECT_NEAR(report.length_mm, 62.83185307179586, 1e-9);
  EXPECT_NEAR(axis(report, "X").peak_speed, 10.0, 1e-3);
  EXPECT_NEAR(axis(report, "Y").peak_speed, 10.0, 1e-3);
}

/// Over the hole at rapid, 12 mm down at 120 mm/min, back at rapid.
TEST(AnalyseNcCycles, CutOnceDown) {
  const auto report = analysed(nc_job("generic-3axis",
                                      "%\nO1\nG21 G17 G90 G94 G54\nT1 M6\nG43 H1\nG0 X0. Y0. Z50.\n"
                                      "G98 G83 X10. Y0. Z-10. R2. Q3. F120.\nX20.\nG80\nM30\n%\n",
                                      "fanuc-30i"));
  EXPECT_NEAR(report.length_mm, 24.0, 1e-9);
  EXPECT_NEAR(report.programmed_time_s, 12.0, 1e-9);
  EXPECT_NEAR(axis(report, "Z").peak_speed, 2.0, 1e-9);
  // Across and down to the first hole, up; across and down to the second, up.
  EXPECT_GE(report.repositionings.size(), 4U);
}

TEST(AnalyseNcCycles, OfTappingLeaveAtFeed) {
  const auto report =
      analysed(nc_job("generic-3axis",
                      "%\nO1\nG21 G17 G90 G94 G54\nT1 M6\nG43 H1\nS100 M3\nG0 X0. Y0. Z50.\n"
                      "G98 G84 X10. Y0. Z-10. R2. F120.\nG80\nM30\n%\n",
                      "fanuc-30i"));
  EXPECT_NEAR(report.length_mm, 24.0, 1e-9);
}

std::string axes_program(const std::string& words) {
  return "%\nO1\nG21 G17 G90 G94 G54\nT1 M6\nS8000 M3\nG43 H1\n" + words + "M30\n%\n";
}

/// C turns the table by 360 deg under a tool that stands 50 mm off its axis: a circle of the tip.
TEST(AnalyseNcJointValues, HaveTheLengthOfTheTipsTruePath) {
  const auto report = analysed(nc_job(
      "hermle-c600u", axes_program("G0 X50. Y0. Z0. A0. C0.\nG1 C360. F3600.\n"), "fanuc-30i"));
  EXPECT_NEAR(report.length_mm, 2.0 * pi * 50.0, 1e-9);
  EXPECT_NEAR(report.programmed_time_s, 6.0, 1e-9);  // 360 deg at 3600 deg/min
  EXPECT_NEAR(axis(report, "C").peak_speed, 60.0, 1e-9);
  EXPECT_EQ(axis(report, "X").peak_speed, 0.0);
}

/// F counts millimetres and degrees alike: 30 mm and 40 deg are 50, at 600 a minute.
TEST(AnalyseNcJointValues, WarnOfTheirFeedRuleOnce) {
  const auto report = analysed(
      nc_job("hermle-c600u",
             axes_program("G0 X50. Y0. Z0. A0. C0.\nG1 X80. C40. F600.\nX50. C0.\n"), "fanuc-30i"));
  EXPECT_EQ(count_of(report, Code::feed_rule_assumed), 1U);
  EXPECT_NEAR(report.programmed_time_s, 10.0, 1e-9);
  EXPECT_NEAR(axis(report, "X").peak_speed, 6.0, 1e-9);
  EXPECT_NEAR(axis(report, "C").peak_speed, 8.0, 1e-9);
}

TEST(AnalyseNcJointValues, TakeTheTimeOfInverseTime) {
  const auto report = analysed(
      nc_job("hermle-c600u", axes_program("G0 X50. Y0. Z0. A0. C0.\nG93 G1 X80. C40. F6.\n"),
             "fanuc-30i"));
  EXPECT_EQ(count_of(report, Code::feed_rule_assumed), 0U);
  EXPECT_NEAR(report.programmed_time_s, 10.0, 1e-9);
}

/// The tip is on the axis of C: nothing of it moves.
TEST(AnalyseNcJointValues, ThatTurnAboutTheTipAreRepositionings) {
  const auto report = analysed(
      nc_job("hermle-c600u", axes_program("G0 X0. Y0. Z0. A0. C0.\nG1 C90. F600.\nX10. F600.\n"),
             "fanuc-30i"));
  EXPECT_NEAR(report.length_mm, 10.0, 1e-9);
  ASSERT_EQ(report.repositionings.size(), 1U);
  EXPECT_EQ(report.repositionings[0].kind, RepositioningKind::turn_in_place);
}

/// After the tool change and the retract the first block only says where the tool is.
TEST(AnalyseNcUnknownPlaces, StartThePathAnew) {
  const auto report = analysed(
      nc_job("hermle-c600u",
             axes_program("G1 X0. Y0. Z50. A0. C0. F100.\nG1 Z0. F600.\nG91 G28 Z0.\nG90\n"
                          "G1 X100. Y0. Z0.\nX110.\nG53 X0. Y0.\nG1 X200. Y0. Z0.\nX210.\n"),
             "fanuc-30i"));
  EXPECT_NEAR(report.length_mm, 50.0 + 10.0 + 10.0, 1e-9);
  EXPECT_TRUE(report.repositionings.empty());
}

TEST(AnalyseNcUnknownPlaces, AreNamedWhereAFeedLeadsThere) {
  const auto report = analysed(
      nc_job("hermle-c600u", tcp_program("N50 G01 X0 Y0 Z0 A30 C0 F600 *\nN60 X10 *\nN70 M129 *\n"
                                         "N80 G01 X0 Y0 Z0 A30 C10 F600 *\n")));
  EXPECT_EQ(count_of(report, Code::position_unknown), 1U);
  EXPECT_NEAR(report.length_mm, 10.0, 1e-12);
}

/// Tools are told apart, each with its gauge length.
TEST(AnalyseNcTools, HaveTheirOwnTimes) {
  auto job = nc_job("generic-ca-head",
                    "%\nO1\nG21 G17 G90 G94 G54\nT1 M6\nS8000 M3\nG43.4 H1\n"
                    "G0 X0. Y0. Z0. A10. C0.\nG1 X60. F600.\nG49\nG91 G28 Z0.\nG90\nT2 M6\n"
                    "G43.4 H2\nG0 X0. Y0. Z0. A10. C0.\nG1 X30.\nG49\nM30\n%\n",
                    "fanuc-30i");
  const auto assumed = analysed(job);
  EXPECT_EQ(count_of(assumed, Code::gauge_length_assumed), 1U);
  ASSERT_EQ(assumed.tools.size(), 2U);
  EXPECT_NEAR(assumed.tools.at(1).programmed_time_s, 6.0, 1e-9);
  EXPECT_NEAR(assumed.tools.at(2).programmed_time_s, 3.0, 1e-9);
  job.job.gauge_length_mm = {{1, 100.0}, {2, 50.0}};
  EXPECT_EQ(count_of(analysed(job), Code::gauge_length_assumed), 0U);
}

/// The head turns by 10 deg in a second: its pivot, which lies 200 mm above the gauge line, runs
/// beside the tip's own way.
TEST(AnalyseNcTools, CarryThePivotByTheirGaugeLength) {
  auto job = nc_job("generic-ca-head",
                    "%\nO1\nG21 G17 G90 G94 G54\nT1 M6\nS8000 M3\nG43.4 H1\n"
                    "G0 X0. Y0. Z0. A-5. C0.\nG1 X10. A5. F600.\nG49\nM30\n%\n",
                    "fanuc-30i");
  job.job.gauge_length_mm = {{1, 100.0}};
  EXPECT_NEAR(axis(analysed(job), "Y").peak_speed, 300.0 * 10.0 * rad_per_deg, 0.01);
}

TEST(AnalyseNcErrors, NameTheLineOfTheText) {
  const auto problem = refused(
      nc_job("hermle-c600u", tcp_program("N50 G01 X0 Y0 Z0 A30 C0 F600 *\nN60 X10 Q7 *\n")));
  EXPECT_EQ(problem.code, Code::damaged_block);
  EXPECT_EQ(problem.pointer, "/nc");
  EXPECT_NE(problem.message.find("line 7"), std::string::npos) << problem.message;
}

TEST(AnalyseNcErrors, AreNoFeedAndNoMotion) {
  EXPECT_EQ(
      refused(nc_job("hermle-c600u", tcp_program("N50 G01 X0 Y0 Z0 A3 C0 *\nN60 X9 *\n"))).code,
      Code::no_feed);
  EXPECT_EQ(refused(nc_job("hermle-c600u", tcp_program(""))).code, Code::no_motion);
  EXPECT_EQ(refused(nc_job("hermle-c600u", "")).pointer, "/nc");
  EXPECT_EQ(refused(nc_job("hermle-c600u", tcp_program("N50 G00 X0 Y0 Z0 A3 C0 *\n"))).code,
            Code::no_motion);
}

TEST(AnalyseNcErrors, RefuseATurnOfTheSetup) {
  auto job = nc_job("hermle-c600u", sample::papers_text("cripps-2017-appendix-1.nc"));
  job.job.setup.theta_x_deg = 10.0;
  EXPECT_EQ(refused(job).code, Code::conflicting_keys);
  EXPECT_EQ(refused(job).pointer, "/setup/theta_x_deg");
  job.job.setup = {.theta_z_deg = 10.0};
  EXPECT_EQ(refused(job).pointer, "/setup/theta_z_deg");
}

TEST(AnalyseNcErrors, RefuseADialectThatDoesNotExist) {
  const auto problem = refused(nc_job("hermle-c600u", "%\n", "no-such"));
  EXPECT_EQ(problem.code, Code::unknown_dialect);
  EXPECT_EQ(problem.pointer, "/nc_dialect");
}

TEST(AnalyseNcText, MayEndItsLinesAsItLikes) {
  const std::string text = sample::papers_text("cripps-2017-appendix-2.nc");
  std::string crlf;
  for (const char letter : text) {
    if (letter == '\n') crlf += '\r';
    crlf += letter;
  }
  const auto plain = analysed(nc_job("hermle-c600u", text));
  const auto dos = analysed(nc_job("hermle-c600u", crlf));
  EXPECT_EQ(dos.length_mm, plain.length_mm);
  EXPECT_EQ(dos.nc_lines, plain.nc_lines);
  EXPECT_EQ(dos.zones.zones.at(0).from.line, plain.zones.zones.at(0).from.line);
}

/// Nothing that a program may say crashes, hangs or gives numbers that are none.
TEST(AnalyseNcText, MayBeDamagedInAnyWay) {
  const std::string text = sample::papers_text("cripps-2017-appendix-2.nc");
  std::mt19937_64 random{7};
  const auto whole = [&](std::size_t most) {
    return std::uniform_int_distribution<std::size_t>{0, most}(random);
  };
  constexpr std::string_view letters = "XYZABCFGMNIJKRTS0123456789.+-* \n%";
  auto job = nc_job("hermle-c600u", text);
  int answered = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string damaged = text;
    if (i % 3 == 0) damaged.resize(whole(damaged.size()));
    for (std::size_t hits = i % 3 == 0 ? 0 : 1 + whole(3); hits > 0; --hits)
      damaged[whole(damaged.size() - 1)] = letters[whole(letters.size() - 1)];
    job.nc->text = std::move(damaged);
    const auto report = jobs::analyse(job);
    if (!report) {
      EXPECT_FALSE(report.error().message.empty());
      continue;
    }
    ++answered;
    EXPECT_TRUE(std::isfinite(report->predicted_time_s));
    EXPECT_GE(report->predicted_time_s, report->programmed_time_s * (1.0 - 1e-12));
  }
  EXPECT_GT(answered, 150);
}

/// Thousands of turns in every block take bounded time and memory.
TEST(AnalyseNcText, MayWindThroughThousandsOfTurns) {
  std::string words = "G0 X0. Y0. Z0. A10. C0.\n";
  for (int i = 0; i < 200; ++i) {
    words += "G1 X" + std::to_string(i + 1) + ". A" + (i % 2 == 0 ? "99999" : "-99999") + ". C" +
             (i % 2 == 0 ? "999999" : "-999999") + ". F1000.\n";
  }
  const auto report =
      analysed(nc_job("hermle-c600u", axes_program("G43.4 H1\n" + words), "fanuc-30i"));
  EXPECT_NEAR(axis(report, "C").peak_speed, 1999998.0 / 0.06, 1.0);
}

/// All that /post writes is understood.
TEST(AnalyseNcRandom, TakesWhateverWasPosted) {
  const auto machines = sample::bundled_machines();
  int taken = 0;
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    const sample::RandomJob random{seed, machines};
    auto job = random.job();
    job.setup.theta_x_deg = job.setup.theta_z_deg = 0.0;
    const auto posted = jobs::post(job);
    if (!posted) continue;
    const auto found =
        jobs::analyse({.job = job, .nc = jobs::NcProgram{posted->nc, posted->dialect}});
    if (!found) {
      EXPECT_EQ(found.error().code, Code::no_motion) << seed << ": " << found.error().message;
      continue;
    }
    ++taken;
    EXPECT_EQ(count_of(*found, Code::position_unknown), 0U) << "seed " << seed;
    EXPECT_GE(found->nc_blocks, posted->blocks) << "seed " << seed;
    EXPECT_TRUE(std::isfinite(found->predicted_time_s)) << "seed " << seed;
  }
  EXPECT_GT(taken, 400);
}

/// A path of 60 points 1 to 3 mm apart, whose joints walk through a tenth of a radian a point.
jobs::PostJob walk_job(std::uint64_t seed, const machine::Definition& machine) {
  std::mt19937_64 random{seed};
  const auto real = [&](double lower, double upper) {
    return std::uniform_real_distribution<double>{lower, upper}(random);
  };
  const kinematics::Model model{machine.chain};
  jobs::PointPath path{.feed_mm_min = 600.0, .tip_mm = {}, .axis = {}};
  Vec3 tip_mm = Vec3::Zero();
  double first_rad = real(-0.5, 0.5), second_rad = model.beta_zero_rad + real(0.4, 0.6);
  for (int i = 0; i < 60; ++i) {
    path.tip_mm.push_back(tip_mm);
    path.axis.push_back(kinematics::forward_axis(model, first_rad, second_rad));
    tip_mm += real(1.0, 3.0) * Vec3{real(-1, 1), real(-1, 1), real(-1, 1)}.normalized();
    first_rad += real(-0.02, 0.02);
    second_rad += real(-0.02, 0.02);
  }
  jobs::PostJob job{.machine = machine, .path = std::move(path)};
  job.setup.origin_mm = Vec3{10.0, -20.0, 30.0};
  job.gauge_length_mm = {{1, 100.0}};
  for (const auto& name : model.rotary_names) job.limits[name].max_speed = 1000.0;
  return job;
}

/// But for the plunge of 10 mm that /post may put before the first point, the program has the
/// length, the time, the closest approach and the speeds of the path.
TEST(AnalyseNcRandom, AgreesWithThePathThatItWasPostedFrom) {
  int compared = 0;
  for (const auto& machine : sample::bundled_machines()) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      for (const Output output : {Output::tcp, Output::axes}) {
        for (const char* dialect : {"heidenhain-iso", "fanuc-30i"}) {
          auto job = walk_job(seed, machine.definition);
          job.post.output = output;
          job.post.dialect = dialect;
          const auto posted = jobs::post(job);
          const auto expected = jobs::analyse({.job = job});
          if (!posted || !expected || !posted->retracts.empty()) continue;
          const auto found =
              jobs::analyse({.job = job, .nc = jobs::NcProgram{posted->nc, posted->dialect}});
          ASSERT_TRUE(found) << found.error().message;
          ++compared;
          const std::string where = machine.definition.name + " seed " + std::to_string(seed) +
                                    (output == Output::tcp ? " tcp " : " axes ") + dialect;
          const bool plunges = found->length_mm > expected->length_mm + 5.0;
          EXPECT_NEAR(found->length_mm, expected->length_mm + (plunges ? 10.0 : 0.0),
                      0.01 * expected->length_mm)
              << where;
          EXPECT_NEAR(found->programmed_time_s, expected->programmed_time_s + (plunges ? 1.0 : 0.0),
                      0.01 * expected->programmed_time_s)
              << where;
          EXPECT_NEAR(found->closest_approach_deg.value_or(0.0),
                      expected->closest_approach_deg.value_or(0.0), 0.1)
              << where;
          for (std::size_t i = 0; i < found->axes.size(); ++i) {
            if (found->axes[i].rotary) {
              EXPECT_NEAR(found->axes[i].span.value().upper, expected->axes[i].span.value().upper,
                          0.1)
                  << where;
            }
            EXPECT_NEAR(found->axes[i].peak_speed, expected->axes[i].peak_speed,
                        0.2 * expected->axes[i].peak_speed + 1.0)
                << where << " " << found->axes[i].name;
          }
        }
      }
    }
  }
  EXPECT_GT(compared, 100);
}

}  // namespace
}  // namespace pentapost
