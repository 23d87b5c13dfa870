#include "lib/nc/writer_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace pentapost {
namespace {

using sample::bare_with;
using sample::MotionCase;
using sample::heidenhain::body;
using Kind = path::Block::Kind;

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

TEST(HeidenhainIsoWriter, StatesTheFeedAgainAfterADwell) {
  const auto motion =
      MotionCase{"XYZ"}.line({1, 0, 0}, 100.0).act(path::Dwell{2.0}).line({2, 0, 0}, 100.0).motion;

  EXPECT_EQ(body(motion),
            "N10 G01 X+1 Y+0 Z+0 F100 *\n"
            "N20 G04 F2 *\n"
            "N30 G01 X+2 Y+0 Z+0 F100 *\n");
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

TEST(HeidenhainIsoWriter, WritesAHundredThousandBlocksWithoutLosingOne) {
  MotionCase many;
  for (int i = 0; i < 100'000; ++i) many.line({i * 0.001, 0, -8, 11, 360}, 2000.0);

  const std::string nc = body(many.motion);

  EXPECT_EQ(std::ranges::count(nc, '\n'), 100'000);
  EXPECT_TRUE(nc.ends_with("N1000000 X+99.999 Y+0 Z-8 A+11 C+360 *\n"));
}

}  // namespace
}  // namespace pentapost
