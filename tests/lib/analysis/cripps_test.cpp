#include "pentapost/analysis/cl_analysis.hpp"

#include "lib/analysis/closest.hpp"
#include "machines/bundled.hpp"
#include "pentapost/cl/reader.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace pentapost::analysis {
namespace {

path::ToolPath paper_path(const std::string& name) {
  std::ifstream in{std::filesystem::path{PENTAPOST_TESTS_DIR} / "data/papers" / name};
  std::ostringstream text;
  text << in.rdbuf();
  auto read = cl::read(text.str());
  EXPECT_FALSE(read.diagnostics.has_errors());
  return std::move(read.path);
}

using sample::closest;

PathAnalysis analysed(const std::string& cl_file) {
  const machine::Definition machine = sample::bundled_machine("hermle-c600u");
  const kinematics::Model model{machine.chain};
  plan::Settings settings;
  settings.limits = machine.limits;
  settings.preferences = machine.preferences;
  settings.axis_tolerance_rad = 0.1 * rad_per_deg;
  const auto analysis = analyse_path(model, plan::joint_ranges(machine.chain, model),
                                     paper_path(cl_file), settings, {});
  EXPECT_TRUE(analysis) << analysis.error().message;
  return *analysis;
}

constexpr double rpm = 2.0 * pi / 60.0;

/// The tip runs along X, 1 mm a GOTO: on that polyline the path passes the pole at 1.000 deg.
TEST(CrippsOriginal, PassesThePoleAtOneDegreeWithCAtTwoHundredRevolutions) {
  const PathAnalysis analysis = analysed("cripps-2017-original.cl");
  ASSERT_TRUE(closest(analysis));
  EXPECT_EQ(closest(analysis)->kind, kinematics::SingularityKind::pole);
  EXPECT_NEAR(closest(analysis)->distance_rad * deg_per_rad, 1.000, 0.0005);
  EXPECT_NEAR(closest(analysis)->at.tip_wp_mm.x(), 25.0, 1e-6);
  const AxisPeak& c = analysis.peaks[first_axis];
  EXPECT_NEAR(c.speed / rpm, 198.9, 0.1);
  EXPECT_NEAR(c.at.tip_wp_mm.x(), 25.0, 1e-3);
}

TEST(CrippsOriginal, HasOneZoneWhereCIsOverItsLimit) {
  const PathAnalysis analysis = analysed("cripps-2017-original.cl");
  ASSERT_EQ(analysis.zones.size(), 1U);
  const Zone& zone = analysis.zones.front();
  EXPECT_EQ(zone.axis, first_axis);
  EXPECT_NEAR(zone.from.tip_wp_mm.x(), 21.61, 0.05);
  EXPECT_NEAR(zone.to.tip_wp_mm.x(), 28.39, 0.05);
  EXPECT_NEAR(zone.peak_speed / rpm, 198.9, 0.1);
  EXPECT_NEAR(zone.peak_ratio, 198.9 / 25.0, 0.01);
  EXPECT_NEAR(zone.lowest_feed_mm_min, 2000.0 * 25.0 / 198.9, 0.5);
  EXPECT_TRUE(analysis.over_demands.empty());
  EXPECT_GT(analysis.predicted_time_s, analysis.programmed_time_s);
}

TEST(CrippsReoriented, KeepsElevenDegreesAndHasNoZone) {
  const PathAnalysis analysis = analysed("cripps-2017-reoriented.cl");
  ASSERT_TRUE(closest(analysis));
  EXPECT_NEAR(closest(analysis)->distance_rad * deg_per_rad, 11.000, 0.0005);
  EXPECT_NEAR(analysis.peaks[first_axis].speed / rpm, 18.2, 0.1);
  EXPECT_TRUE(analysis.zones.empty());
  EXPECT_TRUE(analysis.over_demands.empty());
  EXPECT_NEAR(analysis.predicted_time_s, analysis.programmed_time_s, 1e-9);
}

/// Both files begin in the pole's posture and turn in place: no part of the cut.
TEST(CrippsOriginal, ListsItsTurnInPlaceAsRepositioning) {
  const PathAnalysis analysis = analysed("cripps-2017-original.cl");
  int turns = 0;
  for (const Repositioning& each : analysis.repositionings)
    if (each.kind == Repositioning::Kind::turn_in_place) {
      ++turns;
      ASSERT_TRUE(each.time_s);
      EXPECT_GT(*each.time_s, 0.0);
    }
  EXPECT_GE(turns, 1);
}

}  // namespace
}  // namespace pentapost::analysis
