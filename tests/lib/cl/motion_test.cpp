#include "lib/cl/read_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace pentapost::cl {
namespace {

using path::Move;

TEST(ReadMotion, ReadsPointsWithTheirLine) {
  const auto result = read("UNITS/MM\n\nGOTO / 1.0, 2.0, $\n 3.0\ngoto/4,5,6,0,1,0\n");
  ASSERT_EQ(result.path.size(), 2U);
  EXPECT_EQ(result.path.tip_wp_mm[0], Vec3(1, 2, 3));
  EXPECT_EQ(result.path.cl_line[0], 3U);
  EXPECT_EQ(result.path.axis_wp[0], Vec3(0, 0, 1));
  EXPECT_EQ(result.path.cl_line[1], 5U);
  EXPECT_EQ(result.path.axis_wp[1], Vec3(0, 1, 0));
  EXPECT_EQ(result.points, 2U);
  EXPECT_EQ(result.lines, 5U);
}

TEST(ReadMotion, KeepsTheToolAxisUntilTheNextToolPath) {
  const auto result = read(
      "TOOL PATH/A,TOOL,T\nGOTO/0,0,0,1,0,0\nGOTO/1,0,0 $$ 0,1,0\nEND-OF-PATH\n"
      "TOOL PATH/B,TOOL,T\nGOTO/2,0,0\n");
  EXPECT_EQ(result.path.axis_wp[1], Vec3(1, 0, 0));
  EXPECT_EQ(result.path.axis_wp[2], Vec3(0, 0, 1));
}

TEST(ReadMotion, TakesSixValuesWithOrWithoutMultax) {
  for (const std::string multax : {"", "MULTAX\n", "MULTAX/ON\n", "MULTAX / ON\n"}) {
    const auto result = read(multax + "GOTO/0,0,0,0,-1,0\n");
    EXPECT_EQ(result.path.axis_wp.at(0), Vec3(0, -1, 0)) << multax;
    EXPECT_FALSE(has(result, Code::unknown_statement));
  }
}

TEST(ReadMotion, SetsTheAxisUprightAtMultaxOff) {
  EXPECT_EQ(read("GOTO/0,0,0,1,0,0\nMULTAX/OFF\nGOTO/1,0,0\n").path.axis_wp[1], Vec3(0, 0, 1));
}

TEST(ReadMotion, RapidHoldsForTheNextMotionOnly) {
  const auto path = read("FEDRAT/5\nRAPID\nGOTO/0,0,0\nGOTO/1,0,0\nRAPID/\nGOTO/2,0,0\n").path;
  EXPECT_EQ(path.move, (std::vector<Move>{Move::rapid, Move::feed, Move::rapid}));
}

TEST(ReadMotion, NormalisesAxesOfSevenDigits) {
  const auto result = read("GOTO/0,0,0,0.7071068,0.0000000,0.7071068\n");
  EXPECT_NEAR(result.path.axis_wp[0].norm(), 1.0, 1e-15);
  EXPECT_FALSE(has(result, Code::axis_not_unit));
  EXPECT_EQ(result.path.axis_rounding_rad, 2e-7);
}

TEST(ReadMotion, WarnsOfAnAxisThatIsNotOfUnitLength) {
  EXPECT_TRUE(has(read("GOTO/0,0,0,0,0,1.002\n"), Code::axis_not_unit));
  EXPECT_FALSE(has(read("GOTO/0,0,0,0,0,1.0009\n"), Code::axis_not_unit));
  EXPECT_EQ(read("GOTO/0,0,0,0,0,7\n").path.axis_wp[0], Vec3(0, 0, 1));
}

TEST(ReadMotion, RefusesAnAxisWithoutDirection) {
  const auto result = read("UNITS/MM\nGOTO/0,0,0,0,0,0\n");
  EXPECT_EQ(diagnostic_of(result, Code::zero_tool_axis).cl_line, 2U);
  EXPECT_TRUE(result.diagnostics.has_errors());
}

TEST(ReadMotion, TakesAxesBelowTheHorizonAndThroughThePole) {
  const auto path = read("GOTO/0,0,0,0,0.6,-0.8\nGOTO/0,0,0,0,0,-1\nGOTO/0,0,0,0,0,1\n").path;
  EXPECT_NEAR(path.axis_wp[0].z(), -0.8, 1e-15);
  EXPECT_EQ(path.axis_wp[1], Vec3(0, 0, -1));
}

TEST(ReadMotion, AddsUpGodlta) {
  const auto path = read("GOTO/1,2,3,0,1,0\nGODLTA/10,0,-1\nGODLTA/5\n").path;
  EXPECT_EQ(path.tip_wp_mm[1], Vec3(11, 2, 2));
  EXPECT_EQ(path.tip_wp_mm[2], Vec3(11, 7, 2));
}

TEST(ReadMotion, StartsGodltaAtFrom) {
  const auto result = read("FROM  /  1,2,3\nGODLTA/1,1,1\n");
  EXPECT_EQ(result.path.tip_wp_mm.at(0), Vec3(2, 3, 4));
  EXPECT_EQ(result.points, 0U);
  EXPECT_EQ(events_of<path::StartPoint>(result.path).size(), 1U);
}

TEST(ReadMotion, DoesNotKnowWhereItIsAfterGohome) {
  const auto result = read("GOTO/1,2,3\nGOHOME\nGODLTA/1,1,1\n");
  EXPECT_EQ(diagnostic_of(result, Code::damaged_motion).cl_line, 3U);
}

// The printer's slip in a published nutating-table example: seven values.
TEST(ReadMotion, RefusesAGotoWithADecimalCommaAtItsFirstLine) {
  const auto result = read(
      "UNITS / MM\nFEDRAT / 5.000000. MMPM\nGOTO / 0.0000000000, 0.000000000, 90,2364093318, $\n"
      "-0.6417844358, 0.0000000000, 0.7668850879\nGOTO/1,2,3\n");
  const auto error = diagnostic_of(result, Code::damaged_motion);
  EXPECT_EQ(error.severity, Severity::error);
  EXPECT_EQ(error.cl_line, 3U);
  EXPECT_NE(error.message.find("GOTO / 0.0000000000"), std::string::npos) << error.message;
  EXPECT_NE(error.message.find("expected 3 or 6 numbers, found 7"), std::string::npos)
      << error.message;
  // The feed of its line 2 is damaged as well, and what it was is not guessed.
  EXPECT_EQ(diagnostic_of(result, Code::damaged_statement).severity, Severity::error);
  EXPECT_EQ(diagnostic_of(result, Code::damaged_statement).cl_line, 2U);
  EXPECT_EQ(result.diagnostics.total(Severity::error), 2U);
}

TEST(ReadMotion, CountsToTheNumberThatIsNotReadable) {
  const std::pair<const char*, const char*> cases[] = {{"GOTO/0,0,1.2.3", "number 3 is"},
                                                       {"GOTO/1O,2,3", "number 1 is"},
                                                       {"GOTO/1,X,3", "number 2 is"},
                                                       {"GOTO/1,,3", "number 2 is"},
                                                       {"GOTO/1,2,3,0,0,1-", "number 6 is"}};
  for (const auto& [text, place] : cases) {
    const auto error = diagnostic_of(read(text + std::string{"\n"}), Code::damaged_motion);
    EXPECT_NE(error.message.find(place), std::string::npos) << error.message;
  }
}

TEST(ReadMotion, RefusesDamagedMotions) {
  for (const char* text :
       {"GOTO/1,2", "GOTO/1,2,3,4", "GOTO/1,2,X", "GOTO/", "GOTO 1,2,3", "GODLTA/1,2",
        "GOFWD/L1,PAST,L2", "RETRCT", "PLUNGE/RAPID", "FROM/1", "CIRCLE/1,2,3", "N10 GOTO/1,2,3",
        "GOTO/1,2,3,4,5,6,7", "TLON,GOFWD/(CIRCLE/1,2,3,4)"}) {
    const auto result = read("GOTO/0,0,0\n" + std::string{text} + "\n");
    EXPECT_EQ(diagnostic_of(result, Code::damaged_motion).severity, Severity::error) << text;
    EXPECT_EQ(diagnostic_of(result, Code::damaged_motion).cl_line, 2U) << text;
  }
}

TEST(ReadMotion, TakesNoModeOfRetractsForAMotion) {
  const auto result = read("UNITS/MM\nRETRCT/OFF\nGOTO/0,0,0\n");
  EXPECT_FALSE(result.diagnostics.has_errors());
  EXPECT_EQ(diagnostic_of(result, Code::ignored_statement).cl_line, 2U);
}

TEST(ReadMotion, RefusesNumbersThatAreNotFinite) {
  for (const char* text : {"GOTO/nan,0,0", "GOTO/1E999,0,0", "GOTO/0,0,0,inf,0,0", "GOTO/1E10,0,0",
                           "GOTO/1E308,1E308,1E308", "FROM/0,0,-INF"}) {
    const auto result = read("UNITS/INCHES\n" + std::string{text} + "\n");
    EXPECT_EQ(diagnostic_of(result, Code::bad_number).severity, Severity::error) << text;
  }
}

TEST(ReadMotion, SaysWhereThereIsNone) {
  for (const char* text : {"", "PARTNO/X\nUNITS/MM\nFINI\n", "hello\nworld\n", "$$ GOTO/1,2,3\n"})
    EXPECT_TRUE(has(read(text), Code::no_motion)) << text;
}

TEST(ReadMotion, WarnsOnceOfCutsWithoutAFeed) {
  const auto result = read("UNITS/MM\nRAPID\nGOTO/0,0,0\nGOTO/1,0,0\nGOTO/2,0,0\n");
  EXPECT_EQ(diagnostic_of(result, Code::no_feed).cl_line, 4U);
  EXPECT_EQ(result.diagnostics.total(), 1U);
}

TEST(ReadMotion, RefusesIncrementalCoordinates) {
  EXPECT_TRUE(read("SET/MODE,INCR\nGOTO/1,2,3\n").diagnostics.has_errors());
  EXPECT_FALSE(read("SET/MODE,ABSOL\nGOTO/1,2,3\n").diagnostics.has_errors());
}

TEST(ReadMotion, TakesTlaxisAsModal) {
  EXPECT_EQ(read("TLAXIS/0,1,0\nGOTO/1,2,3\n").path.axis_wp[0], Vec3(0, 1, 0));
}

}  // namespace
}  // namespace pentapost::cl
