#include "lib/nc/writer_case.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace pentapost {
namespace {

using sample::bare;
using sample::bare_with;
using sample::MotionCase;
using sample::siemens::body;
using Kind = path::Block::Kind;
using Lines = std::vector<std::string>;

constexpr std::uint8_t rotary = 0x18, z_alone = 0x04, across = 0x03;

path::ToolCall tool(int number, std::string name = {}) {
  path::ToolCall call;
  call.number = number;
  call.name = std::move(name);
  return call;
}

TEST(Siemens840dWriter, WritesAWholeProgramWithTcp) {
  const auto motion = MotionCase{}
                          .act(path::SafeRetract{})
                          .act(tool(5, "BALL 10"))
                          .act(path::Spindle{path::Spindle::State::clockwise, 12000.0})
                          .act(path::Coolant{path::Coolant::State::flood})
                          .rapid({0, 0, 0, -30, 45})
                          .stating(rotary)
                          .act(path::TcpOn{})
                          .rapid({10, 0, 50, -30, 45})
                          .line({10, 0, 2.5, -30, 45}, 2000.0)
                          .line({10.5, 0.25, 2.5, -31, 45.1}, 2000.0)
                          .line({11, 0.25, 2.5, -32, 45.2}, 1500.0)
                          .act(path::TcpOff{})
                          .act(path::SafeRetract{})
                          .act(path::Coolant{})
                          .act(path::Spindle{})
                          .act(path::ProgramEnd{})
                          .motion;

  EXPECT_EQ(sample::program("siemens-840d", motion, {},
                            sample::named("Blade 7", "hermle-c600u@1.0.0", "1fbe0a1c7d4b")),
            "; %_N_BLADE_7_MPF\n"
            "; PROGRAM Blade 7\n"
            "; MACHINE hermle-c600u@1.0.0\n"
            "; DEFINITION 1fbe0a1c7d4b\n"
            "; UNITS MM\n"
            "; OUTPUT TCP\n"
            "TRAFOOF\n"
            "G90 G94 G710 G17 G40 G64\n"
            "G54\n"
            "G0 SUPA Z0 D0\n"
            "; BALL 10\n"
            "T5\n"
            "M6\n"
            "S12000 M3\n"
            "M8\n"
            "G0 A-30 C45\n"
            "D1\n"
            "TRAORI\n"
            "ORIMKS\n"
            "ORIAXES\n"
            "G0 X10 Y0 Z50 A-30 C45\n"
            "G1 Z2.5 F2000\n"
            "X10.5 Y0.25 A-31 C45.1\n"
            "X11 A-32 C45.2 F1500\n"
            "TRAFOOF\n"
            "G0 SUPA Z0 D0\n"
            "M9\n"
            "M5\n"
            "M30\n");
}

TEST(Siemens840dWriter, BringsTheLengthBackWithTheFirstZAfterARetract) {
  const auto motion = MotionCase{"XYZC", Output::axes}
                          .act(path::SafeRetract{})
                          .act(tool(3))
                          .rapid({0, 0, 0, 9})
                          .stating(0x08)
                          .rapid({1, 2, 50, 9})
                          .stating(across)
                          .rapid({1, 2, 50, 9})
                          .line({1, 2, 0, 9}, 100.0)
                          .act(path::SafeRetract{})
                          .rapid({5, 2, 50, 9})
                          .stating(across)
                          .rapid({5, 2, 50, 9})
                          .stating(z_alone)
                          .motion;

  EXPECT_EQ(body(motion),
            "G0 SUPA Z0 D0\n"
            "T3\n"
            "M6\n"
            "G0 C9\n"
            "X1 Y2\n"
            "Z50 D1\n"
            "G1 Z0 F100\n"
            "G0 SUPA Z0 D0\n"
            "G0 X5 Y2\n"
            "Z50 D1\n");
}

/// Where the head turns, the words hold the tool's length already.
TEST(Siemens840dWriter, SaysD0WhereTheWordsHoldTheLength) {
  MotionCase head{"XYZAC", Output::axes};
  head.motion.length_offset = false;
  head.act(tool(3)).rapid({0, 0, 90, 10, 20}).line({0, 0, 80, 10, 20}, 50.0);

  EXPECT_EQ(body(head.motion),
            "T3\n"
            "M6\n"
            "G0 X0 Y0 Z90 A10 C20 D0\n"
            "G1 Z80 F50\n");
}

TEST(Siemens840dWriter, TakesTheEdgeOfTheShop) {
  auto call = tool(5);
  call.length_register = 25;
  const auto motion = MotionCase{"XYZ", Output::axes}.act(call).rapid({0, 0, 9}).motion;

  EXPECT_NE(body(motion, bare_with("edge", 2.0)).find("Z9 D2\n"), std::string::npos);
  EXPECT_NE(body(motion, bare_with("edge", 0.0)).find("Z9 D25\n"), std::string::npos);
}

TEST(Siemens840dWriter, BeginsEveryArcWithItsCentreFromTheStart) {
  const auto motion = MotionCase{"XYZ"}
                          .line({10, 0, 5}, 100.0)
                          .arc(Kind::arc_counterclockwise, {0, 10, 5}, -10, 0, 100.0)
                          .arc(Kind::arc_counterclockwise, {-10, 0, 5}, 0, -10, 100.0)
                          .arc(Kind::arc_clockwise, {0, 10, 5}, 10, 0, 80.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "G1 X10 Y0 Z5 F100\n"
            "G3 X0 Y10 I-10 J0\n"
            "X-10 Y0 I0 J-10\n"
            "G2 X0 Y10 I10 J0 F80\n");
}

TEST(Siemens840dWriter, WritesAHelixWithItsZ) {
  const auto motion = MotionCase{"XYZ"}
                          .line({10, 0, 5}, 100.0)
                          .arc(Kind::arc_clockwise, {-10, 0, 2.5}, -10, 0, 100.0)
                          .motion;

  EXPECT_EQ(body(motion), "G1 X10 Y0 Z5 F100\nG2 X-10 Y0 Z2.5 I-10 J0\n");
}

TEST(Siemens840dWriter, RefusesAnArcInWhichARotaryAxisMoves) {
  const auto motion = MotionCase{"XYZC"}
                          .line({10, 0, 5, 0}, 100.0)
                          .arc(Kind::arc_clockwise, {-10, 0, 5, 3}, -10, 0, 100.0)
                          .motion;

  EXPECT_EQ(sample::refused("siemens-840d", motion).code, Code::not_in_dialect);
}

TEST(Siemens840dWriter, WritesInverseTimeWithAnFInEveryBlock) {
  const auto motion = MotionCase{"XYZC", Output::axes}
                          .line({0, 0, 0, 0}, 100.0)
                          .inverse({1, 0, 0, 5}, 12.5)
                          .inverse({2, 0, 0, 9}, 12.5)
                          .rapid({2, 0, 50, 9})
                          .inverse({3, 0, 50, 12}, 1e9)
                          .line({4, 0, 50, 12}, 100.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "G1 X0 Y0 Z0 C0 D1 F100\n"
            "G93 X1 C5 F12.5\n"
            "X2 C9 F12.5\n"
            "G0 Z50\n"
            "G1 X3 C12 F99999.999\n"
            "G94 X4 F100\n");
}

TEST(Siemens840dWriter, LeavesInverseTimeBeforeAnythingElse) {
  const auto ended_by = [](path::ActionKind what) {
    return body(
        MotionCase{"XYZC", Output::axes}.inverse({1, 0, 0, 5}, 2.0).act(std::move(what)).motion);
  };
  const std::string cut = "G93 G1 X1 Y0 Z0 C5 D1 F2\n";
  EXPECT_EQ(ended_by(path::Dwell{1.5}), cut + "G94\nG4 F1.5\n");
  EXPECT_EQ(ended_by(path::Stop{}), cut + "G94\nM0\n");
  EXPECT_EQ(ended_by(path::SafeRetract{}), cut + "G94\nG0 SUPA Z0 D0\n");
  EXPECT_EQ(ended_by(path::ProgramEnd{}), cut + "G94\nM30\n");
  EXPECT_EQ(ended_by(path::InsertedText{"H5"}), cut + "G94\nH5\n");
}

TEST(Siemens840dWriter, StatesEverythingAgainAfterAStop) {
  const auto motion = MotionCase{"XYZ"}
                          .line({1, 0, 0}, 10.0)
                          .act(path::Stop{.optional = true})
                          .line({2, 0, 0}, 10.0)
                          .motion;

  EXPECT_EQ(body(motion), "G1 X1 Y0 Z0 F10\nM1\nG1 X2 Y0 Z0 F10\n");
}

TEST(Siemens840dWriter, WritesDwellsInSecondsOfAtLeastAMillisecond) {
  const auto motion = MotionCase{"XYZ"}.act(path::Dwell{2.5}).act(path::Dwell{0.0001}).motion;

  EXPECT_EQ(body(motion), "G4 F2.5\nG4 F0.001\n");
}

TEST(Siemens840dWriter, PrepositionsByTheShortestWayOnRequest) {
  const auto options = bare_with("shortest_way_axes", std::string{"C"});
  MotionCase turned{"XYZAC"};
  turned.rapid({0, 0, 0, -30, 45}).stating(rotary).motion.blocks.back().on_path = false;
  turned.rapid({0, 0, 0, 30, -45}).stating(rotary).motion.blocks.back().on_path = false;
  turned.rapid({0, 0, 0, 30, 360}).stating(rotary).motion.blocks.back().on_path = false;
  turned.rapid({0, 0, 0, 30, 90}).stating(rotary);

  EXPECT_EQ(body(turned.motion, options),
            "G0 A-30 C=DC(45)\n"
            "A30 C-45\n"
            "C360\n"
            "C90\n");
}

TEST(Siemens840dWriter, TakesTheShopsLines) {
  machine::Options options = bare;
  options["program_lines"] = Lines{"%_N_{name}_MPF", ";$PATH=/_N_WKS_DIR/_N_{name}_WPD"};
  options["start_lines"] = Lines{"G0 G90 G710", "G505"};
  options["tool_change"] = Lines{"T=\"{tool}\"", "M6", "D1"};
  options["tcp_on"] = Lines{"TRAORI(1)", "ORIWKS", "ORIAXES"};
  options["smoothing_on"] = Lines{"CYCLE832(0.01,_ORI_FINISH,0.1)"};
  options["smoothing_off"] = Lines{"CYCLE832()"};
  options["safe_retract"] = Lines{"SUPA G0 Z500 D0"};
  options["end_lines"] = Lines{"SUPA G0 X0 Y500 D0", "M30"};
  const auto motion = MotionCase{"XYZAC"}
                          .act(tool(7))
                          .act(path::TcpOn{})
                          .line({1, 0, 0, 0, 0}, 10.0)
                          .act(path::TcpOff{})
                          .act(path::SafeRetract{})
                          .act(path::ProgramEnd{})
                          .motion;

  EXPECT_EQ(sample::program("siemens-840d", motion, options, sample::named("SING")),
            "%_N_SING_MPF\n"
            ";$PATH=/_N_WKS_DIR/_N_SING_WPD\n"
            "G0 G90 G710\n"
            "G505\n"
            "T=\"7\"\n"
            "M6\n"
            "D1\n"
            "CYCLE832(0.01,_ORI_FINISH,0.1)\n"
            "D1\n"
            "TRAORI(1)\n"
            "ORIWKS\n"
            "ORIAXES\n"
            "G1 X1 Y0 Z0 A0 C0 F10\n"
            "TRAFOOF\n"
            "CYCLE832()\n"
            "SUPA G0 Z500 D0\n"
            "SUPA G0 X0 Y500 D0\n"
            "M30\n");
}

TEST(Siemens840dWriter, SmoothsBetweenApproachAndRetractWithoutTcp) {
  machine::Options options = bare_with("smoothing_on", Lines{"CYCLE832(0.01,_FINISH,1)"});
  options["smoothing_off"] = Lines{"CYCLE832()"};
  const auto motion = MotionCase{"XYZC", Output::axes}
                          .rapid({1, 2, 0, 9})
                          .stating(across)
                          .rapid({1, 2, 50, 9})
                          .act(path::SafeRetract{})
                          .act(path::ProgramEnd{})
                          .motion;

  EXPECT_EQ(body(motion, options),
            "G0 X1 Y2\n"
            "CYCLE832(0.01,_FINISH,1)\n"
            "Z50 C9 D1\n"
            "G0 SUPA Z0 D0\n"
            "CYCLE832()\n"
            "M30\n");
}

TEST(Siemens840dWriter, CleansTheProgramName) {
  const auto first_line = [](const std::string& name) {
    const auto nc =
        sample::program("siemens-840d", MotionCase{"XYZ"}.motion, {}, sample::named(name));
    return nc.substr(0, nc.find('\n'));
  };
  EXPECT_EQ(first_line("Blade-7 (rough).mpf"), "; %_N_BLADE_7_ROUGH_MPF_MPF");
  EXPECT_EQ(first_line("1001"), "; %_N_MPF_1001_MPF");
  EXPECT_EQ(first_line("A1"), "; %_N_MPF_A1_MPF");
  EXPECT_EQ(first_line(""), "; %_N_PROGRAM_MPF");
  EXPECT_EQ(first_line("ABCDEFGHIJKLMNOPQRSTUVWXYZ"), "; %_N_ABCDEFGHIJKLMNOPQRSTUVWX_MPF");
  EXPECT_EQ(first_line("../../etc/passwd"), "; %_N_ETC_PASSWD_MPF");
}

TEST(Siemens840dWriter, NumbersBlocksOnRequest) {
  machine::Options options = bare_with("block_numbers", true);
  options["comments"] = true;
  const auto motion = MotionCase{"XYZ"}.rapid({1, 0, 0}).act(path::Comment{"TOP"}).motion;

  EXPECT_EQ(body(motion, options), "; UNITS MM\n; OUTPUT TCP\nN10 G0 X1 Y0 Z0\n; TOP\n");
}

TEST(Siemens840dWriter, ShowsCommentsOnTheScreenOnRequest) {
  machine::Options options = bare_with("messages", true);
  const auto motion = MotionCase{"XYZ"}.act(path::Comment{"FINISH \"7\"; TOP"}).motion;

  EXPECT_EQ(body(motion, options), "MSG(\"FINISH 7; TOP\")\n");
}

TEST(Siemens840dWriter, WritesEveryWordOnRequest) {
  const auto motion = MotionCase{"XYZ"}.line({1, 0, 0}, 10.0).line({2, 0, 0}, 10.0).motion;

  EXPECT_EQ(body(motion, bare_with("modal_words", false)), "G1 X1 Y0 Z0 F10\nX2 Y0 Z0\n");
}

TEST(Siemens840dWriter, WritesRapidsAsLinesOnRequest) {
  machine::Options options = bare_with("rapid_as_line", true);
  options["rapid_feed_mm_min"] = 15000.0;

  EXPECT_EQ(body(MotionCase{"XYZ"}.rapid({1, 0, 0}).motion, options), "G1 X1 Y0 Z0 F15000\n");
}

TEST(Siemens840dWriter, WritesTheDecimalsOfInverseTimeThatTheShopWants) {
  machine::Options options = bare_with("inverse_time_decimals", 1.0);
  options["largest_inverse_time"] = 500.0;
  const auto motion =
      MotionCase{"XYZC"}.inverse({1, 0, 0, 5}, 12.59).inverse({2, 0, 0, 9}, 501.0).motion;

  EXPECT_EQ(body(motion, options), "G93 G1 X1 Y0 Z0 C5 F12.5\nX2 C9 F500\n");
}

TEST(Siemens840dWriter, WritesTheCoolantCodesOfTheShop) {
  using State = path::Coolant::State;
  const auto motion = MotionCase{}
                          .act(path::Coolant{State::mist})
                          .act(path::Coolant{State::through})
                          .act(path::Coolant{})
                          .motion;

  EXPECT_EQ(body(motion, bare_with("coolant_through", std::string{"M88"})), "M7\nM88\nM9\n");
}

TEST(Siemens840dWriter, RefusesOptionsOutsideTheirDomain) {
  const auto refused = [](const std::string& name, machine::OptionValue value) {
    const auto abilities = nc::find_dialect("siemens-840d")->abilities({{name, std::move(value)}});
    return !abilities.has_value() && abilities.error().message.find(name) != std::string::npos;
  };
  EXPECT_TRUE(refused("edge", 13.0));
  EXPECT_TRUE(refused("edge_after_tool_change", -1.0));
  EXPECT_TRUE(refused("shortest_way_axes", std::string{"C="}));
  EXPECT_TRUE(refused("program_lines", Lines{"%_N_{program}_MPF"}));
  EXPECT_TRUE(refused("inverse_time_decimals", 5.0));
  EXPECT_TRUE(refused("largest_inverse_time", 0.0));
}

TEST(Siemens840dWriter, SaysWhatTheControlCan) {
  const auto* const dialect = nc::find_dialect("siemens-840d");
  const auto usual = dialect->abilities({});
  ASSERT_TRUE(usual.has_value());
  EXPECT_TRUE(usual->inverse_time && usual->arcs && usual->helices && usual->native_cycles);
  EXPECT_FALSE(usual->arcs_with_tcp || usual->retracts_with_tcp || usual->adds_length_always);
  const auto other = dialect->abilities({{"arcs_with_tcp", true}, {"native_cycles", false}});
  ASSERT_TRUE(other.has_value());
  EXPECT_TRUE(other->arcs_with_tcp);
  EXPECT_FALSE(other->native_cycles);
  EXPECT_FALSE(dialect->abilities({{"arcs_with_tcp", true}, {"arcs", false}})->arcs_with_tcp);
}

}  // namespace
}  // namespace pentapost
