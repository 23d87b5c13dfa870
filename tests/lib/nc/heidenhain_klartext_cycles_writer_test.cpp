#include "lib/nc/writer_case.hpp"

#include <gtest/gtest.h>

#include <string>

namespace pentapost {
namespace {

using sample::MotionCase;
using sample::klartext::body;
using sample::klartext::options_with;
using Kind = path::CycleStart::Kind;
using State = path::Spindle::State;

/// 10 mm deep from Z0, feed from Z2.
path::NativeCycle cycle(Kind kind) {
  path::NativeCycle native;
  native.kind = kind;
  native.clearance_z = 2'000;
  native.clearance = 2'000;
  native.bottom_z = -10'000;
  native.feed_mm_min = 120.0;
  return native;
}

MotionCase above() {
  MotionCase start{"XYZAC", Output::axes};
  start.act(path::ToolCall{.number = 1, .speed_rpm = 600.0})
      .act(path::Spindle{State::clockwise, 600.0})
      .rapid({0, 0, 50, 0, 0});
  return start;
}

/// What stands behind the first rapid.
std::string holes(const path::NativeCycle& native,
                  const machine::Options& options = {{"comments", false},
                                                     {"block_numbers", false}}) {
  const auto motion = above()
                          .act(native)
                          .hole({1, 2, -10, 0, 0})
                          .hole({1, 5, -10, 0, 0})
                          .act(path::NativeCycleEnd{})
                          .rapid({0, 0, 50, 0, 0})
                          .motion;
  const std::string nc = body(motion, options);
  const std::string first = "Z+50 A+0 C+0 R0 FMAX\n";
  return nc.substr(nc.find(first) + first.size());
}

constexpr const char* two_holes =
    "L X+1 Y+2 R0 FMAX M99\n"
    "L X+1 Y+5 R0 FMAX M99\n";
constexpr const char* away = "L X+0 Y+0 Z+50 R0 FMAX\n";

TEST(HeidenhainKlartextCycles, DrillsWithCycle200InOneMovement) {
  EXPECT_EQ(holes(cycle(Kind::drill)), std::string{"CYCL DEF 200 DRILLING ~\n"
                                                   "    Q200=+2 ;SET-UP CLEARANCE ~\n"
                                                   "    Q201=-10 ;DEPTH ~\n"
                                                   "    Q206=+120 ;FEED RATE FOR PLNGNG ~\n"
                                                   "    Q202=+10 ;PLUNGING DEPTH ~\n"
                                                   "    Q210=+0 ;DWELL TIME AT TOP ~\n"
                                                   "    Q203=+0 ;SURFACE COORDINATE ~\n"
                                                   "    Q204=+2 ;2ND SET-UP CLEARANCE ~\n"
                                                   "    Q211=+0 ;DWELL TIME AT DEPTH\n"} +
                                           two_holes + away);
}

TEST(HeidenhainKlartextCycles, DwellsAtTheBottom) {
  auto native = cycle(Kind::face);
  native.dwell_s = 0.25;

  EXPECT_NE(holes(native).find("    Q211=+0.25 ;DWELL TIME AT DEPTH\n"), std::string::npos);
}

TEST(HeidenhainKlartextCycles, WritesTheDepthReferenceOnRequest) {
  EXPECT_NE(holes(cycle(Kind::drill), options_with("cycle_depth_reference", true))
                .find("Q211=+0 ;DWELL TIME AT DEPTH ~\n    Q395=+0 ;DEPTH REFERENCE\nL X+1"),
            std::string::npos);
}

TEST(HeidenhainKlartextCycles, PecksWithCycle205) {
  auto native = cycle(Kind::deep);
  native.peck = 3'000;

  EXPECT_EQ(holes(native, options_with("advanced_stop_mm", 0.5)),
            std::string{"CYCL DEF 205 UNIVERSAL PECKING ~\n"
                        "    Q200=+2 ;SET-UP CLEARANCE ~\n"
                        "    Q201=-10 ;DEPTH ~\n"
                        "    Q206=+120 ;FEED RATE FOR PLNGNG ~\n"
                        "    Q202=+3 ;PLUNGING DEPTH ~\n"
                        "    Q203=+0 ;SURFACE COORDINATE ~\n"
                        "    Q204=+2 ;2ND SET-UP CLEARANCE ~\n"
                        "    Q212=+0 ;DECREMENT ~\n"
                        "    Q205=+0 ;MIN. PLUNGING DEPTH ~\n"
                        "    Q258=+0.5 ;UPPER ADV STOP DIST ~\n"
                        "    Q259=+0.5 ;LOWER ADV STOP DIST ~\n"
                        "    Q257=+0 ;DEPTH FOR CHIP BRKNG ~\n"
                        "    Q256=+0.2 ;DIST FOR CHIP BRKNG ~\n"
                        "    Q211=+0 ;DWELL TIME AT DEPTH ~\n"
                        "    Q379=+0 ;STARTING POINT ~\n"
                        "    Q253=+750 ;F PRE-POSITIONING\n"} +
                two_holes + away);
}

TEST(HeidenhainKlartextCycles, BreaksChipsWithCycle203WithoutLeavingTheHole) {
  auto native = cycle(Kind::break_chip);
  native.peck = 3'000;

  EXPECT_EQ(holes(native, {{"comments", false},
                           {"block_numbers", false},
                           {"chip_break_mm", 0.3},
                           {"retraction_feed_mm_min", 5'000.0}}),
            std::string{"CYCL DEF 203 UNIVERSAL DRILLING ~\n"
                        "    Q200=+2 ;SET-UP CLEARANCE ~\n"
                        "    Q201=-10 ;DEPTH ~\n"
                        "    Q206=+120 ;FEED RATE FOR PLNGNG ~\n"
                        "    Q202=+3 ;PLUNGING DEPTH ~\n"
                        "    Q210=+0 ;DWELL TIME AT TOP ~\n"
                        "    Q203=+0 ;SURFACE COORDINATE ~\n"
                        "    Q204=+2 ;2ND SET-UP CLEARANCE ~\n"
                        "    Q212=+0 ;DECREMENT ~\n"
                        "    Q213=+4 ;NR OF BREAKS ~\n"
                        "    Q205=+0 ;MIN. PLUNGING DEPTH ~\n"
                        "    Q211=+0 ;DWELL TIME AT DEPTH ~\n"
                        "    Q208=+5000 ;RETRACTION FEED RATE ~\n"
                        "    Q256=+0.3 ;DIST FOR CHIP BRKNG\n"} +
                two_holes + away);
}

TEST(HeidenhainKlartextCycles, DrillsWithoutAPeck) {
  for (const Kind kind : {Kind::deep, Kind::break_chip})
    EXPECT_EQ(holes(cycle(kind)), holes(cycle(Kind::drill)));
}

TEST(HeidenhainKlartextCycles, ReamsAndBoresOutAtTheFeedOfTheWayIn) {
  for (const Kind kind : {Kind::ream, Kind::bore})
    EXPECT_EQ(holes(cycle(kind)), std::string{"CYCL DEF 201 REAMING ~\n"
                                              "    Q200=+2 ;SET-UP CLEARANCE ~\n"
                                              "    Q201=-10 ;DEPTH ~\n"
                                              "    Q206=+120 ;FEED RATE FOR PLNGNG ~\n"
                                              "    Q211=+0 ;DWELL TIME AT DEPTH ~\n"
                                              "    Q208=+120 ;RETRACTION FEED RATE ~\n"
                                              "    Q203=+0 ;SURFACE COORDINATE ~\n"
                                              "    Q204=+2 ;2ND SET-UP CLEARANCE\n"} +
                                      two_holes + away);
}

TEST(HeidenhainKlartextCycles, BoresWithCycle202WithoutLeavingTheWall) {
  EXPECT_EQ(holes(cycle(Kind::bore_drag)), std::string{"CYCL DEF 202 BORING ~\n"
                                                       "    Q200=+2 ;SET-UP CLEARANCE ~\n"
                                                       "    Q201=-10 ;DEPTH ~\n"
                                                       "    Q206=+120 ;FEED RATE FOR PLNGNG ~\n"
                                                       "    Q211=+0 ;DWELL TIME AT DEPTH ~\n"
                                                       "    Q208=+120 ;RETRACTION FEED RATE ~\n"
                                                       "    Q203=+0 ;SURFACE COORDINATE ~\n"
                                                       "    Q204=+2 ;2ND SET-UP CLEARANCE ~\n"
                                                       "    Q214=+0 ;DISENGAGING DIRECTN ~\n"
                                                       "    Q336=+0 ;ANGLE OF SPINDLE\n"} +
                                               two_holes + away);
}

TEST(HeidenhainKlartextCycles, TapsByPitchAndStartsTheSpindleAgain) {
  auto native = cycle(Kind::tap);
  native.feed_mm_min = 750.0;

  EXPECT_EQ(holes(native), std::string{"CYCL DEF 207 RIGID TAPPING NEW ~\n"
                                       "    Q200=+2 ;SET-UP CLEARANCE ~\n"
                                       "    Q201=-10 ;DEPTH OF THREAD ~\n"
                                       "    Q239=+1.25 ;THREAD PITCH ~\n"
                                       "    Q203=+0 ;SURFACE COORDINATE ~\n"
                                       "    Q204=+2 ;2ND SET-UP CLEARANCE\n"} +
                               two_holes + "M3\n" + away);
}

TEST(HeidenhainKlartextCycles, TapsLeftHandedByTheSignOfThePitch) {
  auto native = cycle(Kind::tap_left);
  native.feed_mm_min = 600.0 * 25.4 / 28.0;

  EXPECT_NE(holes(native).find("Q239=-0.9071 ;THREAD PITCH"), std::string::npos);
}

TEST(HeidenhainKlartextCycles, RefusesATapWithoutASpeedOrOfTooLargeAPitch) {
  const auto silent =
      MotionCase{}.rapid({0, 0, 50, 0, 0}).act(cycle(Kind::tap)).hole({1, 2, -10, 0, 0}).motion;
  EXPECT_EQ(sample::refused("heidenhain", silent).code, Code::out_of_domain);
  auto coarse = cycle(Kind::tap);
  coarse.feed_mm_min = 600.0 * 100.0;
  const auto motion = above().act(coarse).hole({1, 2, -10, 0, 0}).motion;
  EXPECT_EQ(sample::refused("heidenhain", motion).code, Code::out_of_domain);
}

TEST(HeidenhainKlartextCycles, TakesTheClearanceForTheSurfaceWhereNoneIsSaid) {
  auto native = cycle(Kind::drill);
  native.clearance = 0;

  const std::string nc = holes(native);

  EXPECT_NE(nc.find("Q200=+0 "), std::string::npos);
  EXPECT_NE(nc.find("Q201=-12 "), std::string::npos);
  EXPECT_NE(nc.find("Q203=+2 "), std::string::npos);
}

TEST(HeidenhainKlartextCycles, DefinesTheCycleAgainForAnotherDepth) {
  const auto motion =
      above().act(cycle(Kind::drill)).hole({1, 2, -10, 0, 0}).hole({1, 5, -11, 0, 0}).motion;

  const std::string nc = body(motion);

  EXPECT_NE(nc.find("Q201=-10 "), std::string::npos);
  EXPECT_NE(nc.find("Q201=-11 "), std::string::npos);
}

TEST(HeidenhainKlartextCycles, RefusesADepthOfZero) {
  auto native = cycle(Kind::drill);
  native.clearance_z = -8'000;

  const auto motion = above().act(native).hole({1, 2, -10, 0, 0}).motion;

  EXPECT_EQ(sample::refused("heidenhain", motion).code, Code::out_of_domain);
}

TEST(HeidenhainKlartextCycles, RefusesNumbersThatTheCycleDoesNotTake) {
  auto native = cycle(Kind::face);
  native.dwell_s = 3'601.0;
  EXPECT_EQ(
      sample::refused("heidenhain", above().act(native).hole({1, 2, -10, 0, 0}).motion)
          .code,
      Code::out_of_domain);
  native = cycle(Kind::drill);
  native.feed_mm_min = 1e12;
  EXPECT_EQ(
      sample::refused("heidenhain", above().act(native).hole({1, 2, -10, 0, 0}).motion)
          .code,
      Code::out_of_domain);
}

TEST(HeidenhainKlartextCycles, NumbersADefinitionAsOneBlock) {
  const auto motion = above().act(cycle(Kind::ream)).hole({1, 2, -10, 0, 0}).motion;

  const std::string nc = sample::program("heidenhain", motion, {{"comments", false}});

  EXPECT_NE(nc.find("\n4 CYCL DEF 201 REAMING ~\n    Q200="), std::string::npos) << nc;
  EXPECT_NE(nc.find("\n5 L X+1 Y+2 R0 FMAX M99\n6 END PGM"), std::string::npos) << nc;
}

TEST(HeidenhainKlartextCycles, TakesAHoleWithoutACycleForADefect) {
  EXPECT_THROW(sample::program("heidenhain", above().hole({1, 2, -10, 0, 0}).motion),
               std::logic_error);
}

}  // namespace
}  // namespace pentapost
