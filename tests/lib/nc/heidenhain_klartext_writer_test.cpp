#include "lib/nc/writer_case.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pentapost {
namespace {

using sample::MotionCase;
using sample::klartext::body;
using sample::klartext::options_with;
using Lines = std::vector<std::string>;
using State = path::Spindle::State;

const nc::Dialect& klartext() { return *nc::find_dialect("heidenhain"); }

TEST(HeidenhainKlartextWriter, WritesAWholeProgram) {
  const auto motion = MotionCase{}
                          .act(path::ToolCall{.number = 5, .speed_rpm = 12000.0, .name = "BALL D8"})
                          .act(path::SafeRetract{})
                          .act(path::Spindle{State::clockwise, 12000.0})
                          .act(path::Coolant{path::Coolant::State::flood})
                          .rapid({0, 0, 0, 22.586, 333.177})
                          .stating(0x18)
                          .act(path::TcpOn{})
                          .rapid({50, 50, 100, 22.586, 333.177})
                          .line({50, 50, -8, 22.586, 333.177}, 2000.0)
                          .line({50.25, 50, -8, 23, 333.177}, 2000.0)
                          .act(path::TcpOff{})
                          .act(path::SafeRetract{})
                          .act(path::Coolant{})
                          .act(path::Spindle{})
                          .act(path::ProgramEnd{})
                          .motion;

  const std::string nc = sample::program(
      "heidenhain", motion,
      {{"blank_form", Lines{"BLK FORM 0.1 Z X-60 Y-60 Z-40", "BLK FORM 0.2 X+60 Y+60 Z+0"}}},
      sample::named("non_sing", "hermle-c600u@1.0.0", "0123456789ab"));

  EXPECT_EQ(nc,
            "0 BEGIN PGM NON_SING MM\n"
            "1 BLK FORM 0.1 Z X-60 Y-60 Z-40\n"
            "2 BLK FORM 0.2 X+60 Y+60 Z+0\n"
            "3 ; PROGRAM non_sing\n"
            "4 ; MACHINE hermle-c600u@1.0.0\n"
            "5 ; DEFINITION 0123456789ab\n"
            "6 ; UNITS MM\n"
            "7 ; OUTPUT TCP\n"
            "8 ; BALL D8\n"
            "9 TOOL CALL 5 Z S12000\n"
            "10 M140 MB MAX\n"
            "11 M3\n"
            "12 M8\n"
            "13 L A+22.586 C+333.177 R0 FMAX\n"
            "14 M128\n"
            "15 L X+50 Y+50 Z+100 R0 FMAX\n"
            "16 L Z-8 F2000\n"
            "17 L X+50.25 A+23\n"
            "18 M129\n"
            "19 M140 MB MAX\n"
            "20 M9\n"
            "21 M5\n"
            "22 M30\n"
            "23 END PGM NON_SING MM\n");
}

TEST(HeidenhainKlartextWriter, HasCyclesAndHelicesButNoInverseTime) {
  const auto abilities = klartext().abilities({});

  ASSERT_TRUE(abilities.has_value());
  EXPECT_FALSE(abilities->inverse_time);
  EXPECT_TRUE(abilities->native_cycles);
  EXPECT_TRUE(abilities->arcs);
  EXPECT_TRUE(abilities->helices);
  EXPECT_FALSE(abilities->arcs_with_tcp);
  EXPECT_TRUE(abilities->adds_length_always);
  EXPECT_TRUE(abilities->retract_needs_tool);
  EXPECT_EQ(abilities->largest_feed, 99'999.999);
}

TEST(HeidenhainKlartextWriter, HasTheAbilitiesOfItsOptions) {
  EXPECT_FALSE(klartext().abilities({{"native_cycles", false}})->native_cycles);
  EXPECT_FALSE(klartext().abilities({{"arcs", false}})->helices);
  EXPECT_TRUE(klartext().abilities({{"arcs_with_tcp", true}})->arcs_with_tcp);
  EXPECT_FALSE(klartext().abilities({{"arcs_with_tcp", true}, {"arcs", false}})->arcs_with_tcp);
}

TEST(HeidenhainKlartextWriter, CountsBlocksOneByOneOnly) {
  EXPECT_FALSE(klartext().abilities({{"block_number_step", 10.0}}).has_value());
  EXPECT_FALSE(klartext().abilities({{"block_number_start", 10.0}}).has_value());
}

TEST(HeidenhainKlartextWriter, LeavesBlockNumbersOutOnRequest) {
  EXPECT_EQ(sample::program("heidenhain", MotionCase{}.act(path::ProgramEnd{}).motion,
                            {{"comments", false}, {"block_numbers", false}}),
            "BEGIN PGM PROGRAM MM\nM30\nEND PGM PROGRAM MM\n");
}

TEST(HeidenhainKlartextWriter, CutsTheNameOfTheProgram) {
  const std::string nc =
      sample::program("heidenhain", MotionCase{}.motion, {{"program_name_length", 6.0}},
                      sample::named("blade 17 finish"));

  EXPECT_EQ(nc.substr(0, 22), "0 BEGIN PGM BLADE_ MM\n");
}

TEST(HeidenhainKlartextWriter, WritesTheLinesOfTheShop) {
  const auto motion = MotionCase{}
                          .act(path::ToolCall{.number = 7})
                          .act(path::SafeRetract{})
                          .act(path::TcpOn{})
                          .act(path::TcpOff{})
                          .act(path::ProgramEnd{})
                          .motion;

  EXPECT_EQ(body(motion, {{"comments", false},
                          {"block_numbers", false},
                          {"start_lines", Lines{"M127"}},
                          {"tool_change", Lines{"TOOL CALL {tool} Z {speed}", "M6"}},
                          {"safe_retract", Lines{"L Z+0 R0 FMAX M91"}},
                          {"tcp_on", Lines{"FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS"}},
                          {"tcp_off", Lines{"FUNCTION RESET TCPM"}},
                          {"smoothing_on", Lines{"CYCL DEF 32.0 TOLERANCE", "CYCL DEF 32.1 T0.01",
                                                 "CYCL DEF 32.2 HSC-MODE:0 TA0.5"}},
                          {"smoothing_off", Lines{"CYCL DEF 32.0 TOLERANCE", "CYCL DEF 32.1"}},
                          {"end_lines", Lines{"M140 MB MAX", "M2"}}}),
            "M127\n"
            "TOOL CALL 7 Z\n"
            "M6\n"
            "L Z+0 R0 FMAX M91\n"
            "CYCL DEF 32.0 TOLERANCE\n"
            "CYCL DEF 32.1 T0.01\n"
            "CYCL DEF 32.2 HSC-MODE:0 TA0.5\n"
            "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\n"
            "FUNCTION RESET TCPM\n"
            "CYCL DEF 32.0 TOLERANCE\n"
            "CYCL DEF 32.1\n"
            "M140 MB MAX\n"
            "M2\n");
}

TEST(HeidenhainKlartextWriter, SmoothsWithoutTcpFromTheFirstLinearMove) {
  const auto motion = MotionCase{"XYZAC", Output::axes}
                          .rapid({0, 0, 0, 10, 20})
                          .stating(0x18)
                          .rapid({1, 2, 3, 10, 20})
                          .act(path::SafeRetract{})
                          .motion;

  EXPECT_EQ(body(motion, {{"comments", false},
                          {"block_numbers", false},
                          {"smoothing_on", Lines{"CYCL DEF 32.0 ON"}},
                          {"smoothing_off", Lines{"CYCL DEF 32.0 OFF"}}}),
            "L A+10 C+20 R0 FMAX\n"
            "CYCL DEF 32.0 ON\n"
            "L X+1 Y+2 Z+3 R0 FMAX\n"
            "M140 MB MAX\n"
            "CYCL DEF 32.0 OFF\n");
}

TEST(HeidenhainKlartextWriter, StatesTheSpeedWithTheToolOnce) {
  const auto motion = MotionCase{}
                          .act(path::ToolCall{.number = 3, .speed_rpm = 8000.0})
                          .act(path::Spindle{State::clockwise, 8000.0})
                          .motion;

  EXPECT_EQ(body(motion), "TOOL CALL 3 Z S8000\nM3\n");
}

TEST(HeidenhainKlartextWriter, ChangesTheSpeedByAToolCallWithoutTool) {
  const auto motion = MotionCase{}
                          .act(path::ToolCall{.number = 3, .speed_rpm = 8000.0})
                          .act(path::Spindle{State::clockwise, 8000.0})
                          .act(path::Spindle{State::counterclockwise, 500.0})
                          .motion;

  EXPECT_EQ(body(motion), "TOOL CALL 3 Z S8000\nM3\nTOOL CALL Z S500\nM4\n");
  EXPECT_EQ(body(motion, options_with("speed_change", Lines{"TOOL CALL {speed}"})),
            "TOOL CALL 3 Z S8000\nM3\nTOOL CALL S500\nM4\n");
}

TEST(HeidenhainKlartextWriter, SwitchesTcpOffWhereTheSpeedChanges) {
  const auto motion = MotionCase{}
                          .act(path::TcpOn{})
                          .line({1, 2, 3, 4, 5}, 100.0)
                          .act(path::Spindle{State::clockwise, 500.0})
                          .line({1, 2, 9, 4, 5}, 100.0)
                          .act(path::TcpOff{})
                          .act(path::Spindle{State::clockwise, 700.0})
                          .motion;

  EXPECT_EQ(body(motion),
            "M128\nL X+1 Y+2 Z+3 A+4 C+5 R0 F100\n"
            "M129\nTOOL CALL Z S500\nM128\nM3\nL X+1 Y+2 Z+9 A+4 C+5 F100\n"
            "M129\nTOOL CALL Z S700\nM3\n");
}

TEST(HeidenhainKlartextWriter, RefusesASpeedThatIsNone) {
  const auto motion = MotionCase{}.act(path::Spindle{State::clockwise, -1.0}).motion;

  EXPECT_EQ(sample::refused("heidenhain", motion).code, Code::out_of_domain);
}

TEST(HeidenhainKlartextWriter, StartsSpindleAndCoolantAgainBehindAStop) {
  const auto motion = MotionCase{}
                          .act(path::Spindle{State::clockwise, {}})
                          .act(path::Coolant{path::Coolant::State::flood})
                          .act(path::Stop{})
                          .act(path::Stop{.optional = true})
                          .act(path::Coolant{})
                          .act(path::Spindle{})
                          .act(path::Stop{})
                          .motion;

  EXPECT_EQ(body(motion), "M3\nM8\nM0\nM3\nM8\nM1\nM3\nM8\nM9\nM5\nM0\n");
}

TEST(HeidenhainKlartextWriter, StopsAsTheShopWants) {
  EXPECT_EQ(body(MotionCase{}.act(path::Stop{}).motion,
                 options_with("program_stop", Lines{"STOP M5 M9"})),
            "STOP M5 M9\n");
}

TEST(HeidenhainKlartextWriter, NeedsLinesForStopAndSpeed) {
  EXPECT_FALSE(klartext().abilities({{"program_stop", Lines{}}}).has_value());
  EXPECT_FALSE(klartext().abilities({{"speed_change", Lines{}}}).has_value());
}

TEST(HeidenhainKlartextWriter, StatesAllWordsAgainBehindAStop) {
  const auto motion = MotionCase{}
                          .line({1, 2, 3, 4, 5}, 100.0)
                          .act(path::Stop{})
                          .line({1, 2, 4, 4, 5}, 100.0)
                          .motion;

  EXPECT_EQ(body(motion), "L X+1 Y+2 Z+3 A+4 C+5 R0 F100\nM0\nL X+1 Y+2 Z+4 A+4 C+5 R0 F100\n");
}

TEST(HeidenhainKlartextWriter, DwellsByCycle9) {
  EXPECT_EQ(body(MotionCase{}.act(path::Dwell{1.5}).motion),
            "CYCL DEF 9.0 DWELL TIME\nCYCL DEF 9.1 DWELL 1.5\n");
}

TEST(HeidenhainKlartextWriter, DwellsAtLeastAMillisecond) {
  EXPECT_EQ(body(MotionCase{}.act(path::Dwell{1e-6}).motion),
            "CYCL DEF 9.0 DWELL TIME\nCYCL DEF 9.1 DWELL 0.001\n");
}

TEST(HeidenhainKlartextWriter, RefusesDwellsThatTheCycleDoesNotTake) {
  for (const double bad : {0.0, -1.0, 3600.5})
    EXPECT_EQ(
        sample::refused("heidenhain", MotionCase{}.act(path::Dwell{bad}).motion).code,
        Code::out_of_domain);
}

TEST(HeidenhainKlartextWriter, RefusesToolNumbersOfMoreThanTheControlHas) {
  const auto motion = MotionCase{}.act(path::ToolCall{.number = 32'768}).motion;

  EXPECT_EQ(sample::refused("heidenhain", motion).code, Code::out_of_domain);
}

TEST(HeidenhainKlartextWriter, KeepsCommentsFromJoiningTheNextLine) {
  const auto motion = MotionCase{}.act(path::Comment{"wait ~"}).act(path::ProgramEnd{}).motion;

  const std::string nc = body(motion, {{"block_numbers", false}});

  EXPECT_NE(nc.find("; wait\nM30\n"), std::string::npos) << nc;
}

TEST(HeidenhainKlartextWriter, JoinsInsertedLines) {
  const auto motion = MotionCase{}
                          .act(path::InsertedText{"CYCL DEF 247 DATUM SETTING ~"})
                          .act(path::InsertedText{"Q339=+1 ;DATUM NUMBER"})
                          .act(path::InsertedText{"M8"})
                          .motion;

  EXPECT_EQ(sample::program("heidenhain", motion, {{"comments", false}}),
            "0 BEGIN PGM PROGRAM MM\n"
            "1 CYCL DEF 247 DATUM SETTING ~\n"
            "Q339=+1 ;DATUM NUMBER\n"
            "2 M8\n"
            "3 END PGM PROGRAM MM\n");
}

}  // namespace
}  // namespace pentapost
