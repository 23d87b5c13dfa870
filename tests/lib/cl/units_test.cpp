#include "lib/cl/read_text.hpp"

#include <gtest/gtest.h>

namespace pentapost::cl {
namespace {

TEST(ReadUnits, TakesTheUnitStatementEvenBehindTheFirstPoint) {
  const auto result = read("GOTO/1,2,3\nUNITS / INCHES\nFEDRAT/1,IPM\n");
  EXPECT_EQ(result.units, Units::inch);
  EXPECT_DOUBLE_EQ(result.path.tip_wp_mm[0].x(), 25.4);
}

TEST(ReadUnits, TakesTheFeedUnitWhereNoStatementSays) {
  EXPECT_EQ(read("GOTO/1,2,3\nFEDRAT/IPM,10.\nGOTO/1,2,4\n").units, Units::inch);
  EXPECT_EQ(read("GOTO/1,2,3\nFEDRAT/10.,IPR\n").units, Units::inch);
  EXPECT_EQ(read("GOTO/1,2,3\nFEDRAT/MMPR,0.1\n").units, Units::mm);
  EXPECT_EQ(read("CYCLE/DRILL,DEPTH,1,IPM,5,CLEAR,0.1\nGOTO/1,2,3\n").units, Units::inch);
}

TEST(ReadUnits, AssumesMmWithAWarning) {
  const auto result = read("GOTO/1,2,3\n");
  EXPECT_EQ(result.units, Units::mm);
  EXPECT_TRUE(has(result, Code::unit_assumed));
  EXPECT_FALSE(result.diagnostics.has_errors());
}

TEST(ReadUnits, IgnoresUnitsInCommentsAndTexts) {
  EXPECT_EQ(read("$$ UNITS/INCHES\nPARTNO UNITS/INCHES\nUNITS/MM\nGOTO/1,2,3\n").units, Units::mm);
}

TEST(ReadUnits, WarnsOfAContradictionNamingBothLines) {
  const auto result = read("UNITS / INCHES\nRAPID\nGOTO/1,2,3\nFEDRAT / 100.0, MMPM\nGOTO/1,2,4\n");
  const auto warning = diagnostic_of(result, Code::unit_conflict);
  EXPECT_EQ(warning.cl_line, 4U);
  EXPECT_NE(warning.message.find("CL line 1"), std::string::npos) << warning.message;
  EXPECT_DOUBLE_EQ(result.path.tip_wp_mm[0].x(), 25.4);
  EXPECT_EQ(events_of<path::FeedRate>(result.path)[0].value, 100.0);
}

TEST(ReadUnits, LetsTheRequestOverruleTheFile) {
  const auto result = read("UNITS/MM\nGOTO/1,2,3\n", {.units = Units::inch});
  EXPECT_DOUBLE_EQ(result.path.tip_wp_mm[0].z(), 76.2);
  EXPECT_FALSE(has(result, Code::unit_conflict));
}

TEST(ReadUnits, FollowsASecondStatementFromThereOnWithAWarning) {
  const auto result = read("UNITS/MM\nGOTO/1,0,0\nUNITS/INCHES\nGOTO/1,0,0\n");
  EXPECT_EQ(result.path.tip_wp_mm[0].x(), 1.0);
  EXPECT_DOUBLE_EQ(result.path.tip_wp_mm[1].x(), 25.4);
  EXPECT_TRUE(has(result, Code::unit_conflict));
}

TEST(ReadUnits, RefusesAUnitThatIsNotKnown) {
  EXPECT_EQ(diagnostic_of(read("UNITS/FEET\nGOTO/1,2,3\n"), Code::bad_unit).severity,
            Severity::error);
}

TEST(ReadUnits, ConvertsFeedsToolsAndCycles) {
  const auto result = read(
      "UNITS/INCHES\nCUTTER/0.5,0.125\nFEDRAT/10,IPM\nGOTO/0,0,1\n"
      "CYCLE/DRILL,DEPTH,0.5,CLEAR,0.1,IPM,4\nGOTO/1,0,0\nCYCLE/OFF\n");
  EXPECT_DOUBLE_EQ(events_of<path::FeedRate>(result.path)[0].value, 254.0);
  EXPECT_DOUBLE_EQ(*events_of<path::ToolData>(result.path)[0].diameter_mm, 12.7);
  EXPECT_DOUBLE_EQ(*events_of<path::ToolData>(result.path)[0].corner_radius_mm, 3.175);
  const auto cycle = events_of<path::CycleStart>(result.path)[0];
  EXPECT_DOUBLE_EQ(cycle.depth_mm, 12.7);
  EXPECT_DOUBLE_EQ(cycle.clearance_mm, 2.54);
  EXPECT_DOUBLE_EQ(*cycle.feed_mm_min, 101.6);
}

}  // namespace
}  // namespace pentapost::cl
