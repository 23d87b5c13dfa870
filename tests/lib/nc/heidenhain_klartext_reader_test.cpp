#include "lib/nc/klartext_reader_case.hpp"

#include <gtest/gtest.h>

#include <string>

namespace {

using namespace pentapost;
using nc::ReadMotion;
using sample::klartext::last;
using sample::klartext::motions;
using sample::klartext::read;
using sample::klartext::refusal;

sample::ReadProgramItems whole(std::string_view text) {
  return sample::read_items("heidenhain", text);
}

TEST(HeidenhainKlartextReader, ReadsAWholeProgramOfAnotherPost) {
  const auto items = whole(
      "0  BEGIN PGM BLADE17 MM \r\n"
      "1  ; ---- MADE BY HAND ----\r\n"
      "2  BLK FORM 0.1 Z X-49.8 Y-18.4 Z-46\r\n"
      "3  BLK FORM 0.2  X49.8  Y18.4  Z0\r\n"
      "4  * - OPERATION 1\r\n"
      "5  TOOL DEF 6\r\n"
      "6  TOOL CALL 5 Z S12000 F500 DL+0 DR+0.5\r\n"
      "7  L Z-1 R0 FMAX M91\r\n"
      "8  M126\r\n"
      "9  CYCL DEF 32.0 TOLERANZ\r\n"
      "10 CYCL DEF 32.1 T0.01\r\n"
      "11 CYCL DEF 32.2 HSC-MODE:0 TA0.5\r\n"
      "12 L  A-30  C+90 R0 F MAX M3\r\n"
      "13 FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\r\n"
      "14 L  X+10  Y20 Z+30. R0 FMAX M8 ; ABOVE\r\n"
      "15 L Z-5 F AUTO\r\n"
      "16 L IX+5 C91 F1000\r\n"
      "17 FUNCTION RESET TCPM\r\n"
      "18 M140 MB MAX\r\n"
      "19 M5 M9\r\n"
      "20 STOP\r\n"
      "21 L M30\r\n"
      "22 END PGM BLADE17 MM\r\n");

  EXPECT_EQ(items.message(), "");
  const auto all = items.motions();
  ASSERT_EQ(all.size(), 5u);
  EXPECT_TRUE(all[0].machine_frame);
  EXPECT_EQ(all[1].kind, ReadMotion::Kind::rapid);
  EXPECT_EQ(all[1].stated, 0x18);
  EXPECT_FALSE(all[1].tcp);
  EXPECT_TRUE(all[1].tool_length_offset);
  EXPECT_TRUE(all[2].tcp);
  EXPECT_EQ(all[2].known, 0x1F);
  EXPECT_EQ(all[3].feed, 500.0);
  EXPECT_EQ(all[4].position, (std::array<double, 5>{15, 20, -5, -30, 91}));
  EXPECT_EQ(all[4].feed, 1000.0);
  EXPECT_EQ(items.all<nc::ReadTool>().at(0).number, 5);
  EXPECT_EQ(items.all<nc::ReadSpindle>().at(0).speed_rpm, 12000.0);
  EXPECT_EQ(items.all<nc::ReadSafeRetract>().size(), 1u);
  EXPECT_EQ(items.all<nc::ReadEnd>().size(), 1u);
}

TEST(HeidenhainKlartextReader, NamesTheLineOfEveryItem) {
  const auto items = whole("BEGIN PGM A MM\n\n; NOTE\nL X+1 R0 FMAX\nM30\nEND PGM A MM\n");

  ASSERT_EQ(items.items.size(), 2u);
  EXPECT_EQ(items.items[0].text_line, 4u);
  EXPECT_EQ(items.items[1].text_line, 5u);
}

TEST(HeidenhainKlartextReader, EndsWithEndPgmAlone) {
  const auto items = whole("BEGIN PGM A MM\nEND PGM A MM\n");

  EXPECT_EQ(items.message(), "");
  EXPECT_EQ(items.all<nc::ReadEnd>().size(), 1u);
}

TEST(HeidenhainKlartextReader, RefusesTextsThatAreNoProgram) {
  for (const char* text :
       {"", "\n\n", "L X+1\n", "%A G71 *\n", "BEGIN PGM\n", "BEGIN PGM MM\n", "BEGIN PGM A\n",
        "BEGIN PGM A CM\n", "BEGIN A MM\n", "BEGIN PGM A MM\n", "BEGIN PGM A MM\nL X+1 FMAX\n",
        "BEGIN PGM A MM\nCYCL DEF 200 ~\n", "BEGIN PGM A MM\nCYCL DEF 200 ~"})
    EXPECT_FALSE(whole(text).status.has_value()) << text;
}

TEST(HeidenhainKlartextReader, RefusesBlocksBehindTheEnd) {
  EXPECT_FALSE(whole("BEGIN PGM A MM\nM30\nL X+1 FMAX\nEND PGM A MM\n").status.has_value());
  EXPECT_FALSE(whole("BEGIN PGM A MM\nEND PGM A MM\nL X+1 FMAX\n").status.has_value());
  EXPECT_FALSE(whole("BEGIN PGM A MM\nEND PGM A MM\nEND PGM A MM\n").status.has_value());
  EXPECT_FALSE(whole("BEGIN PGM A MM\nM30\nLBL 1\nEND PGM A MM\n").status.has_value());
}

TEST(HeidenhainKlartextReader, TakesFmaxForItsBlockAlone) {
  const auto all = motions("L X+1 F200\nL X+2 FMAX\nL X+3\n");

  EXPECT_EQ(all[1].kind, ReadMotion::Kind::rapid);
  EXPECT_EQ(all[2].kind, ReadMotion::Kind::line);
  EXPECT_EQ(all[2].feed, 200.0);
}

TEST(HeidenhainKlartextReader, RefusesALineWithoutAFeed) {
  EXPECT_EQ(refusal("L X+1\n"), "a cutting motion has no feed");
  EXPECT_EQ(refusal("L X+1 FAUTO\n"), "FAUTO, but TOOL CALL has no feed");
  EXPECT_EQ(refusal("L X+1 F0\n"), "F0 is no feed");
}

TEST(HeidenhainKlartextReader, TakesTheFeedOfTheToolCall) {
  EXPECT_EQ(last("TOOL CALL 1 Z S100 F350\nL X+1\n").feed, 350.0);
  EXPECT_EQ(last("TOOL CALL 1 Z S100 F350\nL X+1 F20\nL X+2 FAUTO\nL X+3\n").feed, 350.0);
}

TEST(HeidenhainKlartextReader, ReadsFeedsPerRevolution) {
  EXPECT_EQ(last("TOOL CALL 1 Z S400\nM3\nM136\nL X+1 F0.5\n").feed, 200.0);
  EXPECT_EQ(refusal("M136\nL X+1 F0.5\n"), "a feed per revolution while the spindle does not turn");
  EXPECT_EQ(refusal("TOOL CALL 1 Z S400\nM3\nL X+0 F100\nM136\nL X+1\n"),
            "a cutting motion has no feed");
  EXPECT_EQ(refusal("TOOL CALL 1 Z S400\nM3\nM136 F0.5\nL X+1\nM137\nL X+2\n"),
            "a cutting motion has no feed");
}

TEST(HeidenhainKlartextReader, ReadsSingleAxisBlocks) {
  const auto all = motions("Z+50 R0 FMAX M3\nC-4 F5\nIC+10 F5\n");

  EXPECT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].stated, 0x04);
  EXPECT_EQ(all[2].position[4], 6.0);
}

TEST(HeidenhainKlartextReader, RefusesAnIncrementFromNowhere) {
  EXPECT_EQ(refusal("L IX+5 FMAX\n"), "IX from a position that is not known");
}

TEST(HeidenhainKlartextReader, KnowsWhichColumnsItKnows) {
  EXPECT_EQ(last("L X+1 Y+2 FMAX\nL Z+3 FMAX\n").known, 0x07);
  EXPECT_EQ(last("L X+1 Y+2 Z+3 A+4 C+5 FMAX\nM128\nL A+5 FMAX\n").known, 0x18);
  EXPECT_EQ(last("L X+1 Y+2 Z+3 A+4 C+5 FMAX\nM140 MB MAX F500\nL A+5 FMAX\n").known, 0x18);
  EXPECT_EQ(last("L X+1 Y+2 Z+3 A+4 C+5 FMAX\nTOOL CALL 2 Z\nL A+5 FMAX\n").known, 0x18);
  EXPECT_EQ(last("L X+1 Y+2 Z+3 A+4 C+5 FMAX\nL Z+0 FMAX M91\nL A+5 FMAX\n").known, 0x1B);
  EXPECT_EQ(last("L X+1 Y+2 Z+3 A+4 C+5 FMAX\nM94 C\nL A+5 FMAX\n").known, 0x0F);
  EXPECT_EQ(last("L X+1 Y+2 Z+3 A+4 C+5 FMAX\nM94\nL X+5 FMAX\n").known, 0x07);
}

TEST(HeidenhainKlartextReader, ReadsMachinePositions) {
  const auto m91 = last("L Z-1 R0 FMAX M91\n");
  EXPECT_TRUE(m91.machine_frame);
  EXPECT_EQ(m91.position[2], -1.0);
  EXPECT_EQ(m91.known, 0x04);
  // Where the datum of M92 lies, the machine builder says.
  EXPECT_EQ(last("L Z+0 R0 FMAX M92\n").known, 0x00);
  EXPECT_EQ(refusal("M128\nL Z+0 FMAX M91\n"), "M91 or M92 while M128 is on");
  EXPECT_EQ(refusal("L IZ+0 FMAX M91\n"), "IZ from a position that is not known");
}

TEST(HeidenhainKlartextReader, SwitchesTcpAtTheStartAndOffAtTheEndOfTheBlock) {
  const auto all = motions("L X+1 FMAX M128 F2000\nL X+2 F100 M129\nL X+3\n");

  EXPECT_TRUE(all[0].tcp);
  EXPECT_TRUE(all[1].tcp);
  EXPECT_FALSE(all[2].tcp);
  EXPECT_EQ(all[2].feed, 100.0);
}

TEST(HeidenhainKlartextReader, ReadsTheTcpmThatItModelsAlone) {
  EXPECT_TRUE(
      last("FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT TIP-TIP F500\nL X+1 FMAX\n").tcp);
  for (const char* other :
       {"FUNCTION TCPM F CONT AXIS POS PATHCTRL AXIS\n", "FUNCTION TCPM\n",
        "FUNCTION TCPM F TCP AXIS SPAT PATHCTRL AXIS\n",
        "FUNCTION TCPM F TCP AXIS POS PATHCTRL VECTOR\n", "FUNCTION TCPM F TCP AXIS POS\n",
        "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT CENTER-CENTER\n", "FUNCTION MODE TURN\n",
        "FUNCTION RESET\n", "FUNCTION\n"})
    EXPECT_NE(refusal(other), "");
  EXPECT_EQ(motions("FUNCTION MODE MILL\n").size(), 0u);
}

TEST(HeidenhainKlartextReader, RefusesWhatExcludesTcp) {
  EXPECT_EQ(refusal("M116\nM128\n"), "M116 and M128 exclude each other");
  EXPECT_EQ(refusal("M128\nM116\n"), "M116 and M128 exclude each other");
  EXPECT_EQ(refusal("M128\nTOOL CALL 4 Z\n"), "a tool call while M128 is on");
  EXPECT_EQ(refusal("M128\nM6\n"), "M6 while M128 is on");
}

TEST(HeidenhainKlartextReader, KeepsItsPlaceWhereNothingMovesWhileTcpIsOff) {
  const std::string at = "M128\nL X+1 Y+2 Z+3 A+4 C+5 FMAX\nM129\n";
  EXPECT_EQ(last(at + "TOOL CALL Z S5\nM128\nL X+9 FMAX\n").known, 0x1F);
  for (const char* between : {"L Y+5 FMAX\n", "TOOL CALL 5 Z\n", "M6\n", "M140 MB MAX\n",
                              "L Z+0 FMAX M91\n", "CYCL DEF 7.1 X+5\n"})
    EXPECT_EQ(last(at + between + "M128\nL X+9 FMAX\n").known & 0x07, 0x01) << between;
}

TEST(HeidenhainKlartextReader, ChangesTheSpeedWhileTcpIsOn) {
  const auto items = read("TOOL CALL 4 Z S100\nM3\nM128\nTOOL CALL Z S200\nTOOL CALL S300\n");

  EXPECT_EQ(items.message(), "");
  const auto spindle = items.all<nc::ReadSpindle>();
  ASSERT_EQ(spindle.size(), 3u);
  EXPECT_EQ(spindle[1].speed_rpm, 200.0);
  EXPECT_EQ(spindle[2].speed_rpm, 300.0);
  EXPECT_EQ(items.all<nc::ReadTool>().size(), 1u);
}

TEST(HeidenhainKlartextReader, RefusesToolCallsThatItCannotFollow) {
  for (const char* call :
       {"TOOL CALL \"D10\" Z S100\n", "TOOL CALL 5.1 Z\n", "TOOL CALL 5 Y\n", "TOOL CALL Q5 Z\n",
        "TOOL CALL 40000 Z\n", "TOOL CALL 5 Z DL+0.1\n", "TOOL CALL 5 6 Z\n", "TOOL CALL 5 Z S-1\n",
        "TOOL CALL 5 Z S\n", "TOOL CALL 5 Z F0\n", "TOOL CALL +5 Z\n", "TOOL\n"})
    EXPECT_NE(refusal(call), "");
}

TEST(HeidenhainKlartextReader, StopsTheSpindleWithM0AndM6) {
  for (const char* stop : {"M0\n", "M6\n", "STOP M5\n"}) {
    const auto spindle = read("TOOL CALL 1 Z S50\nM3\n" + std::string{stop}).all<nc::ReadSpindle>();
    ASSERT_EQ(spindle.size(), 2u) << stop;
    EXPECT_EQ(spindle[1].state, nc::ReadSpindle::State::off);
  }
  for (const char* stop : {"M1\n", "STOP\n"})
    EXPECT_EQ(read("TOOL CALL 1 Z S50\nM3\n" + std::string{stop}).all<nc::ReadSpindle>().size(),
              1u);
}

TEST(HeidenhainKlartextReader, TurnsBothWays) {
  const auto spindle = read("TOOL CALL 1 Z S50\nM13\nM14\nM5\n").all<nc::ReadSpindle>();

  ASSERT_EQ(spindle.size(), 3u);
  EXPECT_EQ(spindle[0].state, nc::ReadSpindle::State::clockwise);
  EXPECT_EQ(spindle[1].state, nc::ReadSpindle::State::counterclockwise);
  EXPECT_EQ(spindle[2].state, nc::ReadSpindle::State::off);
}

TEST(HeidenhainKlartextReader, WantsTurnsBelowHalfATurnWithM126) {
  EXPECT_EQ(last("M126\nL C+10 FMAX\nL C+189 FMAX\n").position[4], 189.0);
  EXPECT_EQ(refusal("M126\nL C+10 FMAX\nL C+190 FMAX\n"), "C moves by 180 deg while M126 is on");
  EXPECT_EQ(last("M126\nM127\nL C+10 FMAX\nL C+190 FMAX\n").position[4], 190.0);
}

TEST(HeidenhainKlartextReader, TakesFunctionsThatMoveNothing) {
  for (const char* harmless : {"M8\n",
                               "M9\n",
                               "M7\n",
                               "M19\n",
                               "M25\n",
                               "M90\n",
                               "M103 F50\n",
                               "M103\n",
                               "M105\n",
                               "M107\n",
                               "M109\n",
                               "M110\n",
                               "M111\n",
                               "M116\n",
                               "M117\n",
                               "M120 LA10\n",
                               "M126\n",
                               "M127\n",
                               "M134\n",
                               "M137\n",
                               "M148\n",
                               "M200\n",
                               "PLANE RESET STAY\n",
                               "TOOL DEF 7\n",
                               "BLK FORM FILE\n",
                               "CYCL DEF 9.0 VERWEILZEIT\nCYCL DEF 9.1 V.ZEIT 1.5\n",
                               "CYCL DEF 8.0 MIRROR\nCYCL DEF 8.1\n",
                               "CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+0\n",
                               "CYCL DEF 11.0 SCALING\nCYCL DEF 11.1 SCL 1\n",
                               "CYCL DEF 13.0 ORIENT\nCYCL DEF 13.1 ANGLE 5\n",
                               "CYCL DEF 19.0 WORKING PLANE\nCYCL DEF 19.1 A+0 B+0 C+0\n",
                               "CYCL DEF 19.1\n",
                               "12\n",
                               "; only a remark ~\n",
                               "\t\n"})
    EXPECT_EQ(motions(harmless).size(), 0u) << harmless;
}

TEST(HeidenhainKlartextReader, DoesNotTakeTheFactorOfM103ForAFeed) {
  EXPECT_EQ(last("L X+0 F300\nL X+1 M103 F50\n").feed, 300.0);
}

TEST(HeidenhainKlartextReader, RefusesFunctionsThatMayMoveTheMachine) {
  for (const char* function : {"M89", "M97", "M98", "M101", "M112", "M114", "M118", "M124", "M130",
                               "M138", "M141", "M143", "M144"})
    EXPECT_EQ(refusal(std::string{"L X+1 FMAX "} + function + "\n"),
              std::string{function} + " is not understood; it may move the machine");
  EXPECT_NE(refusal("M140 MB50\n").find("M140 is understood with MB MAX only"), std::string::npos);
}

TEST(HeidenhainKlartextReader, DoesNotEvaluateParametersAndJumps) {
  for (const char* block : {"Q1 = +5\n", "QL2=3\n", "FN 0: Q2=68 ; FEED\n", "FN 9: IF +1 EQU +1\n",
                            "L X+Q5 FMAX\n", "L X+1 FQ2\n", "LBL 1\n", "CALL LBL 1 REP 5\n",
                            "CALL PGM X\n", "SEL TABLE \"A\"\n", "CYCL DEF 200 A ~\nQ200=Q1\n"})
    EXPECT_NE(refusal(block).find("not evaluated"), std::string::npos) << block;
}

TEST(HeidenhainKlartextReader, SaysWordAndLineOfARefusal) {
  EXPECT_EQ(read("M8\n12 FN 0: Q2=68\n").message(),
            "NC text line 3: Q parameters are not evaluated, in 'FN 0: Q2=68'");
  EXPECT_EQ(read("L X+Q5 FMAX\n").message(),
            "NC text line 2: Q parameters are not evaluated, in 'L X+Q5 FMAX'");
}

TEST(HeidenhainKlartextReader, RefusesPathsThatItDoesNotModel) {
  for (const char* block : {"LN X+1 Y+2 Z+3 NX+0 NY+0 NZ+1 TX+0 TY+0 TZ+1 F100\n",
                            "CT X+1 Y+1\n",
                            "CTP PR+1 PA+5\n",
                            "RND R5\n",
                            "CHF 2\n",
                            "APPR LT X+1 LEN5 RL F50\n",
                            "DEP LT LEN5\n",
                            "FL X+5\n",
                            "FC DR+\n",
                            "SPL X+1\n",
                            "PLANE SPATIAL SPA+0 SPB+45 SPC+0 STAY\n",
                            "PLANE RESET TURN FMAX\n",
                            "PLANE\n",
                            "PATTERN DEF POS1 (X+1)\n",
                            "TCH PROBE 400 A\n",
                            "TRANS DATUM AXIS X+1\n",
                            "CYCL DEF 8.0 MIRROR\nCYCL DEF 8.1 X\n",
                            "CYCL DEF 10.1 ROT+5\n",
                            "CYCL DEF 11.1 SCL 0.9\n",
                            "CYCL DEF 19.1 A+0 B+45 C+0\n",
                            "CYCL DEF 26.1 X1\n",
                            "CYCL DEF 1.0 PECKING\n",
                            "CYCL DEF 7.1 #5\n",
                            "CYCL DEF 251 POCKET ~\nQ215=0\n",
                            "CYCL DEF\n",
                            "CYCL\n",
                            "CYCL DEF X\n",
                            "CYCL CALL POS X+1\n",
                            "L X+1 RL F5\n",
                            "L X+1 RR F5\n",
                            "X+1 R+ F5\n",
                            "L X+1 R5 F5\n",
                            "L X+1 FZ0.1\n",
                            "L B+5 FMAX\n",
                            "L X+1 DR+ F5\n",
                            "L X+1 PA+5 F5\n",
                            "/ L X+1 FMAX\n",
                            "L X+1 X+2 FMAX\n",
                            "L X+1 F5 FMAX\n",
                            "N10 L X+1 FMAX\n",
                            "10L X+1 FMAX\n",
                            "G01 X1\n",
                            "L X FMAX\n",
                            "L X+1 ~\nY+2 FMAX\n",
                            "L X+1 FMAX\rL X+2 FMAX\n",
                            "l x+1 fmax\n",
                            "BEGIN PGM B MM\n"})
    EXPECT_NE(refusal(block), "");
}

TEST(HeidenhainKlartextReader, ShiftsTheDatumWithoutAMotion) {
  const auto all = motions(
      "L X+10 C+5 FMAX\nCYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+3\nCYCL DEF 7.2 IC+1\nL IX+1 "
      "FMAX\n");

  EXPECT_EQ(all[1].datum_shift, (std::array<double, 5>{3, 0, 0, 0, 1}));
  EXPECT_EQ(all[1].position[0], 8.0);
  EXPECT_EQ(all[1].position[4], 4.0);
}

TEST(HeidenhainKlartextReader, SelectsPresets) {
  const auto preset =
      last("L X+1 FMAX\nCYCL DEF 247 DATUM SETTING ~\n Q339=+4 ;DATUM NUMBER\nL Y+1 FMAX\n");

  EXPECT_EQ(preset.work_offset, 4);
  EXPECT_EQ(preset.known, 0x02);
}

TEST(HeidenhainKlartextReader, ReadsInches) {
  const auto items = whole("BEGIN PGM A INCH\nL X+1 C+1 FMAX\nM30\n");

  ASSERT_EQ(items.motions().size(), 1u) << items.message();
  EXPECT_EQ(items.motions()[0].position[0], 25.4);
  EXPECT_EQ(items.motions()[0].position[4], 1.0);
  EXPECT_FALSE(whole("BEGIN PGM A INCH\nL X+1 F50\nM30\n").status.has_value());
}

TEST(HeidenhainKlartextReader, RefusesNumbersOutsideOfTheControlsRange) {
  EXPECT_EQ(refusal("L X+123456 FMAX\n"), "X123456 is out of the control's range");
  EXPECT_EQ(refusal("L X+1 F123456\n"), "F123456 is out of the control's range");
  EXPECT_NE(refusal("L X+1234567890123456 FMAX\n").find("15 digits"), std::string::npos);
}

}  // namespace
