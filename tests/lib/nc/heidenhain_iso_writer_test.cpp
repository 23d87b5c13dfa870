#include "lib/nc/writer_case.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pentapost {
namespace {

using sample::bare_with;
using sample::MotionCase;
using sample::heidenhain::body;
using Lines = std::vector<std::string>;

TEST(HeidenhainIsoWriter, WritesAWholeProgram) {
  const auto motion = MotionCase{}
                          .act(path::SafeRetract{})
                          .act(path::ToolCall{.number = 5, .speed_rpm = 12000.0, .name = "BALL D8"})
                          .act(path::Spindle{path::Spindle::State::clockwise, 12000.0})
                          .act(path::Coolant{path::Coolant::State::flood})
                          .rapid({0, 0, 0, 22.586, 333.177})
                          .stating(0x18)
                          .act(path::TcpOn{})
                          .rapid({50, 50, 100, 22.586, 333.177})
                          .line({50, 50, -8, 22.586, 333.177}, 2000.0)
                          .act(path::TcpOff{})
                          .act(path::SafeRetract{})
                          .act(path::Spindle{})
                          .act(path::Coolant{})
                          .act(path::ProgramEnd{})
                          .motion;

  const std::string nc =
      sample::program("heidenhain-iso", motion, {},
                      sample::named("non_sing", "hermle-c600u@1.0.0", "0123456789ab"));

  EXPECT_EQ(nc,
            "%NON_SING G71 *\n"
            "N10 G90 *\n"
            "N20 ; PROGRAM non_sing *\n"
            "N30 ; MACHINE hermle-c600u@1.0.0 *\n"
            "N40 ; DEFINITION 0123456789ab *\n"
            "N50 ; UNITS MM *\n"
            "N60 ; OUTPUT TCP *\n"
            "N70 M140 MB MAX *\n"
            "N80 ; BALL D8 *\n"
            "N90 T5 G17 S12000 *\n"
            "N100 M3 *\n"
            "N110 M8 *\n"
            "N120 G00 A+22.586 C+333.177 *\n"
            "N130 M128 *\n"
            "N140 G00 X+50 Y+50 Z+100 A+22.586 C+333.177 *\n"
            "N150 G01 X+50 Y+50 Z-8 A+22.586 C+333.177 F2000 *\n"
            "N160 M129 *\n"
            "N170 M140 MB MAX *\n"
            "N180 M5 *\n"
            "N190 M9 *\n"
            "N200 M30 *\n"
            "N99999999 %NON_SING G71 *\n");
}

TEST(HeidenhainIsoWriter, SaysThatItHasNeitherInverseTimeNorCyclesNorHelices) {
  const auto abilities = nc::find_dialect("heidenhain-iso")->abilities({});

  ASSERT_TRUE(abilities.has_value());
  EXPECT_FALSE(abilities->inverse_time);
  EXPECT_FALSE(abilities->native_cycles);
  EXPECT_FALSE(abilities->helices);
  EXPECT_TRUE(abilities->arcs);
}

TEST(HeidenhainIsoWriter, WritesArcsWithTcpOnRequestOnly) {
  const auto* dialect = nc::find_dialect("heidenhain-iso");
  EXPECT_FALSE(dialect->abilities({})->arcs_with_tcp);
  EXPECT_TRUE(dialect->abilities({{"arcs_with_tcp", true}})->arcs_with_tcp);
  EXPECT_FALSE(dialect->abilities({{"arcs_with_tcp", true}, {"arcs", false}})->arcs_with_tcp);
}

TEST(HeidenhainIsoWriter, HasNoOptionForNativeCycles) {
  EXPECT_FALSE(
      nc::find_dialect("heidenhain-iso")->abilities({{"native_cycles", true}}).has_value());
}

TEST(HeidenhainIsoWriter, SpeaksTheSpindleWithTheToolCall) {
  using State = path::Spindle::State;
  const auto motion = MotionCase{"XYZ"}
                          .act(path::ToolCall{.number = 5})
                          .act(path::Spindle{State::clockwise, 800.4})
                          .act(path::Spindle{State::counterclockwise, {}})
                          .act(path::ToolCall{.number = 6, .speed_rpm = 800.0})
                          .act(path::Spindle{State::clockwise, 800.0})
                          .act(path::Spindle{State::clockwise, 900.0})
                          .motion;

  EXPECT_EQ(body(motion),
            "N10 T5 G17 *\n"
            "N20 S800 M3 *\n"
            "N30 M4 *\n"
            "N40 T6 G17 S800 *\n"
            "N50 M3 *\n"
            "N60 S900 M3 *\n");
}

TEST(HeidenhainIsoWriter, SaysTheSpeedAgainWhereTextOrAStopMayHaveChangedIt) {
  const path::ActionKind changes[] = {path::InsertedText{"S100 M3"}, path::Stop{}};
  for (const auto& change : changes) {
    const auto motion = MotionCase{"XYZ"}
                            .act(path::ToolCall{.number = 5, .speed_rpm = 800.0})
                            .act(change)
                            .act(path::Spindle{path::Spindle::State::clockwise, 800.0})
                            .motion;
    const std::string nc = body(motion);
    EXPECT_TRUE(nc.ends_with("N30 S800 M3 *\n")) << nc;
  }
}

TEST(HeidenhainIsoWriter, DoesNotTakeTheSpeedOfAStandingSpindleForSaid) {
  using State = path::Spindle::State;
  const auto motion = MotionCase{"XYZ"}
                          .act(path::Spindle{State::off, 800.0})
                          .act(path::Spindle{State::clockwise, 800.0})
                          .motion;

  EXPECT_EQ(body(motion), "N10 M5 *\nN20 S800 M3 *\n");
}

TEST(HeidenhainIsoWriter, SaysTheSpeedLaterWhereTheToolCallOfTheShopHasNone) {
  const auto motion = MotionCase{"XYZ"}
                          .act(path::ToolCall{.number = 5, .speed_rpm = 800.0})
                          .act(path::Spindle{path::Spindle::State::clockwise, 800.0})
                          .motion;

  EXPECT_EQ(body(motion, bare_with("tool_change", Lines{"T{tool} G17", "M06"})),
            "N10 T5 G17 *\n"
            "N20 M06 *\n"
            "N30 S800 M3 *\n");
}

TEST(HeidenhainIsoWriter, WritesStopsDwellsAndComments) {
  const auto motion = MotionCase{"XYZ"}
                          .act(path::Stop{false})
                          .act(path::Stop{true})
                          .act(path::Dwell{2.5})
                          .act(path::Dwell{0.0001})
                          .act(path::Comment{"Fl\xC3\xA4"
                                             "che 50% *2"})
                          .act(path::InsertedText{"G62 T0.01 *"})
                          .motion;

  EXPECT_EQ(body(motion, {{"start_lines", Lines{}}}),
            "N10 ; UNITS MM *\n"
            "N20 ; OUTPUT TCP *\n"
            "N30 M00 *\n"
            "N40 M01 *\n"
            "N50 G04 F2.5 *\n"
            "N60 G04 F0.001 *\n"
            "N70 ; Flaeche 50 2 *\n"
            "G62 T0.01 *\n");
}

TEST(HeidenhainIsoWriter, MakesABlockOfInsertedTextThatIsNone) {
  const auto motion = MotionCase{"XYZ"}
                          .act(path::InsertedText{"M8"})
                          .act(path::InsertedText{"N7 M9 *"})
                          .act(path::Stop{})
                          .motion;

  EXPECT_EQ(body(motion, {{"start_lines", Lines{}}}),
            "N10 ; UNITS MM *\n"
            "N20 ; OUTPUT TCP *\n"
            "N30 M8 *\n"
            "N7 M9 *\n"
            "N40 M00 *\n");
}

TEST(HeidenhainIsoWriter, RefusesADwellOfMoreThanAnHour) {
  const auto motion = MotionCase{}.act(path::Dwell{3601.0}).motion;

  EXPECT_EQ(sample::refused("heidenhain-iso", motion).code, Code::out_of_domain);
}

TEST(HeidenhainIsoWriter, BreaksLongCommentsAtBlanks) {
  const auto motion =
      MotionCase{}.act(path::Comment{std::string(50, 'A') + " " + std::string(70, 'B')}).motion;

  const std::string nc = sample::program("heidenhain-iso", motion);

  EXPECT_NE(nc.find("; " + std::string(50, 'A') + " *\n"), std::string::npos);
  EXPECT_NE(nc.find("; " + std::string(60, 'B') + " *\n"), std::string::npos);
  EXPECT_NE(nc.find("; " + std::string(10, 'B') + " *\n"), std::string::npos);
}

TEST(HeidenhainIsoWriter, TakesTheShopsLines) {
  machine::Options options;
  options["comments"] = false;
  options["start_lines"] = Lines{"G90", "M126"};
  options["end_lines"] = Lines{"G54 X+0 Y+0 Z+0", "M30"};
  options["tcp_on"] = Lines{"M126", "M128 F5000"};
  options["tcp_off"] = Lines{"M129", "M127"};
  options["safe_retract"] = Lines{"G00 Z+0 M91"};
  options["smoothing_on"] = Lines{"G62 T0.01 P01 0 P02 0.5"};
  options["smoothing_off"] = Lines{"G62"};
  options["closing_number"] = 999999.0;
  const auto motion = MotionCase{"XYZ"}
                          .act(path::SafeRetract{})
                          .act(path::TcpOn{})
                          .line({1, 0, 0}, 10.0)
                          .act(path::TcpOff{})
                          .act(path::ProgramEnd{})
                          .motion;

  EXPECT_EQ(sample::program("heidenhain-iso", motion, options, sample::named("SING")),
            "%SING G71 *\n"
            "N10 G90 *\n"
            "N20 M126 *\n"
            "N30 G00 Z+0 M91 *\n"
            "N40 G62 T0.01 P01 0 P02 0.5 *\n"
            "N50 M126 *\n"
            "N60 M128 F5000 *\n"
            "N70 G01 X+1 Y+0 Z+0 F10 *\n"
            "N80 M129 *\n"
            "N90 M127 *\n"
            "N100 G62 *\n"
            "N110 G54 X+0 Y+0 Z+0 *\n"
            "N120 M30 *\n"
            "N999999 %SING G71 *\n");
}

TEST(HeidenhainIsoWriter, SmoothsBetweenApproachAndRetractWithoutTcp) {
  machine::Options options = bare_with("smoothing_on", Lines{"ON"});
  options["smoothing_off"] = Lines{"OFF"};
  const auto motion = MotionCase{"XYZC", Output::axes}
                          .act(path::SafeRetract{})
                          .rapid({0, 0, 0, 9})
                          .stating(0x08)
                          .line({1, 0, 0, 9}, 10.0)
                          .line({2, 0, 0, 9}, 10.0)
                          .act(path::SafeRetract{})
                          .act(path::ProgramEnd{})
                          .motion;

  EXPECT_EQ(body(motion, options),
            "N10 M140 MB MAX *\n"
            "N20 G00 C+9 *\n"
            "N30 ON *\n"
            "N40 G01 X+1 Y+0 Z+0 C+9 F10 *\n"
            "N50 X+2 Y+0 Z+0 C+9 *\n"
            "N60 M140 MB MAX *\n"
            "N70 OFF *\n"
            "N80 M30 *\n");
}

TEST(HeidenhainIsoWriter, WritesTheCoolantCodesOfTheShop) {
  using State = path::Coolant::State;
  machine::Options options = bare_with("coolant_through", std::string{"M50"});
  options["coolant_air"] = std::string{"M25"};
  const auto motion = MotionCase{}
                          .act(path::Coolant{State::flood})
                          .act(path::Coolant{State::mist})
                          .act(path::Coolant{State::through})
                          .act(path::Coolant{State::air})
                          .act(path::Coolant{State::off})
                          .motion;

  EXPECT_EQ(body(motion, options),
            "N10 M8 *\n"
            "N20 M7 *\n"
            "N30 M50 *\n"
            "N40 M25 *\n"
            "N50 M9 *\n");
}

TEST(HeidenhainIsoWriter, LeavesBlockNumbersOutOnRequest) {
  const auto motion = MotionCase{"XYZ"}.line({1, 0, 0}, 10.0).motion;

  EXPECT_EQ(sample::program("heidenhain-iso", motion, bare_with("block_numbers", false)),
            "%PROGRAM G71 *\n"
            "G01 X+1 Y+0 Z+0 F10 *\n"
            "N99999999 %PROGRAM G71 *\n");
}

TEST(HeidenhainIsoWriter, CountsBlocksAsTheShopWants) {
  machine::Options options = bare_with("block_number_start", 1.0);
  options["block_number_step"] = 5.0;
  const auto motion = MotionCase{"XYZ"}.rapid({1, 0, 0}).rapid({2, 0, 0}).motion;

  EXPECT_EQ(body(motion, options), "N1 G00 X+1 Y+0 Z+0 *\nN6 X+2 Y+0 Z+0 *\n");
}

TEST(HeidenhainIsoWriter, NeverReachesTheClosingNumber) {
  MotionCase many{"XYZ"};
  for (int i = 0; i < 12; ++i) many.rapid({double(i), 0, 0});

  const std::string nc = body(many.motion, bare_with("closing_number", 100.0));

  EXPECT_NE(nc.find("N90 X+8 Y+0 Z+0 *\nN10 X+9 Y+0 Z+0 *\n"), std::string::npos) << nc;
}

TEST(HeidenhainIsoWriter, CleansTheProgramName) {
  const auto first_line = [](const std::string& name) {
    const auto nc =
        sample::program("heidenhain-iso", MotionCase{"XYZ"}.motion, {}, sample::named(name));
    return nc.substr(0, nc.find('\n'));
  };
  EXPECT_EQ(first_line("Blade 7 (rough).h"), "%BLADE_7_ROUGH_H G71 *");
  EXPECT_EQ(first_line("T\xC3\xBCr-1"), "%TUER-1 G71 *");
  EXPECT_EQ(first_line(""), "%PROGRAM G71 *");
  EXPECT_EQ(first_line("  ** "), "%PROGRAM G71 *");
  EXPECT_EQ(first_line("../../etc/passwd"), "%ETC_PASSWD G71 *");
  EXPECT_EQ(first_line("ABCDEFGHIJKLMNOPQRSTUVWXYZ"), "%ABCDEFGHIJKLMNOP G71 *");
}

TEST(HeidenhainIsoWriter, TakesLongerNamesOnRequest) {
  const auto nc =
      sample::program("heidenhain-iso", MotionCase{"XYZ"}.motion, {{"program_name_length", 24.0}},
                      sample::named("ABCDEFGHIJKLMNOPQRSTUVWXYZ"));

  EXPECT_EQ(nc.substr(0, nc.find('\n')), "%ABCDEFGHIJKLMNOPQRSTUVWX G71 *");
}

}  // namespace
}  // namespace pentapost
