#include "lib/nc/fanuc_reader_case.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace {

using namespace pentapost;
using sample::expect_refused;
using sample::last_motion;
using sample::motions_of;
using sample::read_after_start;
using Kind = nc::ReadMotion::Kind;
using Feed = nc::ReadMotion::Feed;

TEST(Fanuc30iReader, KeepsThePositionOfAxesThatABlockLeavesOut) {
  const auto motions = motions_of("G1 X10. Y20. C30.\nZ-5.");
  ASSERT_EQ(motions.size(), 2u);
  EXPECT_EQ(motions[1].position, (std::array{10.0, 20.0, -5.0, 0.0, 30.0}));
  EXPECT_EQ(motions[1].stated, 0b00100);
  EXPECT_EQ(motions[1].known, 0b11111);
}

TEST(Fanuc30iReader, TellsKindFeedAndLine) {
  const auto read = read_after_start("G1 X10. F350.\nG0 X20.");
  const auto motions = read.motions();
  ASSERT_EQ(motions.size(), 4u);
  EXPECT_EQ(motions[2].kind, Kind::line);
  EXPECT_EQ(motions[2].feed_mode, Feed::per_minute);
  EXPECT_EQ(motions[2].feed, 350.0);
  EXPECT_EQ(motions[3].kind, Kind::rapid);
  EXPECT_EQ(motions[3].feed_mode, Feed::none);
  EXPECT_EQ(read.items[read.items.size() - 2].text_line, 9u);
}

TEST(Fanuc30iReader, MotionIsModal) {
  const auto motions = motions_of("G01 X1.\nX2.\nG00 X3.\nX4.");
  ASSERT_EQ(motions.size(), 4u);
  EXPECT_EQ(motions[1].kind, Kind::line);
  EXPECT_EQ(motions[3].kind, Kind::rapid);
}

// Operator's manual, decimal point programming: without a point a number counts in 0.001 mm or deg.
TEST(Fanuc30iReader, CountsThousandthsWithoutADecimalPoint) {
  const auto motion = last_motion("G1 X1000 Y-50 Z7. A90000 C1");
  EXPECT_EQ(motion.position, (std::array{1.0, -0.05, 7.0, 90.0, 0.001}));
}

TEST(Fanuc30iReader, ReadsNumbersAsTheNearestDouble) {
  const auto motion = last_motion("G1 X118.204 Y-.5 Z+3. A00.1 C-0.0001");
  EXPECT_EQ(motion.position, (std::array{118.204, -0.5, 3.0, 0.1, -0.0001}));
}

TEST(Fanuc30iReader, NeverGivesMinusZero) {
  const auto motion = last_motion("G1 X-0. Y-0.000");
  EXPECT_FALSE(std::signbit(motion.position[0]));
  EXPECT_FALSE(std::signbit(motion.position[1]));
}

TEST(Fanuc30iReader, AddsInG91) {
  const auto motions = motions_of("G91 G1 X10. C5.\nX10. Z-1.\nG90 X7.");
  ASSERT_EQ(motions.size(), 3u);
  EXPECT_EQ(motions[1].position, (std::array{20.0, 0.0, 99.0, 0.0, 5.0}));
  EXPECT_EQ(motions[2].position[0], 7.0);
}

TEST(Fanuc30iReader, RefusesG91FromAnUnknownPosition) {
  expect_refused("G91 G28 Z0.\nG1 Z5.", "Z in G91");
}

TEST(Fanuc30iReader, InchModeScalesLengthsAndNotDegrees) {
  const auto read = sample::read_items(
      "fanuc-30i", "G90 G94 G17 G20\nG1 X1. Y10000 Z-.5 A90. C90000 F10.\nM30\n");
  ASSERT_EQ(read.message(), "");
  const auto motion = read.motions().at(0);
  EXPECT_EQ(motion.position, (std::array{25.4, 25.4, -12.7, 90.0, 90.0}));
  EXPECT_EQ(motion.feed, 254.0);
}

TEST(Fanuc30iReader, AFeedOfRotaryAxesAloneIsDegreesInInchModeToo) {
  const auto read = sample::read_items("fanuc-30i", "G90 G94 G20 G1\nC90. F100.\nM30\n");
  ASSERT_EQ(read.message(), "");
  EXPECT_EQ(read.motions().at(0).feed, 100.0);
}

// Operator's manual B-62764EN, 5. Feed functions, G93: every block needs F; F1 is 0.001/min and
// F1.0 is 1/min; in an arc F is the feed over the radius, so the reader takes none.
TEST(Fanuc30iReader, InverseTimeFeedHoldsForItsBlockOnly) {
  const auto motion = last_motion("G93 G1 X1. C1. F12.5");
  EXPECT_EQ(motion.feed_mode, Feed::inverse_time);
  EXPECT_EQ(motion.feed, 12.5);
  expect_refused("G93 G1 X1. F12.5\nX2.", "F", Code::no_feed);
}

TEST(Fanuc30iReader, InverseTimeFeedWithoutAPointCountsThousandths) {
  EXPECT_EQ(last_motion("G93 G1 X1. F12500").feed, 12.5);
}

TEST(Fanuc30iReader, RapidsInG93NeedNoFeed) {
  EXPECT_EQ(last_motion("G93 G0 X1.").kind, Kind::rapid);
}

TEST(Fanuc30iReader, TheFeedOfG93IsNoFeedInG94) {
  expect_refused("G93 G1 X1. F12.5\nG94 X2.", "feed", Code::no_feed);
}

TEST(Fanuc30iReader, AFeedPerRevolutionIsTurnedIntoAFeedPerMinute) {
  EXPECT_EQ(last_motion("S1000 M3\nG95 G1 X1. F0.25").feed, 250.0);
  expect_refused("G95 G1 X1. F0.25", "spindle stands", Code::no_feed);
}

TEST(Fanuc30iReader, RefusesACutWithoutFeed) {
  const auto read = sample::read_items("fanuc-30i", "G90 G94 G21\nG1 X1.\nM30\n");
  ASSERT_FALSE(read.status.has_value());
  EXPECT_EQ(read.status.error().code, Code::no_feed);
  EXPECT_EQ(read.message(), "NC text line 2: a cutting motion has no feed");
}

TEST(Fanuc30iReader, RefusesWhatRestsOnParametersAtPowerOn) {
  for (const std::string_view text :
       {"G94 G21 G0 X1.\nM30\n", "G90 G94 G0 X1.\nM30\n", "G90 G21 G94\nX1.\nM30\n",
        "G90 G94 G21 G0 X0. Y0.\nG2 X1. Y1. R1. F9.\nM30\n"}) {
    SCOPED_TRACE(text);
    EXPECT_FALSE(sample::read_items("fanuc-30i", text).status.has_value());
  }
}

// Operator's manual, circular interpolation: I, J, K are incremental from the start point whatever
// G90 and G91 say.
TEST(Fanuc30iReader, ArcCentresCountFromTheStart) {
  const auto motion = last_motion("G1 X10. Y0. Z0.\nG3 X0. Y10. I-10. J0.");
  EXPECT_EQ(motion.kind, Kind::arc);
  EXPECT_FALSE(motion.clockwise);
  EXPECT_EQ(motion.centre_x_mm, 0.0);
  EXPECT_EQ(motion.centre_y_mm, 0.0);
  EXPECT_EQ(motion.whole_turns, 0);
}

TEST(Fanuc30iReader, ArcCentresCountFromTheStartInG91Too) {
  const auto motion = last_motion("G1 X10. Y5.\nG91 G2 X10. Y-10. J-10.");
  EXPECT_EQ(motion.position[0], 20.0);
  EXPECT_EQ(motion.position[1], -5.0);
  EXPECT_EQ(motion.centre_x_mm, 10.0);
  EXPECT_EQ(motion.centre_y_mm, -5.0);
  EXPECT_TRUE(motion.clockwise);
}

TEST(Fanuc30iReader, AnArcThatEndsWhereItStartsIsAFullCircle) {
  const auto motions = motions_of("G1 X10. Y0.\nG2 I-10.\nG2 X10. Y0. Z-1. I-10. J0.");
  ASSERT_EQ(motions.size(), 3u);
  EXPECT_EQ(motions[1].whole_turns, 1);
  EXPECT_EQ(motions[1].position[2], 100.0);
  EXPECT_EQ(motions[2].whole_turns, 1);
  EXPECT_EQ(motions[2].position[2], -1.0);
}

// The circle about (3, 4) with radius 5 holds (0, 0) and (6, 8); a sum in G91 that misses the start
// by rounding is still a full circle.
TEST(Fanuc30iReader, SumsOfG91DoNotTurnAFullCircleIntoNone) {
  const auto motions = motions_of("G91 G1 X0.1\nX0.2\nX-0.3\nG90 G2 X0. Y0. I3. J4.");
  EXPECT_EQ(motions.back().whole_turns, 1);
}

TEST(Fanuc30iReader, ARadiusGivesTheShortArcAndANegativeOneTheLong) {
  const auto shorter = last_motion("G1 X10. Y0.\nG3 X0. Y10. R10.");
  EXPECT_NEAR(shorter.centre_x_mm, 0.0, 1e-12);
  EXPECT_NEAR(shorter.centre_y_mm, 0.0, 1e-12);
  const auto longer = last_motion("G1 X10. Y0.\nG3 X0. Y10. R-10.");
  EXPECT_NEAR(longer.centre_x_mm, 10.0, 1e-12);
  EXPECT_NEAR(longer.centre_y_mm, 10.0, 1e-12);
  const auto clockwise = last_motion("G1 X10. Y0.\nG2 X0. Y10. R10.");
  EXPECT_NEAR(clockwise.centre_x_mm, 10.0, 1e-12);
  EXPECT_NEAR(clockwise.centre_y_mm, 10.0, 1e-12);
}

TEST(Fanuc30iReader, RefusesArcsThatCannotBe) {
  expect_refused("G2 X10. Y0. R4.", "radius", Code::bad_arc);
  expect_refused("G2 X0. Y0. R4.", "radius", Code::bad_arc);
  expect_refused("G2 X10. Y0. I5.02", "differ", Code::bad_arc);
  expect_refused("G2 X10. Y0.", "without a centre", Code::bad_arc);
  expect_refused("G2 X10. Y0. I5. R5.", "both", Code::bad_arc);
  expect_refused("G91 G28 X0.\nG90 G2 X10. Y0. I5.", "not known", Code::bad_arc);
  expect_refused("G18 G2 X10. Z100. I5.", "G17");
  expect_refused("G93 G2 X10. I5. F1.", "G93");
  expect_refused("G2 X10. Y0. I5. C1.", "C moves");
  expect_refused("G2 X10. Y0. I5. K1.", "K1");
}

TEST(Fanuc30iReader, AnArcMayRepeatTheRotaryWordsItDoesNotMove) {
  EXPECT_EQ(last_motion("G2 X10. Y0. I5. A0. C0.").kind, Kind::arc);
}

TEST(Fanuc30iReader, ToolCentrePointControlForgetsTheLinearAxes) {
  const auto motions = motions_of("G43.4 H5 X1. Z50.\nG1 Y2.\nG49\nG0 C5.");
  ASSERT_EQ(motions.size(), 3u);
  EXPECT_TRUE(motions[0].tcp);
  EXPECT_FALSE(motions[0].tool_length_offset);
  EXPECT_EQ(motions[0].known, 0b11101);
  EXPECT_EQ(motions[0].length_register, 5);
  EXPECT_EQ(motions[1].known, 0b11111);
  EXPECT_FALSE(motions[2].tcp);
  EXPECT_EQ(motions[2].known, 0b11000);
}

TEST(Fanuc30iReader, ALengthOffsetForgetsZUnlessTheBlockStatesIt) {
  const auto motions = motions_of("G49\nG0 X1.\nG43 H6 Z30.\nX2.");
  ASSERT_EQ(motions.size(), 3u);
  EXPECT_EQ(motions[0].known, 0b11011);
  EXPECT_FALSE(motions[0].tool_length_offset);
  EXPECT_TRUE(motions[1].tool_length_offset);
  EXPECT_EQ(motions[2].position[2], 30.0);
  EXPECT_EQ(motions[2].known, 0b11111);
}

TEST(Fanuc30iReader, RefusesALengthOffsetWithoutRegister) {
  const auto read = sample::read_items("fanuc-30i", "G90 G94 G21 G0\nG43.4 Z1.\nM30\n");
  EXPECT_EQ(read.message(), "NC text line 2: G43.4 without a length register (H1 and up)");
}

TEST(Fanuc30iReader, G28AlongZIsASafeRetract) {
  const auto read = read_after_start("G91 G28 Z0.\nG90 G0 X5.");
  ASSERT_EQ(read.message(), "");
  EXPECT_EQ(read.all<nc::ReadSafeRetract>().size(), 1u);
  EXPECT_EQ(read.motions().back().known, 0b11011);
}

/// A turned table makes a way along machine Z one along all coordinates of the tip.
TEST(Fanuc30iReader, ARetractAlongZInToolCentrePointControlForgetsTheWholeTip) {
  for (const char* retract : {"G91 G28 Z0.\nG90", "G53 Z0."}) {
    const auto motions =
        motions_of("G43.4 H5 X0. Y0. Z9.\n" + std::string{retract} + "\nG49\nG0 C5.");
    EXPECT_EQ(motions.back().known, 0b11000) << retract;
  }
}

TEST(Fanuc30iReader, G28AlongOtherAxesGoesToAnUnknownPlace) {
  const auto motion = last_motion("G91 G28 X0. Y0.");
  EXPECT_TRUE(motion.machine_frame);
  EXPECT_EQ(motion.stated, 0b00011);
  EXPECT_EQ(motion.known, 0);
}

TEST(Fanuc30iReader, RefusesG28ByWayOfAnotherPoint) {
  expect_refused("G28 Z0.", "G28");
  expect_refused("G91 G28 Z5.", "G28");
  expect_refused("G91 G28", "G28");
}

TEST(Fanuc30iReader, G53MovesInMachineCoordinatesAndForgets) {
  const auto motions = motions_of("G53 G0 Z0.\nX1.");
  ASSERT_EQ(motions.size(), 2u);
  EXPECT_TRUE(motions[0].machine_frame);
  EXPECT_EQ(motions[0].known, 0b00100);
  EXPECT_FALSE(motions[1].machine_frame);
  EXPECT_EQ(motions[1].known, 0b11011);
  expect_refused("G91 G53 Z0.", "G90");
}

TEST(Fanuc30iReader, G53IsARapidWhateverTheMotionMode) {
  EXPECT_EQ(last_motion("G1 X1.\nG53 Z0.").kind, Kind::rapid);
}

TEST(Fanuc30iReader, RefusesInToolCentrePointControlWhatTheControlForbids) {
  for (const std::string_view blocks :
       {"G91 G28 X0.", "G53 C0.", "G53 X0. Z0.", "T6 M6", "G55", "G81 X1. Z1. R2."}) {
    SCOPED_TRACE(blocks);
    const auto read = read_after_start("G43.4 H5 X0. Y0. Z9.\n" + std::string{blocks});
    ASSERT_FALSE(read.status.has_value());
    EXPECT_NE(read.message().find("G43.4"), std::string::npos) << read.message();
  }
}

TEST(Fanuc30iReader, AnotherWorkOffsetForgetsEveryPosition) {
  const auto motions = motions_of("G54 X1.\nG55 X1.\nG54.1 P7 X1.");
  ASSERT_EQ(motions.size(), 3u);
  EXPECT_EQ(motions[0].work_offset, 54);
  EXPECT_EQ(motions[0].known, 0b11111);
  EXPECT_EQ(motions[1].work_offset, 55);
  EXPECT_EQ(motions[1].known, 0b00001);
  EXPECT_EQ(motions[2].work_offset, 5407);
}

TEST(Fanuc30iReader, AToolChangeForgetsTheLinearAxes) {
  const auto read = read_after_start("T7\nG1 C1.\nM6\nG0 C2.");
  ASSERT_EQ(read.message(), "");
  const auto tools = read.all<nc::ReadTool>();
  ASSERT_EQ(tools.size(), 2u);
  EXPECT_EQ(tools[0].number, 5);
  EXPECT_EQ(tools[1].number, 7);
  EXPECT_EQ(read.motions().back().known, 0b11000);
}

TEST(Fanuc30iReader, TellsTheSpindle) {
  const auto read = read_after_start("S900 M3\nS1000\nG1 X1. M5\nM4");
  ASSERT_EQ(read.message(), "");
  const auto spindle = read.all<nc::ReadSpindle>();
  ASSERT_EQ(spindle.size(), 4u);
  EXPECT_EQ(spindle[0].speed_rpm, 900.0);
  EXPECT_EQ(spindle[1].speed_rpm, 1000.0);
  EXPECT_EQ(spindle[1].state, nc::ReadSpindle::State::clockwise);
  EXPECT_EQ(spindle[2].state, nc::ReadSpindle::State::off);
  EXPECT_EQ(spindle[3].state, nc::ReadSpindle::State::counterclockwise);
}

// Operator's manual, dwell: P in milliseconds without a decimal point, X in seconds.
TEST(Fanuc30iReader, ADwellIsNoMotion) {
  EXPECT_EQ(motions_of("G4 X1.5\nG4 P500").size(), 0u);
  expect_refused("G4 X1. Y1.", "Y1");
}

TEST(Fanuc30iReader, RefusesWhatMayMoveTheMachineOtherwise) {
  const std::pair<std::string_view, std::string_view> cases[] = {
      {"G41 D1 X1.", "G41"},
      {"G42 D1", "G42"},
      {"G68.2 X0. Y0. Z0. I0. J0. K0.", "G68.2"},
      {"G53.1", "G53.1"},
      {"G51 X0. P2.", "G51"},
      {"G51.1 X0.", "G51.1"},
      {"G16", "G16"},
      {"G65 P9010", "G65"},
      {"G66 P1", "G66"},
      {"M98 P2000", "M98"},
      {"M99", "M99"},
      {"M198 P1", "M198"},
      {"G10 L2 P1 X1.", "G10"},
      {"G92 X0.", "G92"},
      {"G52 X1.", "G52"},
      {"G30 Z0.", "G30"},
      {"G31 X1.", "G31"},
      {"G43.5 H5", "G43.5"},
      {"G44 H1", "G44"},
      {"G12.1", "G12.1"},
      {"G2.1 X1.", "G2.1"},
      {"G06.2 P4", "G6.2"},
      {"G07.1 C10.", "G7.1"},
      {"G33 Z1. F1.", "G33"},
      {"G60 X1.", "G60"},
      {"G87 X1. Z1. R1.", "G87"},
      {"G100", "G100"},
      {"M60", "M60"},
      {"#1=5", "macro"},
      {"X#1", "macro"},
      {"X[1+2]", "macro"},
      {"G5.1 Q1 X0.", "X0"},
      {"G1 X1.,R2.", "character"},
      {"G1 X1. B5.", "B5"},
      {"G1 X1. I5.", "I5"},
      {"G1 X1. R5.", "R5"},
      {"G1 X1. E5.", "E5"},
      {"/G1 X1.", "block skip"},
      {"G1 X1. X2.", "twice"},
      {"G0 G1 X1.", "same group"},
      {"g1 x1.", "character"},
      {"O2000", "program number"},
      {"G1 X1. N5", "sequence number"},
      {"G20", "unit"},
      {"M6 X1.", "M6"},
      {"G0 G81 X1. Z1. R2.", "G81"},
      {"G43.4 H5\nG49 X1.", "ends"},
      {"G5 P5", "G5"},
      {"G22 X1.", "G22"},
  };
  for (const auto& [blocks, word] : cases) expect_refused(blocks, word);
}

TEST(Fanuc30iReader, PassesWhatMovesNothing) {
  EXPECT_EQ(
      motions_of("G61\nG64\nG5.1 Q1\nG5.1 Q0\nG5 P10000\nG8 P1\nG69\nG15\nG40\nM8\nM9\nM0\nM1\n"
                 "M10\nM11\nM29\nD5\nG97\nN100\n(G1 X5.)\n\nG09\nG50.1\nG13.1")
          .size(),
      0u);
}

TEST(Fanuc30iReader, RefusesNumbersThatAreNone) {
  for (const std::string_view blocks :
       {"G1 XNAN", "G1 X", "G1 X.", "G1 X-", "G1 X+-5.", "G1 X1234567890123456.", "G1 X1000000.",
        "G1 X- 5.", "S12.5", "T5.", "H5."})
    expect_refused(blocks, "", Code::bad_number);
  expect_refused("IF [1 EQ 1] GOTO 5", "IF", Code::bad_number);
  expect_refused("GOTO 5", "GOTO", Code::bad_number);
  expect_refused("G1 X1.5.2", "character");
  expect_refused("G1 X1E5", "E5");
  expect_refused("G1 X1,5", "character");
  expect_refused("G1 F0.", "F0", Code::no_feed);
  expect_refused("G1 F-5.", "F-5", Code::no_feed);
}

TEST(Fanuc30iReader, ReadsCrLfAndASemicolonAsTheEndOfABlock) {
  const auto read =
      sample::read_items("fanuc-30i", "%\r\nG90 G94 G21;\r\nG0 X1.;G1 X2. F5.\r\nM30\r\n%\r\n");
  ASSERT_EQ(read.message(), "");
  ASSERT_EQ(read.motions().size(), 2u);
  EXPECT_EQ(read.motions()[1].position[0], 2.0);
}

TEST(Fanuc30iReader, AnUnfinishedProgramIsAProblem) {
  const std::string whole = "%\nG90 G94 G21\nG1 X10.5 F100.\nM30\n%\n";
  ASSERT_TRUE(sample::read_items("fanuc-30i", whole).status.has_value());
  for (std::size_t length = 0; length < whole.find("M30") + 4; ++length) {
    SCOPED_TRACE(length);
    EXPECT_FALSE(sample::read_items("fanuc-30i", whole.substr(0, length)).status.has_value());
  }
}

TEST(Fanuc30iReader, RefusesWordsBehindTheEnd) {
  EXPECT_FALSE(sample::read_items("fanuc-30i", "G90\nM30\nG0\n").status.has_value());
  EXPECT_FALSE(sample::read_items("fanuc-30i", "%\nM30\n%\nM3\n").status.has_value());
  EXPECT_FALSE(sample::read_items("fanuc-30i", "(NO END\nM30\n").status.has_value());
}

TEST(Fanuc30iReader, RefusesLettersThatAreNoAxis) {
  EXPECT_FALSE(sample::read_items("fanuc-30i", "M30\n", "XYZQ").status.has_value());
  EXPECT_FALSE(sample::read_items("fanuc-30i", "M30\n", "XYZX").status.has_value());
  EXPECT_FALSE(sample::read_items("fanuc-30i", "M30\n", "").status.has_value());
}

TEST(Fanuc30iReader, RefusesAnAxisThatTheMachineDoesNotHave) {
  const auto read = read_after_start("G1 X1. A5.", "XYZ");
  EXPECT_EQ(read.message(), "NC text line 8: A5 has no meaning that is understood in this block");
}

TEST(Fanuc30iReader, HandsOnTheProblemOfTheSink) {
  const auto status = nc::find_reader("fanuc-30i")
                          ->read("G90 G94 G21 G0\nX1.\nX2.\nM30\n", {.letters = "XYZ"},
                                 [](const nc::ReadItem& item) -> Status {
                                   if (item.text_line == 2)
                                     return Problem{Code::proof_failed, "enough"};
                                   ADD_FAILURE() << "went on";
                                   return ok();
                                 });
  ASSERT_FALSE(status.has_value());
  EXPECT_EQ(status.error().code, Code::proof_failed);
}

}  // namespace
