#include "lib/cl/read_text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace pentapost::cl {
namespace {

using Kind = path::CycleStart::Kind;

ReadResult read_cycle_in(std::string_view dialect, const std::string& cycle) {
  return read_as(dialect, "UNITS/MM\nSPINDL/RPM,1000,CLW\nRAPID\nGOTO/0,0,50\n" + cycle +
                              "\nGOTO/1,2,10\nGOTO/3,4,10\nCYCLE/OFF\nRAPID\nGOTO/0,0,50\n");
}

path::CycleStart only_cycle(const ReadResult& result) {
  const auto cycles = events_of<path::CycleStart>(result.path);
  EXPECT_EQ(cycles.size(), 1U);
  return cycles.empty() ? path::CycleStart{} : cycles[0];
}

TEST(ReadCycle, MakesEveryGotoUntilOffAHole) {
  const auto result = read_cycle_in("creo-ncl", "CYCLE / DRILL, DEPTH, 5, MMPM, 80, CLEAR, 2");
  using path::Move;
  EXPECT_EQ(result.path.move,
            (std::vector<Move>{Move::rapid, Move::hole, Move::hole, Move::rapid}));
  EXPECT_EQ(events_of<path::CycleEnd>(result.path).size(), 1U);
  EXPECT_EQ(result.points, 4U);
}

TEST(ReadCycle, ReadsCreosNamesOverContinuedLines) {
  const auto cycle = only_cycle(read_cycle_in(
      "creo-ncl",
      "CYCLE / DEEP, DEPTH, 3.500000, STEP, 1.000000, MMPM, 50.000000, CLEAR,$\n 1.000000"));
  EXPECT_EQ(cycle.kind, Kind::deep);
  EXPECT_EQ(cycle.depth_mm, 3.5);
  EXPECT_EQ(cycle.peck_mm, 1.0);
  EXPECT_EQ(cycle.feed_mm_min, 50.0);
  EXPECT_EQ(cycle.clearance_mm, 1.0);
  EXPECT_EQ(cycle.retract_mm, std::nullopt);
}

TEST(ReadCycle, ReadsNxNamesWithASignedDepth) {
  const auto result = read_cycle_in(
      "nx-clsf",
      "CYCLE/"
      "DRILL,BRKCHP,RAPTO,3.0,FEDTO,-33.0043,RTRCTO,20.0,MANUAL,STEP,4.0,DWELL,1.5,MMPM,250.0");
  const auto cycle = only_cycle(result);
  EXPECT_EQ(cycle.kind, Kind::break_chip);
  EXPECT_EQ(cycle.depth_mm, 33.0043);
  EXPECT_EQ(cycle.clearance_mm, 3.0);
  EXPECT_EQ(cycle.retract_mm, 20.0);
  EXPECT_EQ(cycle.peck_mm, 4.0);
  EXPECT_EQ(cycle.dwell_s, 1.5);
  EXPECT_EQ(cycle.feed_mm_min, 250.0);
  EXPECT_FALSE(has(result, Code::bad_cycle));
}

TEST(ReadCycle, ReadsClassicPositions) {
  for (const char* text : {"CYCLE/DRILL,4.,20.,MMPM,1.", "CYCLE/DRILL,4.,MMPM,20.,1."}) {
    const auto cycle = only_cycle(read_cycle_in("apt", text));
    EXPECT_EQ(cycle.depth_mm, 4.0) << text;
    EXPECT_EQ(cycle.feed_mm_min, 20.0) << text;
    EXPECT_EQ(cycle.clearance_mm, 1.0) << text;
  }
}

// ISO 4343 as Fusion writes it: the GOTO is the bottom, the clearance a height.
TEST(ReadCycle, TakesFusionsGotoAsTheBottomAndItsClearanceAsAHeight) {
  const auto result =
      read_cycle_in("fusion-apt", "CYCLE/DEEP, 8., INCR, 2., MMPM, 100., 30., RAPTO, 7.");
  const auto cycle = only_cycle(result);
  EXPECT_EQ(cycle.kind, Kind::deep);
  EXPECT_EQ(result.path.tip_wp_mm[1], Vec3(1, 2, 18));
  EXPECT_EQ(cycle.depth_mm, 8.0);
  EXPECT_EQ(*cycle.retract_mm, 12.0);
  EXPECT_EQ(cycle.clearance_mm, 5.0);
  EXPECT_EQ(cycle.peck_mm, 2.0);
  EXPECT_EQ(cycle.feed_mm_min, 100.0);
}

TEST(ReadCycle, RefusesAFusionClearanceBelowTheHole) {
  EXPECT_TRUE(
      read_cycle_in("fusion-apt", "CYCLE/DRILL, 8., MMPM, 100., 5.").diagnostics.has_errors());
}

TEST(ReadCycle, RefusesBoringFromBelow) {
  const auto result = read_cycle_in("apt", "CYCLE/BORE,BACK,DEPTH,4,CLEAR,2,MMPM,9");
  EXPECT_TRUE(has(result, Code::bad_cycle));
  EXPECT_TRUE(result.diagnostics.has_errors());
}

TEST(ReadCycle, WarnsOfAWayOutOfTheHoleThatItDoesNotTake) {
  for (const char* exit : {"NODRAG", "MANUAL"}) {
    const auto result =
        read_cycle_in("apt", "CYCLE/BORE," + std::string{exit} + ",DEPTH,4,CLEAR,2,MMPM,9");
    EXPECT_TRUE(has(result, Code::bad_cycle)) << exit;
    EXPECT_EQ(only_cycle(result).kind, Kind::bore) << exit;
  }
}

TEST(ReadCycle, KnowsTheKinds) {
  const std::pair<const char*, Kind> cases[] = {
      {"DRILL", Kind::drill}, {"FACE", Kind::face},
      {"CSINK", Kind::face},  {"BRKCHP", Kind::break_chip},
      {"TAP", Kind::tap},     {"TAP,LEFT", Kind::tap_left},
      {"BORE", Kind::bore},   {"BORE,DRAG", Kind::bore_drag},
      {"REAM", Kind::ream},   {"DRILL,DEEP", Kind::deep}};
  for (const auto& [words, kind] : cases) {
    const auto result =
        read_cycle_in("creo-ncl", "CYCLE/" + std::string{words} + ",DEPTH,4,STEP,1,CLEAR,2,MMPM,9");
    EXPECT_EQ(only_cycle(result).kind, kind) << words;
  }
}

TEST(ReadCycle, TakesTheFirstPeckWhereNoStepIsGiven) {
  EXPECT_EQ(only_cycle(read_cycle_in("creo-ncl", "CYCLE/DEEP,DEPTH,9,1STPECK,2.5,CLEAR,1")).peck_mm,
            2.5);
  EXPECT_EQ(only_cycle(read_cycle_in("creo-ncl", "CYCLE/DEEP,DEPTH,9,1STPECK,2.5,STEP,2,CLEAR,1"))
                .peck_mm,
            2.0);
}

TEST(ReadCycle, TurnsFeedAndDwellPerRevolutionIntoTime) {
  const auto cycle =
      only_cycle(read_cycle_in("creo-ncl", "CYCLE/TAP,DEPTH,9,MMPR,1.25,CLEAR,2,DWELL,REV,5"));
  EXPECT_EQ(cycle.pitch_mm, 1.25);
  EXPECT_EQ(cycle.feed_mm_min, 1250.0);
  EXPECT_DOUBLE_EQ(cycle.dwell_s, 0.3);
}

TEST(ReadCycle, NeedsASpindleSpeedForAFeedPerRevolution) {
  const auto result = read("UNITS/MM\nCYCLE/DRILL,DEPTH,9,MMPR,0.1,CLEAR,2\nGOTO/1,2,3\n");
  EXPECT_EQ(diagnostic_of(result, Code::feed_per_revolution).severity, Severity::error);
}

TEST(ReadCycle, TakesTheUnitInTheStatementForTheFeed) {
  EXPECT_DOUBLE_EQ(
      *only_cycle(read_cycle_in("creo-ncl", "CYCLE/DRILL,DEPTH,9,IPM,10,CLEAR,2")).feed_mm_min,
      254.0);
}

TEST(ReadCycle, RefusesWhatCannotBeDrilled) {
  for (const char* text :
       {"CYCLE/", "CYCLE/DRILL", "CYCLE/DRILL,DEPTH,0,CLEAR,1", "CYCLE/XYZZY,DEPTH,3",
        "CYCLE/DRILL,DEPTH,1.2.3", "CYCLE/DRILL,DEPTH,3,CLEAR,-5",
        "CYCLE/DEEP,DEPTH,1000,STEP,0.001,CLEAR,1"}) {
    const auto result = read_cycle_in("creo-ncl", text);
    EXPECT_TRUE(result.diagnostics.has_errors()) << text;
    EXPECT_EQ(result.diagnostics.list().front().cl_line, 5U) << text;
  }
}

TEST(ReadCycle, WarnsWhereThereIsNoClearance) {
  EXPECT_EQ(
      diagnostic_of(read_cycle_in("creo-ncl", "CYCLE/DRILL,DEPTH,3"), Code::bad_cycle).severity,
      Severity::warning);
}

TEST(ReadCycle, GoesOnWithTheCycleAtOn) {
  const auto result =
      read_as("creo-ncl",
              "UNITS/MM\nCYCLE/DRILL,DEPTH,3,CLEAR,1,MMPM,9\nGOTO/1,0,0\nCYCLE/OFF\n"
              "RAPID\nGOTO/2,0,9\nCYCLE/ON\nGOTO/3,0,0\n");
  EXPECT_EQ(events_of<path::CycleStart>(result.path).size(), 2U);
  EXPECT_EQ(events_of<path::CycleEnd>(result.path).size(), 2U);
  EXPECT_EQ(result.path.move.back(), path::Move::hole);
}

TEST(ReadCycle, DrillsAlongATiltedAxis) {
  const auto result = read_as(
      "creo-ncl", "UNITS/MM\nCYCLE/DRILL,DEPTH,3,CLEAR,1,MMPM,9\nGOTO/1,2,3,0,1,0\nCYCLE/OFF\n");
  EXPECT_EQ(result.path.axis_wp[0], Vec3(0, 1, 0));
}

}  // namespace
}  // namespace pentapost::cl
