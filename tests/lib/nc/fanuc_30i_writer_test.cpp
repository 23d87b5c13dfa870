#include "lib/nc/read_items.hpp"
#include "lib/nc/writer_case.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace pentapost {
namespace {

using sample::bare_with;
using sample::MotionCase;
using sample::fanuc::body;
using Lines = std::vector<std::string>;

TEST(Fanuc30iWriter, WritesAWholeProgramWithTcp) {
  const auto motion = MotionCase{"XYZBC"}
                          .act(path::SafeRetract{})
                          .act(path::ToolCall{.number = 5, .name = "Ball D8"})
                          .act(path::Spindle{path::Spindle::State::clockwise, 12000.0})
                          .act(path::Coolant{path::Coolant::State::flood})
                          .rapid({0, 0, 0, 30, -45})
                          .stating(0x18)
                          .act(path::TcpOn{})
                          .rapid({50, 50, 100, 30, -45})
                          .line({50, 50, -8, 30, -45}, 2000.0)
                          .line({49, 50, -8, 30.5, -45}, 2000.0)
                          .act(path::TcpOff{})
                          .act(path::SafeRetract{})
                          .act(path::Spindle{})
                          .act(path::Coolant{})
                          .act(path::ProgramEnd{})
                          .motion;

  const std::string nc = sample::program(
      "fanuc-30i", motion, {}, sample::named("Demo (1)", "haas-umc-750@1.0.0", "0123456789ab"));

  EXPECT_EQ(nc,
            "%\n"
            "O0001 (DEMO 1)\n"
            "(PROGRAM DEMO 1)\n"
            "(MACHINE HAAS-UMC-750@1.0.0)\n"
            "(DEFINITION 0123456789AB)\n"
            "(UNITS MM)\n"
            "(OUTPUT TCP)\n"
            "G90 G94 G17 G21 G49 G40 G80\n"
            "G54\n"
            "G91 G28 Z0.\n"
            "G90\n"
            "(BALL D8)\n"
            "T5 M6\n"
            "S12000 M3\n"
            "M8\n"
            "G0 B30. C-45.\n"
            "G43.4 H5\n"
            "G0 X50. Y50. Z100. B30. C-45.\n"
            "G1 Z-8. F2000.\n"
            "X49. B30.5\n"
            "G49\n"
            "G91 G28 Z0.\n"
            "G90\n"
            "M5\n"
            "M9\n"
            "M30\n"
            "%\n");
}

TEST(Fanuc30iWriter, SwitchesTheToolLengthOnWithTheFirstZOfAxesOutput) {
  const auto motion = MotionCase{"XYZBC", Output::axes}
                          .act(path::SafeRetract{})
                          .act(path::ToolCall{.number = 5, .length_register = 25})
                          .rapid({0, 0, 0, 30, -45})
                          .stating(0x18)
                          .rapid({1, 2, 0, 30, -45})
                          .stating(0x03)
                          .rapid({1, 2, 3, 30, -45})
                          .rapid({1, 2, 4, 30, -45})
                          .act(path::SafeRetract{})
                          .rapid({1, 2, 4, 30, -45})
                          .motion;

  EXPECT_EQ(body(motion),
            "G91 G28 Z0.\n"
            "G90\n"
            "T5 M6\n"
            "G0 B30. C-45.\n"
            "X1. Y2.\n"
            "G43 Z3. H25\n"
            "Z4.\n"
            "G91 G28 Z0.\n"
            "G90\n"
            "G49\n"
            "G0 G43 X1. Y2. Z4. B30. C-45. H25\n");
}

TEST(Fanuc30iWriter, WritesNoToolLengthWhereTheWordsHoldIt) {
  MotionCase head{"XYZCA", Output::axes};
  head.motion.length_offset = false;
  head.rapid({1, 2, 3, 4, 5}).act(path::SafeRetract{});

  EXPECT_EQ(body(head.motion),
            "G0 X1. Y2. Z3. A5. C4.\n"
            "G91 G28 Z0.\n"
            "G90\n");
}

TEST(Fanuc30iWriter, TakesTheRegisterOfToolOneWhereNoToolIsCalled) {
  EXPECT_EQ(body(MotionCase{}.act(path::TcpOn{}).motion), "G43.4 H1\n");
}

TEST(Fanuc30iWriter, WritesSpindleStopsAndDwells) {
  using State = path::Spindle::State;
  const auto motion = MotionCase{"XYZ"}
                          .act(path::Spindle{State::clockwise, 12000.4})
                          .act(path::Spindle{State::counterclockwise, {}})
                          .act(path::Spindle{})
                          .act(path::Stop{false})
                          .act(path::Stop{true})
                          .act(path::Dwell{1.5})
                          .act(path::Dwell{0.0001})
                          .motion;

  EXPECT_EQ(body(motion),
            "S12000 M3\n"
            "M4\n"
            "M5\n"
            "M0\n"
            "M1\n"
            "G4 P1500\n"
            "G4 P1\n");
  EXPECT_TRUE(
      body(motion, bare_with("dwell_word", std::string{"X"})).ends_with("G4 X1.5\nG4 X0.001\n"));
}

TEST(Fanuc30iWriter, RefusesAnotherDwellWord) {
  EXPECT_FALSE(
      nc::find_dialect("fanuc-30i")->abilities({{"dwell_word", std::string{"U"}}}).has_value());
}

TEST(Fanuc30iWriter, RefusesSpeedsAndDwellsWithoutEnd) {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto spindle =
      MotionCase{}.act(path::Spindle{path::Spindle::State::clockwise, infinity}).motion;
  EXPECT_EQ(sample::refused("fanuc-30i", spindle).code, Code::out_of_domain);
  EXPECT_EQ(sample::refused("fanuc-30i", MotionCase{}.act(path::Dwell{1e9}).motion).code,
            Code::out_of_domain);
}

TEST(Fanuc30iWriter, KeepsBracketsAndPercentOutOfComments) {
  const auto motion = MotionCase{}
                          .act(path::Comment{"50% (Fl\xC3\xA4"
                                             "che) \xE2\x82\xAC"})
                          .act(path::Comment{" () "})
                          .motion;

  EXPECT_EQ(body(motion, {{"start_lines", Lines{}}}),
            "(UNITS MM)\n"
            "(OUTPUT TCP)\n"
            "(50 FLAECHE ?)\n");
}

/// The line of a program's number.
std::string number_line(const std::string& name, const machine::Options& options = {}) {
  const auto nc =
      sample::program("fanuc-30i", MotionCase{"XYZ"}.motion, options, sample::named(name));
  return nc.substr(2, nc.find('\n', 2) - 2);
}

TEST(Fanuc30iWriter, NumbersTheProgramWithFourDigits) {
  EXPECT_EQ(number_line("Demo"), "O0001 (DEMO)");
  EXPECT_EQ(number_line("", {{"program_number", 1001.0}}), "O1001");
  EXPECT_EQ(number_line("a)\n%\nO2(b", {{"program_number", 42.0}}), "O0042 (A  O2B)");
}

TEST(Fanuc30iWriter, TakesANameThatIsANumberForTheProgramNumber) {
  const machine::Options options{{"program_number", 42.0}};
  EXPECT_EQ(number_line("1001", options), "O1001");
  EXPECT_EQ(number_line("O1001", options), "O1001");
  EXPECT_EQ(number_line("o7", options), "O0007");
  EXPECT_EQ(number_line("0012", options), "O0012");
  EXPECT_EQ(number_line("8999", options), "O8999");
}

// O9000 and up are locked against change on most controls.
TEST(Fanuc30iWriter, KeepsANameThatIsNoFreeNumberAsAComment) {
  const machine::Options options{{"program_number", 42.0}};
  for (const char* const name : {"0", "O0000", "9000", "O9999", "10000", "00012", "O", "-12",
                                 "1001A", "1001.5", "OO12", "12 34", "O 12"}) {
    EXPECT_EQ(number_line(name, options), std::string{"O0042 ("} + name + ")");
  }
}

TEST(Fanuc30iWriter, WritesANumberThatTheReaderTakes) {
  const auto motion = MotionCase{"XYZ"}.rapid({1, 2, 3}).act(path::ProgramEnd{}).motion;
  const auto nc = sample::program("fanuc-30i", motion, {}, sample::named("1001"));

  EXPECT_EQ(sample::read_items("fanuc-30i", nc, "XYZ").message(), "");
}

TEST(Fanuc30iWriter, RefusesProgramNumbersThatTheControlHasNot) {
  for (const double bad : {0.0, 10000.0, 1.5, -1.0})
    EXPECT_FALSE(nc::find_dialect("fanuc-30i")->abilities({{"program_number", bad}}).has_value());
}

TEST(Fanuc30iWriter, NumbersBlocksOnRequest) {
  machine::Options options = bare_with("block_numbers", true);
  options["block_number_step"] = 1.0;
  options["comments"] = true;
  const auto motion = MotionCase{"XYZ"}
                          .rapid({1, 0, 0})
                          .act(path::Comment{"here"})
                          .rapid({2, 0, 0})
                          .act(path::ProgramEnd{})
                          .motion;

  EXPECT_EQ(body(motion, options),
            "(UNITS MM)\n"
            "(OUTPUT TCP)\n"
            "N10 G0 X1. Y0. Z0.\n"
            "(HERE)\n"
            "N11 X2.\n"
            "N12 M30\n");
}

TEST(Fanuc30iWriter, StartsBlockNumbersAgainAfterFiveDigits) {
  machine::Options options = bare_with("block_numbers", true);
  options["block_number_start"] = 9999.0;
  options["block_number_step"] = 1000.0;
  MotionCase many{"XYZ"};
  for (int i = 0; i < 100; ++i) many.rapid({double(i), 0, 0});

  const std::string nc = body(many.motion, options);

  EXPECT_NE(nc.find("\nN99999 X90.\nN9999 X91.\n"), std::string::npos) << nc;
}

TEST(Fanuc30iWriter, SmoothsOutsideTheToolLength) {
  machine::Options options = bare_with("smoothing_on", Lines{"G05.1 Q1"});
  options["smoothing_off"] = Lines{"G05.1 Q0"};
  const auto with_tcp = MotionCase{"XYZ"}
                            .act(path::TcpOn{})
                            .line({1, 0, 0}, 10.0)
                            .act(path::TcpOff{})
                            .act(path::SafeRetract{})
                            .motion;
  EXPECT_EQ(body(with_tcp, options),
            "G05.1 Q1\nG43.4 H1\nG1 X1. Y0. Z0. F10.\nG49\nG05.1 Q0\nG91 G28 Z0.\nG90\n");

  const auto with_axes = MotionCase{"XYZ", Output::axes}
                             .rapid({1, 0, 5})
                             .line({1, 0, 0}, 10.0)
                             .act(path::SafeRetract{})
                             .act(path::ProgramEnd{})
                             .motion;
  EXPECT_EQ(body(with_axes, options),
            "G05.1 Q1\nG0 G43 X1. Y0. Z5. H1\nG1 Z0. F10.\n"
            "G91 G28 Z0.\nG90\nG49\nG05.1 Q0\nM30\n");
}

TEST(Fanuc30iWriter, TakesTheShopsLines) {
  machine::Options options;
  options["comments"] = false;
  options["start_lines"] = Lines{"G90 G94 G17 G21", "G54"};
  options["end_lines"] = Lines{"G91 G28 X0. Y0.", "G90", "M30"};
  options["safe_retract"] = Lines{"G53 G0 Z0."};
  options["tool_change"] = Lines{"T{tool}", "M6", "(S IS {speed})"};
  options["tcp_on"] = Lines{"G43.4 H{register} P1"};
  options["tcp_off"] = Lines{"G49", "M100"};
  const auto motion = MotionCase{"XYZ"}
                          .act(path::SafeRetract{})
                          .act(path::ToolCall{.number = 12, .speed_rpm = 500.0})
                          .act(path::TcpOn{})
                          .act(path::TcpOff{})
                          .act(path::ProgramEnd{})
                          .motion;

  EXPECT_EQ(sample::program("fanuc-30i", motion, options),
            "%\nO0001\nG90 G94 G17 G21\nG54\nG53 G0 Z0.\nT12\nM6\n(S IS S500)\n"
            "G43.4 H12 P1\nG49\nM100\nG91 G28 X0. Y0.\nG90\nM30\n%\n");
}

TEST(Fanuc30iWriter, SaysWhatItCan) {
  const auto abilities = nc::find_dialect("fanuc-30i")->abilities({});

  ASSERT_TRUE(abilities.has_value());
  EXPECT_TRUE(abilities->inverse_time);
  EXPECT_EQ(abilities->largest_inverse_time, 9999.999);  // B-62764EN, inverse time feed
  EXPECT_TRUE(abilities->native_cycles);
  EXPECT_TRUE(abilities->arcs);
  EXPECT_TRUE(abilities->helices);
  EXPECT_FALSE(abilities->arcs_with_tcp);
}

TEST(Fanuc30iWriter, LeavesCyclesToTheShop) {
  const auto abilities =
      nc::find_dialect("fanuc-30i")->abilities({{"native_cycles", false}, {"arcs_with_tcp", true}});

  ASSERT_TRUE(abilities.has_value());
  EXPECT_FALSE(abilities->native_cycles);
  EXPECT_TRUE(abilities->arcs_with_tcp);
}

}  // namespace
}  // namespace pentapost
