#include "lib/nc/writer_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

namespace pentapost {
namespace {

using sample::MotionCase;
using Kind = path::Block::Kind;
using Lines = std::vector<std::string>;

const machine::Options bare{{"comments", false}, {"start_lines", Lines{}}};

machine::Options bare_with(const std::string& name, machine::OptionValue value) {
  machine::Options options = bare;
  options[name] = std::move(value);
  return options;
}

/// What stands between the first and the last line.
std::string body(const path::Motion& motion, const machine::Options& options = bare) {
  const std::string nc = sample::program("heidenhain-iso", motion, options);
  const auto first = nc.find('\n') + 1;
  return nc.substr(first, nc.rfind('N') - first);
}

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

// Cripps et al. 2017, Appendix 1, N110 to N180, N360, N370 and N620.
TEST(HeidenhainIsoWriter, SpellsTheBlocksOfThePublishedProgram) {
  const auto motion = MotionCase{}
                          .line({50, 50, -8, 23.162, 333.802}, 2000.0)
                          .line({49, 50, -8, 22.586, 333.177}, 2000.0)
                          .line({48, 50, -8, 21.998, 332.617}, 2000.0)
                          .line({47, 50, -8, 21.4, 332.129}, 2000.0)
                          .line({25, 50, -8, 11, 360}, 2000.0)
                          .line({24, 50, -8, 11.037, 363.265}, 2000.0)
                          .line({0, 70, -8, 23.162, 386.198}, 2000.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "N10 G01 X+50 Y+50 Z-8 A+23.162 C+333.802 F2000 *\n"
            "N20 X+49 Y+50 Z-8 A+22.586 C+333.177 *\n"
            "N30 X+48 Y+50 Z-8 A+21.998 C+332.617 *\n"
            "N40 X+47 Y+50 Z-8 A+21.4 C+332.129 *\n"
            "N50 X+25 Y+50 Z-8 A+11 C+360 *\n"
            "N60 X+24 Y+50 Z-8 A+11.037 C+363.265 *\n"
            "N70 X+0 Y+70 Z-8 A+23.162 C+386.198 *\n");
}

/// Reads "N120 X+49 Y+50 ... *" the plain way.
bool read_published_block(const std::string& line, std::array<double, 5>& words) {
  return std::sscanf(line.c_str(), "N%*d X%lf Y%lf Z%lf A%lf C%lf *", &words[0], &words[1],
                     &words[2], &words[3], &words[4]) == 5;
}

TEST(HeidenhainIsoWriter, RepeatsBothPublishedProgramsWordByWord) {
  for (const std::string name : {"cripps-2017-appendix-1.nc", "cripps-2017-appendix-2.nc"}) {
    std::ifstream file{std::string{PENTAPOST_TESTS_DIR} + "/data/papers/" + name};
    ASSERT_TRUE(file) << name;
    MotionCase published;
    std::vector<std::string> expected;
    for (std::string line; std::getline(file, line);) {
      while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
      std::array<double, 5> words{};
      if (!read_published_block(line, words)) continue;
      published.line({words[0], words[1], words[2], words[3], words[4]}, 2000.0);
      expected.push_back(line.substr(line.find(' ')));
    }
    ASSERT_EQ(expected.size(), 55u) << name;  // N80 to N620

    std::istringstream written{body(published.motion)};
    std::size_t i = 0;
    for (std::string line; std::getline(written, line); ++i) {
      if (i == 0) continue;  // G01 and F stand here as well
      EXPECT_EQ(line.substr(line.find(' ')), expected.at(i)) << name;
    }
    EXPECT_EQ(i, 55u);
  }
}

TEST(HeidenhainIsoWriter, WritesWordsInTheOrderXyzAbc) {
  const auto motion = MotionCase{"ZYXCA"}.line({1, 2, 3, 4, 5}, 100.0).motion;

  EXPECT_EQ(body(motion), "N10 G01 X+3 Y+2 Z+1 A+5 C+4 F100 *\n");
}

TEST(HeidenhainIsoWriter, WritesThreeAxes) {
  const auto motion = MotionCase{"XYZ"}.line({1, -2.5, 0.001}, 100.0).motion;

  EXPECT_EQ(body(motion), "N10 G01 X+1 Y-2.5 Z+0.001 F100 *\n");
}

TEST(HeidenhainIsoWriter, SpellsNumbersSignedAndTrimmed) {
  const auto motion = MotionCase{}
                          .line({-0.5, 0.05, 100, -1000.25, 99999.999}, 1.0)
                          .line({0, -0.0001, 10, 0.999, -99999.999}, 1.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "N10 G01 X-0.5 Y+0.05 Z+100 A-1000.25 C+99999.999 F1 *\n"
            "N20 X+0 Y+0 Z+10 A+0.999 C-99999.999 *\n");
}

TEST(HeidenhainIsoWriter, WritesAsManyDecimalsAsTheMotionHas) {
  MotionCase fine;
  fine.motion.decimals_mm = 4;
  fine.motion.decimals_deg = 5;
  fine.line({1.2345, 0, 0, 1.23456, 0}, 100.0);

  EXPECT_EQ(body(fine.motion), "N10 G01 X+1.2345 Y+0 Z+0 A+1.23456 C+0 F100 *\n");
}

TEST(HeidenhainIsoWriter, StatesTheMotionCodeAndFeedWhereTheyChange) {
  const auto motion = MotionCase{"XYZ"}
                          .line({1, 0, 0}, 100.0)
                          .line({2, 0, 0}, 100.0)
                          .line({3, 0, 0}, 200.0)
                          .rapid({4, 0, 0})
                          .rapid({5, 0, 0})
                          .line({6, 0, 0}, 200.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "N10 G01 X+1 Y+0 Z+0 F100 *\n"
            "N20 X+2 Y+0 Z+0 *\n"
            "N30 X+3 Y+0 Z+0 F200 *\n"
            "N40 G00 X+4 Y+0 Z+0 *\n"
            "N50 X+5 Y+0 Z+0 *\n"
            "N60 G01 X+6 Y+0 Z+0 *\n");
}

TEST(HeidenhainIsoWriter, RoundsFeedsDownButNotToZero) {
  const auto motion = MotionCase{"XYZ"}
                          .line({1, 0, 0}, 1999.9999)
                          .line({2, 0, 0}, 0.00025)
                          .line({3, 0, 0}, 1999.9999999999998)
                          .line({4, 0, 0}, 2000.0000001)
                          .motion;

  const std::string nc = body(motion);

  EXPECT_EQ(nc,
            "N10 G01 X+1 Y+0 Z+0 F1999.999 *\n"
            "N20 X+2 Y+0 Z+0 F0.001 *\n"
            "N30 X+3 Y+0 Z+0 F2000 *\n"
            "N40 X+4 Y+0 Z+0 *\n");
}

TEST(HeidenhainIsoWriter, WritesFeedDecimalsOnRequest) {
  const auto motion = MotionCase{"XYZ"}.line({1, 0, 0}, 88.97).motion;

  EXPECT_EQ(body(motion, bare_with("feed_decimals", 1.0)), "N10 G01 X+1 Y+0 Z+0 F88.9 *\n");
}

TEST(HeidenhainIsoWriter, LeavesOutWordsThatAreNotStated) {
  const auto motion = MotionCase{}
                          .rapid({0, 0, 0, 10, 20})
                          .stating(0x18)
                          .rapid({1, 2, 0, 10, 20})
                          .stating(0x03)
                          .rapid({1, 2, 3, 10, 20})
                          .stating(0x04)
                          .motion;

  EXPECT_EQ(body(motion),
            "N10 G00 A+10 C+20 *\n"
            "N20 X+1 Y+2 *\n"
            "N30 Z+3 *\n");
}

// iTNC 530 ISO programming, "Circle center I, J": N50 I+25 J+25 *, absolute in G90.
// HEIDENHAIN iTNC 530 user's manual DIN/ISO programming, "Circle center I, J": absolute in G90, in
// a block of its own before the arc's.
TEST(HeidenhainIsoWriter, GivesTheCircleCentreAsAnAbsolutePole) {
  const auto motion = MotionCase{"XYZ"}
                          .line({45, 25, -5}, 200.0)
                          .arc(Kind::arc_counterclockwise, {25, 45, -5}, -20, 0, 200.0)
                          .arc(Kind::arc_clockwise, {45, 25, -5}, 0, -20, 150.0)
                          .line({0, 0, -5}, 150.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "N10 G01 X+45 Y+25 Z-5 F200 *\n"
            "N20 I+25 J+25 *\n"
            "N30 G03 X+25 Y+45 *\n"
            "N40 I+25 J+25 *\n"
            "N50 G02 X+45 Y+25 F150 *\n"
            "N60 G01 X+0 Y+0 Z-5 *\n");
}

TEST(HeidenhainIsoWriter, WritesAFullCircleWithItsStartAsEnd) {
  const auto motion = MotionCase{"XYZ"}
                          .line({10, 0, 0}, 200.0)
                          .arc(Kind::arc_clockwise, {10, 0, 0}, -10, 0, 200.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "N10 G01 X+10 Y+0 Z+0 F200 *\n"
            "N20 I+0 J+0 *\n"
            "N30 G02 X+10 Y+0 *\n");
}

TEST(HeidenhainIsoWriter, RefusesAHelix) {
  MotionCase helix{"XYZ"};
  helix.next_line = 12;
  helix.line({10, 0, 0}, 200.0).arc(Kind::arc_clockwise, {10, 0, -1}, -10, 0, 200.0);

  const Problem problem = sample::refused("heidenhain-iso", helix.motion);

  EXPECT_EQ(problem.code, Code::not_in_dialect);
  EXPECT_EQ(problem.cl_line, 12u);
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

TEST(HeidenhainIsoWriter, TakesWhatItSaidItCannotForADefect) {
  EXPECT_THROW(body(MotionCase{"XYZ"}.inverse({1, 0, 0}, 10.0).motion), std::logic_error);
  EXPECT_THROW(body(MotionCase{"XYZ"}.act(path::NativeCycle{}).motion), std::logic_error);
  EXPECT_THROW(body(MotionCase{"XYZ"}.hole({1, 0, 0}).motion), std::logic_error);
  EXPECT_THROW(body(MotionCase{"XYZ"}.line({1, 0, 0}, 9.0).stating(0).motion), std::logic_error);
}

TEST(HeidenhainIsoWriter, TakesAnArcFromNowhereForADefect) {
  const auto from_nowhere = MotionCase{"XYZ"}.arc(Kind::arc_clockwise, {1, 0, 0}, 1, 0, 9.0).motion;
  EXPECT_THROW(body(from_nowhere), std::logic_error);

  const auto after_retract = MotionCase{"XYZ"}
                                 .line({0, 0, 0}, 9.0)
                                 .act(path::SafeRetract{})
                                 .arc(Kind::arc_clockwise, {1, 0, 0}, 1, 0, 9.0)
                                 .motion;
  EXPECT_THROW(body(after_retract), std::logic_error);
}

TEST(HeidenhainIsoWriter, StatesCodeAndFeedAgainAfterTheModeChanges) {
  const path::ActionKind changes[] = {path::TcpOn{},
                                      path::TcpOff{},
                                      path::SafeRetract{},
                                      path::Stop{},
                                      path::InsertedText{"L Z+0"},
                                      path::ToolCall{.number = 2}};
  for (const auto& change : changes) {
    const auto motion =
        MotionCase{"XYZ"}.line({1, 0, 0}, 100.0).act(change).line({1, 0, 0}, 100.0).motion;
    const std::string nc = body(motion);
    EXPECT_NE(nc.rfind("G01 X+1 Y+0 Z+0 F100 *\n"), nc.find("G01 X+1 Y+0 Z+0 F100 *\n")) << nc;
  }
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

TEST(HeidenhainIsoWriter, StatesTheFeedAgainAfterADwell) {
  const auto motion =
      MotionCase{"XYZ"}.line({1, 0, 0}, 100.0).act(path::Dwell{2.0}).line({2, 0, 0}, 100.0).motion;

  EXPECT_EQ(body(motion),
            "N10 G01 X+1 Y+0 Z+0 F100 *\n"
            "N20 G04 F2 *\n"
            "N30 G01 X+2 Y+0 Z+0 F100 *\n");
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

TEST(HeidenhainIsoWriter, WritesRapidsAsLinesOnRequest) {
  machine::Options options = bare_with("rapid_as_line", true);
  options["rapid_feed_mm_min"] = 15000.0;
  const auto motion =
      MotionCase{"XYZ"}.rapid({1, 0, 0}).line({2, 0, 0}, 100.0).rapid({3, 0, 0}).motion;

  EXPECT_EQ(body(motion, options),
            "N10 G01 X+1 Y+0 Z+0 F15000 *\n"
            "N20 X+2 Y+0 Z+0 F100 *\n"
            "N30 X+3 Y+0 Z+0 F15000 *\n");
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

// The control would add the length a second time.
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

TEST(HeidenhainIsoWriter, WritesAHundredThousandBlocksWithoutLosingOne) {
  MotionCase many;
  for (int i = 0; i < 100'000; ++i) many.line({i * 0.001, 0, -8, 11, 360}, 2000.0);

  const std::string nc = body(many.motion);

  EXPECT_EQ(std::ranges::count(nc, '\n'), 100'000);
  EXPECT_TRUE(nc.ends_with("N1000000 X+99.999 Y+0 Z-8 A+11 C+360 *\n"));
}

}  // namespace
}  // namespace pentapost
