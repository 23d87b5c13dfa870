#include "lib/nc/siemens_reader_case.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace pentapost {
namespace {

using nc::ReadMotion;
using sample::siemens::expect_refused;
using sample::siemens::last_motion;
using sample::siemens::motions_of;
using sample::siemens::read_after_start;
using Kind = ReadMotion::Kind;
using Feed = ReadMotion::Feed;
using Position = std::array<double, 5>;

TEST(Siemens840dReader, ReadsALineToItsEnd) {
  const auto motion = last_motion("G1 X10.5 Y-2 Z+3. C=45");

  EXPECT_EQ(motion.kind, Kind::line);
  EXPECT_EQ(motion.position, (Position{10.5, -2, 3, 0, 45}));
  EXPECT_EQ(motion.stated, 0b10111);
  EXPECT_EQ(motion.known, 0b11111);
  EXPECT_EQ(motion.feed, 200.0);
  EXPECT_EQ(motion.feed_mode, Feed::per_minute);
  EXPECT_EQ(motion.work_offset, 54);
  EXPECT_TRUE(motion.tool_length_offset);
  EXPECT_FALSE(motion.tcp);
}

TEST(Siemens840dReader, TakesWordsInAnyShape) {
  for (const std::string_view block :
       {"G1 X10 Y20", "g1 x10 y20", "G01X10Y20", "N10 G1 X=10 Y = 20",
        ":20 G1 X = AC( 10 ) Y=ac(20)", "AGAIN: G1 X10 Y20 ; to the corner",
        "N5 START_1: G1 X10. Y20.000", "G1 X=IC(10) Y=IC(20)", "G91 G1 X10 Y20",
        "G1 X10 Y20 F = 200 S1=500 M1=3", "G1 X10 Y20\r"})
    EXPECT_EQ(last_motion(block).position, (Position{10, 20, 100, 0, 0})) << block;
}

TEST(Siemens840dReader, CountsFromWhereTheAxisIs) {
  EXPECT_EQ(last_motion("G0 X5\nG91 X2 Y=AC(9) Z-1\nX1").position, (Position{8, 9, 99, 0, 0}));
}

TEST(Siemens840dReader, ReadsInches) {
  const auto motion =
      sample::read_items("siemens-840d", "G90 G700 G94\nG0 X0 Y0 Z0\nG1 X1 F10\nM30\n", "XYZ")
          .motions()
          .back();
  EXPECT_DOUBLE_EQ(motion.position[0], 25.4);
  EXPECT_DOUBLE_EQ(motion.feed, 254.0);
}

/// G70 leaves the feed to the basic system (Fundamentals, inch or metric dimensions).
TEST(Siemens840dReader, LeavesTheFeedMetricWithG70) {
  const auto motion =
      sample::read_items("siemens-840d", "G90 G70 G94\nG1 X1 Y0 Z0 F10\nM30\n", "XYZ")
          .motions()
          .back();
  EXPECT_DOUBLE_EQ(motion.position[0], 25.4);
  EXPECT_DOUBLE_EQ(motion.feed, 10.0);
}

TEST(Siemens840dReader, RunsTheTipWithTraori) {
  const auto motions =
      motions_of("TRAORI\nORIWKS ORIAXES\nG0 X1 Y2 Z3 A-30 C45\nG1 X2 A-31\nTRAFOOF\nG0 C0");

  ASSERT_EQ(motions.size(), 3u);
  EXPECT_TRUE(motions[1].tcp);
  EXPECT_FALSE(motions[1].tool_length_offset);
  EXPECT_EQ(motions[1].known, 0b11111);
  EXPECT_FALSE(motions[2].tcp);
  EXPECT_EQ(motions[2].known, 0b11000);
}

TEST(Siemens840dReader, ForgetsTheLinearAxesWhereTraoriBegins) {
  EXPECT_EQ(last_motion("TRAORI(1)\nG0 X1").known, 0b11001);
  expect_refused("TRAORI\nG0 X=IC(1)", "not known");
}

TEST(Siemens840dReader, RefusesOtherTransformations) {
  expect_refused("TRAORI(2)", "TRAORI");
  expect_refused("TRAORI X0", "TRAORI");
  expect_refused("TRANSMIT", "not understood");
  expect_refused("TRACYL(40)", "not understood");
}

/// D0 of the retract is modal, and the next length acts with the next Z.
TEST(Siemens840dReader, KeepsD0UntilADFollows) {
  const auto motions = motions_of("G0 SUPA Z0 D0\nX5\nZ50\nD1\nX6\nZ40");

  ASSERT_EQ(motions.size(), 5u);
  EXPECT_TRUE(motions[0].machine_frame);
  EXPECT_EQ(motions[0].stated, 0b00100);
  EXPECT_EQ(motions[0].known, 0b00100);
  EXPECT_EQ(motions[1].known, 0b11011);
  EXPECT_FALSE(motions[2].tool_length_offset);
  EXPECT_TRUE(motions[3].tool_length_offset);
  EXPECT_EQ(motions[3].known, 0b11011);
  EXPECT_EQ(motions[4].known, 0b11111);
}

TEST(Siemens840dReader, DoesNotKnowTheMachinePositionOfZWithALength) {
  EXPECT_EQ(last_motion("G0 SUPA Z0").known, 0);
  EXPECT_EQ(last_motion("G0 G153 X1 Y2").known, 0b00011);
  EXPECT_EQ(last_motion("G53 G0 X1 Z2 D0").known, 0b00101);
}

TEST(Siemens840dReader, RefusesMachinePositionsWhereTheyMeanSomethingElse) {
  expect_refused("TRAORI\nG0 SUPA Z0 D0", "TRAORI");
  expect_refused("G91 G0 SUPA Z0", "absolute");
  expect_refused("G2 SUPA X0 I5", "G0 or G1");
}

TEST(Siemens840dReader, RefusesTraoriWithoutTheToolsLength) {
  expect_refused("D0\nTRAORI\nG0 X1 Y2 Z3", "no D");
  expect_refused("T6\nM6\nTRAORI\nG0 X1 Y2 Z3", "no D");
  EXPECT_TRUE(last_motion("D0\nTRAORI\nD1\nG0 X1 Y2 Z3").tcp);
  EXPECT_EQ(last_motion("T6 M6\nTRAORI\nG0 A3").position[3], 3.0);
}

/// Machine data 20270 decides which D a tool change selects.
TEST(Siemens840dReader, WantsADBehindAToolChange) {
  expect_refused("T6 M6\nG0 Z50", "D behind the tool change");
  EXPECT_TRUE(last_motion("T6 M6\nD1\nG0 Z50").tool_length_offset);
  EXPECT_TRUE(last_motion("T6 M6\nG0 Z50 D2").tool_length_offset);
  EXPECT_TRUE(last_motion("T6 D1\nM6\nG0 Z50").tool_length_offset);
  EXPECT_TRUE(last_motion("T6 D1 M6\nG0 Z50").tool_length_offset);
  EXPECT_FALSE(last_motion("T6 M6 D0\nG0 Z50").tool_length_offset);
}

TEST(Siemens840dReader, TakesTheDOfAToolChangeFromItsOption) {
  bool length = false;
  const auto status = nc::find_reader("siemens-840d")
                          ->read("G90 G71\nT6 M6\nG0 Z50\nM30\n",
                                 {.letters = "XYZ", .options = {{"edge_after_tool_change", 1.0}}},
                                 [&](const nc::ReadItem& item) {
                                   if (const auto* motion = std::get_if<ReadMotion>(&item.what))
                                     length = motion->tool_length_offset;
                                   return ok();
                                 });
  EXPECT_TRUE(status.has_value());
  EXPECT_TRUE(length);
}

TEST(Siemens840dReader, ChangesToolsWithM6) {
  const auto read = read_after_start("T=\"12\"\nG1 X1\nM6\nT7 M6");
  const auto tools = read.all<nc::ReadTool>();

  ASSERT_EQ(tools.size(), 3u) << read.message();
  EXPECT_EQ(tools[0].number, 5);
  EXPECT_EQ(tools[1].number, 12);
  EXPECT_EQ(tools[2].number, 7);
}

TEST(Siemens840dReader, RefusesToolChangesThatItCannotFollow) {
  expect_refused("T=\"BALL_10\"", "name");
  expect_refused("TRAORI\nT6 M6", "M6 while TRAORI");
  expect_refused("T6 M6 X0", "M6 and axis words");
  expect_refused("T1.5", "T1.5", Code::bad_number);
}

TEST(Siemens840dReader, TurnsTheSpindle) {
  const auto read = read_after_start("S12000 M3\nS8000\nM4\nS1=100 M1=3\nM5\nSPOS=DC(90)");
  const auto spindle = read.all<nc::ReadSpindle>();

  using State = nc::ReadSpindle::State;
  ASSERT_EQ(spindle.size(), 6u) << read.message();
  EXPECT_EQ(spindle[0].speed_rpm, 12000.0);
  EXPECT_EQ(spindle[1].speed_rpm, 8000.0);
  EXPECT_EQ(spindle[2].state, State::counterclockwise);
  EXPECT_EQ(spindle[3].state, State::clockwise);
  EXPECT_EQ(spindle[3].speed_rpm, 100.0);
  EXPECT_EQ(spindle[4].state, State::off);
  EXPECT_EQ(spindle[5].state, State::off);
}

TEST(Siemens840dReader, ReadsArcsByTheirCentreFromTheStart) {
  const auto motion = last_motion("G0 X10\nG3 X0 Y10 I-10 J0");

  EXPECT_EQ(motion.kind, Kind::arc);
  EXPECT_FALSE(motion.clockwise);
  EXPECT_EQ(motion.centre_x_mm, 0.0);
  EXPECT_EQ(motion.centre_y_mm, 0.0);
  EXPECT_EQ(motion.whole_turns, 0);
}

TEST(Siemens840dReader, ReadsOtherFormsOfArcs) {
  EXPECT_EQ(last_motion("G0 X10 Y5\nG2 X20 Y15 I=AC(10) J=AC(15)").centre_y_mm, 15.0);
  EXPECT_NEAR(last_motion("G0 X10\nG3 X0 Y10 CR=10").centre_x_mm, 0.0, 1e-9);
  EXPECT_NEAR(last_motion("G0 X10\nG3 X0 Y10 CR=-10").centre_x_mm, 10.0, 1e-9);
  EXPECT_EQ(last_motion("G0 X10\nG91 G3 X-10 Y10 I-10").centre_x_mm, 0.0);
}

/// "The number of additional full-circle passes": they come on top of the circle itself.
TEST(Siemens840dReader, AddsTheTurnsOfAHelix) {
  EXPECT_EQ(last_motion("G0 X10\nG3 X0 Y10 Z90 I-10 J0 TURN=2").whole_turns, 2);
  EXPECT_EQ(last_motion("G0 X10\nG2 I-10").whole_turns, 1);
  EXPECT_EQ(last_motion("G0 X10\nG2 X10 Y0 Z50 I-10 TURN = 3").whole_turns, 4);
}

TEST(Siemens840dReader, RefusesArcsThatItCannotFollow) {
  expect_refused("G18\nG2 X10 Z90 I5", "G17");
  expect_refused("G2 X10 Y0 I5 C90", "C moves");
  expect_refused("G2 X10 Y0 I4", "differ", Code::bad_arc);
  expect_refused("G2 X10 Y0 CR=4", "radius", Code::bad_arc);
  expect_refused("G2 X10 Y0 CR=5 I5", "both", Code::bad_arc);
  expect_refused("G2 X10 I5 TURN=1.5", "TURN", Code::bad_arc);
  expect_refused("G1 X10 CR=5", "CR");
  expect_refused("G2 X10 AR=90", "not understood");
  expect_refused("CIP X10 Y0 I1=5 J1=5", "not understood");
  expect_refused("CT X10 Y0", "not understood");
}

TEST(Siemens840dReader, ReadsInverseTime) {
  const auto motion = last_motion("G93 G1 X1 C5 F12.5");

  EXPECT_EQ(motion.feed_mode, Feed::inverse_time);
  EXPECT_EQ(motion.feed, 12.5);
  expect_refused("G93 G1 X1 C5 F12.5\nX2", "own F", Code::no_feed);
}

TEST(Siemens840dReader, WantsANewFeedWithANewFeedMode) {
  expect_refused("G93 G1 X1 F5\nG94 X2", "no feed", Code::no_feed);
  EXPECT_EQ(last_motion("S100 M3\nG95 G1 X1 F0.5").feed, 50.0);
  expect_refused("G95 G1 X1 F0.5", "spindle", Code::no_feed);
}

TEST(Siemens840dReader, TakesFAndSOfADwellForATime) {
  EXPECT_EQ(last_motion("G4 F2.5\nG1 X1").feed, 200.0);
  EXPECT_EQ(last_motion("S500 M3\nG4 S30\nG95 G1 X1 F1").feed, 500.0);
  expect_refused("G4 F1 X5", "no meaning");
  expect_refused("G4", "G4");
}

/// The end of a rapid is certain, its way is not.
TEST(Siemens840dReader, ReadsTheShortestWay) {
  EXPECT_EQ(last_motion("G0 C=DC(350)").position[4], 350.0);
  EXPECT_EQ(last_motion("G0 C=ACP(10)\nG0 C=ACN(5)").position[4], 5.0);
  EXPECT_EQ(last_motion("G1 C=DC(90)").position[4], 90.0);
  EXPECT_EQ(last_motion("G1 C=ACP(90)").position[4], 90.0);
}

TEST(Siemens840dReader, RefusesTheShortestWayWhereItsNumbersMislead) {
  expect_refused("G1 C=DC(350)", "crosses 0");
  expect_refused("G1 C=ACN(90)", "crosses 0");
  expect_refused("G0 C=DC(360)", "0 to 360", Code::bad_number);
  expect_refused("G0 X=DC(5)", "rotary");
}

TEST(Siemens840dReader, KeepsTheWorkOffset) {
  EXPECT_EQ(last_motion("G55\nG0 X1").work_offset, 55);
  EXPECT_EQ(last_motion("G505\nG0 X1").work_offset, 505);
  EXPECT_EQ(last_motion("G599\nG0 X1").known, 1);
  EXPECT_EQ(last_motion("G500\nG0 X1").work_offset, 0);
  EXPECT_EQ(last_motion("G54\nG0 X1").known, 0b11111);
  expect_refused("TRAORI\nG55", "work offset");
  expect_refused("G58 X5", "G58");
}

TEST(Siemens840dReader, RefusesShiftsThatAreNotZero) {
  EXPECT_EQ(last_motion("TRANS\nATRANS X0 Y0 Z0\nROT\nROT Z0\nSCALE\nMIRROR\nG0 X1").position[0],
            1.0);
  for (const std::string_view shift :
       {"TRANS X10", "ATRANS Z=-5", "ROT Z30", "AROT X90", "SCALE X1", "MIRROR X0"})
    expect_refused(shift, "shift, rotation");
  expect_refused("ROT RPL=30", "not understood");
}

TEST(Siemens840dReader, UnderstandsWordsThatMoveNothing) {
  const auto motions = motions_of(
      "STOPRE\nFFWON SOFT COMPCAD\nG642 ADIS=0.5\nG64 ORIAXES\nMSG(\"TOOL 7; (TOP)\")\nMSG()\n"
      "CYCLE832(0.01,_ORI_FINISH,0.1)\nCYCLE832()\nFGREF[A]=10 FGREF[C] = 10\nFGROUP(X,Y,Z)\n"
      "WORKPIECE(,\"\",,\"BOX\",112,0,-20,-80,0,0,100,100)\nOTOL=0.1 CTOL=0.01\nDYNFINISH\n"
      "TCARR=0\nM8\nM0\nM1\nG1 X5 SOFT");

  ASSERT_EQ(motions.size(), 1u);
  EXPECT_EQ(motions[0].position[0], 5.0);
}

/// Its old form has a digit for the transformation in the mode.
TEST(Siemens840dReader, RefusesTheOldModeOfCycle832) {
  expect_refused("CYCLE832(0.01,112103)", "CYCLE832");
}

TEST(Siemens840dReader, RefusesWhatItWouldHaveToEvaluate) {
  for (const std::string_view block :
       {"R1=5", "G1 X=R1", "X=10+5", "X = 2 * 3", "X=(5)", "X=$P_EP[X]", "$TC_DP3[1,1]=5",
        "DEF REAL DEPTH", "DEPTH=5", "G1 X=DEPTH", "GOTOF END", "IF R1>5 GOTOB AGAIN", "L100",
        "CALL \"SUB\"", "EXTCALL(\"SUB\")", "SUB_1", "REPEAT AGAIN", "FOR I=1 TO 5", "X=AC(5+3)"})
    expect_refused(block, block.starts_with("SUB_1") || block.starts_with("DEPTH")
                              ? "not understood"
                              : "not evaluated");
}

TEST(Siemens840dReader, NamesTheLineOfWhatItRefuses) {
  const auto read = sample::read_items("siemens-840d", "G90 G71\n; head\nN10 X=R1\nM30\n");

  EXPECT_EQ(read.message(),
            "NC text line 3: variables and expressions are not evaluated, in 'N10 X=R1'");
}

TEST(Siemens840dReader, RefusesWhatItDoesNotModel) {
  expect_refused("G1 A3=0.5 B3=0 C3=1", "vectors");
  expect_refused("G1 X1 LEAD=5", "vectors");
  expect_refused("CYCLE800(1,\"\",0,57,0,0,0,10,0,0,0,0,0,-1)", "swivelled");
  expect_refused("/ G1 X5", "block skip");
  expect_refused("/3 G1 X5", "block skip");
  expect_refused("G41", "G41");
  expect_refused("G75 FP=1 Z1=0", "not understood");
  expect_refused("G74 Z1=0", "index");
  expect_refused("G291", "G291");
  expect_refused("G1 U5", "U5");
  expect_refused("FGROUP(X,Y,Z,A,C)", "FGROUP");
  expect_refused("OVR=50", "not understood");
  expect_refused("BSPLINE X1 Y2", "not understood");
  expect_refused("M98", "M98");
  expect_refused("G0 G1 X5", "second G code");
  expect_refused("X5 X6", "twice");
  expect_refused("G1 X", "without a number", Code::bad_number);
  expect_refused("G1 X5 #", "character");
  expect_refused("%_N_NEXT_MPF", "second program");
}

TEST(Siemens840dReader, NeverGuessesAModeThatTheProgramDidNotSet) {
  const auto message = [](std::string_view text) {
    return sample::read_items("siemens-840d", text).message();
  };
  EXPECT_NE(message("G71 G0 X1\nM30\n").find("G90"), std::string::npos);
  EXPECT_NE(message("G90 G0 X1\nM30\n").find("G70 or G71"), std::string::npos);
  EXPECT_NE(message("G90 G71 X1\nM30\n").find("G0, G1"), std::string::npos);
  EXPECT_NE(message("G90 G71 G1 X1 F5\nM30\n").find("G93, G94"), std::string::npos);
  EXPECT_NE(message("G90 G71 G94 G1 X1\nM30\n").find("no feed"), std::string::npos);
  EXPECT_NE(message("G90 G71 G94 G1 X0 Y0 F5\nG2 I5\nM30\n").find("G17"), std::string::npos);
}

TEST(Siemens840dReader, EndsWhereTheProgramDoes) {
  for (const std::string_view end : {"M30", "M2", "M17", "RET", "m30\n; done\n\n", "N99 M30 ; end"})
    EXPECT_EQ(sample::read_items("siemens-840d", end).all<nc::ReadEnd>().size(), 1u) << end;
  EXPECT_NE(sample::read_items("siemens-840d", "M30\nG0 X1\n").message().find("after the end"),
            std::string::npos);
  EXPECT_NE(sample::read_items("siemens-840d", "G90\n").message().find("M30"), std::string::npos);
}

}  // namespace
}  // namespace pentapost
