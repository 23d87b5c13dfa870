#include "lib/nc/read_items.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace {

using namespace pentapost;
using nc::ReadMotion;
using Kind = nc::ReadMotion::Kind;

/// Reads `blocks` behind a start; the tool is at X0 Y0 Z100 A0 C0, and the feed is 200.
sample::ReadProgramItems read_after_start(std::string_view blocks) {
  return sample::read_items(
      "heidenhain-iso",
      "%TEST G71 *\nN10 G90 *\nN20 T5 G17 S12000 *\nN30 G00 X+0 Y+0 Z+100 A+0 "
      "C+0 F200 *\n" +
          std::string{blocks} + "\nN90 M30 *\nN99999999 %TEST G71 *\n");
}

std::vector<ReadMotion> motions_of(std::string_view blocks) {
  const auto read = read_after_start(blocks);
  EXPECT_EQ(read.message(), "");
  auto motions = read.motions();
  if (!motions.empty()) motions.erase(motions.begin());
  return motions;
}

ReadMotion last_motion(std::string_view blocks) {
  const auto motions = motions_of(blocks);
  EXPECT_FALSE(motions.empty());
  return motions.empty() ? ReadMotion{} : motions.back();
}

void expect_refused(std::string_view blocks, std::string_view word,
                    Code code = Code::not_in_dialect) {
  SCOPED_TRACE(blocks);
  const auto read = read_after_start(blocks);
  ASSERT_FALSE(read.status.has_value());
  EXPECT_NE(read.message().find(word), std::string::npos) << read.message();
  EXPECT_EQ(row_of(read.status.error().code).name, row_of(code).name);
}

std::string paper_program(int appendix) {
  std::ifstream file{std::string{PENTAPOST_TESTS_DIR} + "/data/papers/cripps-2017-appendix-" +
                     std::to_string(appendix) + ".nc"};
  EXPECT_TRUE(file.good());
  return {std::istreambuf_iterator<char>{file}, {}};
}

// Cripps et al. 2017, Appendices 1 and 2: 3 moves at the start, N70 to N620, 4 moves at the end.
TEST(HeidenhainIsoReader, ReadsTheProgramsOfThePaper) {
  for (const int appendix : {1, 2}) {
    SCOPED_TRACE(appendix);
    const auto read = sample::read_items("heidenhain-iso", paper_program(appendix));
    ASSERT_EQ(read.message(), "");
    EXPECT_EQ(read.motions().size(), 3u + 56u + 4u);
    EXPECT_EQ(read.all<nc::ReadTool>().at(0).number, 5);
    EXPECT_EQ(read.all<nc::ReadSpindle>().size(), 2u);
    EXPECT_EQ(read.all<nc::ReadSpindle>().at(0).speed_rpm, 12000.0);
    EXPECT_EQ(read.all<nc::ReadEnd>().size(), 1u);
  }
}

TEST(HeidenhainIsoReader, ReadsThePositionsOfAppendixOne) {
  const auto motions = sample::read_items("heidenhain-iso", paper_program(1)).motions();
  ASSERT_EQ(motions.size(), 63u);
  const auto& n120 = motions[8];
  EXPECT_EQ(n120.position, (std::array{49.0, 50.0, -8.0, 22.586, 333.177}));
  EXPECT_EQ(n120.stated, 0b11111);
  EXPECT_TRUE(n120.tcp);
  EXPECT_EQ(n120.feed, 2000.0);
  EXPECT_EQ(n120.datum_shift, (std::array{-30.489, -4.3, 38.054, 0.0, 0.0}));
  EXPECT_EQ(motions[57].position, (std::array{0.0, 50.0, -8.0, 23.162, 386.198}));
}

TEST(HeidenhainIsoReader, ReadsThePositionsOfAppendixTwo) {
  const auto motions = sample::read_items("heidenhain-iso", paper_program(2)).motions();
  ASSERT_EQ(motions.size(), 63u);
  EXPECT_EQ(motions[32].position, (std::array{25.0, 0.0, -8.0, 1.0, 180.0}));
  const auto& n650 = motions[59];
  EXPECT_FALSE(n650.tcp);
  EXPECT_EQ(n650.stated, 0b00100);
  EXPECT_EQ(n650.known, 0b11100);
}

TEST(HeidenhainIsoReader, APointIsNotNeeded) {
  const auto motion = last_motion("N40 G01 X+50 Y-8 Z.5 A+5. C+389 *");
  EXPECT_EQ(motion.position, (std::array{50.0, -8.0, 0.5, 5.0, 389.0}));
}

TEST(HeidenhainIsoReader, NeverGivesMinusZero) {
  EXPECT_FALSE(std::signbit(last_motion("N40 G01 X-0 *").position[0]));
}

TEST(HeidenhainIsoReader, MotionFeedAndPositionsAreModal) {
  const auto motions = motions_of("N40 G01 X+1 F300 *\nN50 Y+2 *\nN60 G00 Z+3 *");
  ASSERT_EQ(motions.size(), 3u);
  EXPECT_EQ(motions[1].kind, Kind::line);
  EXPECT_EQ(motions[1].feed, 300.0);
  EXPECT_EQ(motions[1].position, (std::array{1.0, 2.0, 100.0, 0.0, 0.0}));
  EXPECT_EQ(motions[2].kind, Kind::rapid);
  EXPECT_EQ(motions[2].feed_mode, ReadMotion::Feed::none);
}

// TNC 407 manual, 5.4: "G02 G91 X+5 G90 Y-5".
TEST(HeidenhainIsoReader, G90AndG91ActOnTheWordsBehindThem) {
  const auto motions =
      motions_of("N40 G01 X+10 Y+10 *\nN50 G91 X+5 G90 Y-5 *\nN60 X+1 G91 Y+1 *\nN70 X+1 *");
  ASSERT_EQ(motions.size(), 4u);
  EXPECT_EQ(motions[1].position[0], 15.0);
  EXPECT_EQ(motions[1].position[1], -5.0);
  EXPECT_EQ(motions[2].position[0], 1.0);
  EXPECT_EQ(motions[2].position[1], -4.0);
  EXPECT_EQ(motions[3].position[0], 2.0);
}

// iTNC 530 manual DIN/ISO, "Circle center I, J": absolute coordinates in G90; it holds until
// another is programmed.
TEST(HeidenhainIsoReader, ThePoleIsAbsoluteAndStays) {
  const auto motions = motions_of(
      "N40 G01 X+10 Y+0 *\nN50 I+20 J+0 *\nN60 G02 X+20 Y+10 *\nN70 X+30 Y+0 *\nN80 G03 I+25 J+0 "
      "X+20 Y+0 *");
  ASSERT_EQ(motions.size(), 4u);
  EXPECT_EQ(motions[1].centre_x_mm, 20.0);
  EXPECT_EQ(motions[1].centre_y_mm, 0.0);
  EXPECT_TRUE(motions[1].clockwise);
  EXPECT_EQ(motions[2].centre_x_mm, 20.0);
  EXPECT_EQ(motions[3].centre_x_mm, 25.0);
  EXPECT_FALSE(motions[3].clockwise);
}

// Manual, "Entering I, J, K incrementally": relative to the last programmed position of the tool.
TEST(HeidenhainIsoReader, ThePoleInG91CountsFromTheToolPosition) {
  const auto motion = last_motion("N40 G01 X+10 Y+5 *\nN50 G91 I+10 J+0 *\nN60 G90 G02 X+30 Y+5 *");
  EXPECT_EQ(motion.centre_x_mm, 20.0);
  EXPECT_EQ(motion.centre_y_mm, 5.0);
}

TEST(HeidenhainIsoReader, AFullCircleEndsWhereItStarts) {
  const auto motion = last_motion("N40 G01 X+10 Y+5 *\nN50 I+0 J+5 *\nN60 G03 X+10 Y+5 Z+90 *");
  EXPECT_EQ(motion.whole_turns, 1);
  EXPECT_EQ(motion.position[2], 90.0);
}

TEST(HeidenhainIsoReader, ARadiusGivesTheShortArcAndANegativeOneTheLong) {
  const auto shorter = last_motion("N40 G01 X+10 Y+0 *\nN50 G03 X+0 Y+10 R+10 *");
  EXPECT_NEAR(shorter.centre_x_mm, 0.0, 1e-12);
  EXPECT_NEAR(shorter.centre_y_mm, 0.0, 1e-12);
  const auto longer = last_motion("N40 G01 X+10 Y+0 *\nN50 G03 X+0 Y+10 R-10 *");
  EXPECT_NEAR(longer.centre_x_mm, 10.0, 1e-12);
  EXPECT_NEAR(longer.centre_y_mm, 10.0, 1e-12);
}

TEST(HeidenhainIsoReader, ArcEndsMayMissTheCircleBySixteenThousandths) {
  EXPECT_EQ(last_motion("N40 I+5 J+0 *\nN50 G02 X+10.015 Y+0 *").kind, Kind::arc);
  expect_refused("N40 I+5 J+0 *\nN50 G02 X+10.017 Y+0 *", "differ", Code::bad_arc);
}

TEST(HeidenhainIsoReader, RefusesArcsThatCannotBe) {
  expect_refused("N40 G02 X+10 Y+0 *", "centre", Code::bad_arc);
  expect_refused("N40 G02 X+10 Y+0 R+4 *", "radius", Code::bad_arc);
  expect_refused("N40 I+0 J+0 *\nN50 G02 X+0 Y+0 *", "radius", Code::bad_arc);
  expect_refused("N40 G18 *\nN50 I+5 J+0 *\nN60 G02 X+10 Y+0 *", "G17");
  expect_refused("N40 I+5 J+0 *\nN50 G02 X+10 Y+0 C+5 *", "C moves");
  expect_refused("N40 M128 *\nN50 I+5 J+0 *\nN60 G02 X+10 Y+0 *", "not known", Code::bad_arc);
}

TEST(HeidenhainIsoReader, ADatumShiftMovesNothingAndRenamesThePosition) {
  const auto motions =
      motions_of("N40 G54 X+10 C-5 *\nN50 G01 Y+1 *\nN60 G54 G91 X+1 *\nN70 G90 Y+2 *");
  ASSERT_EQ(motions.size(), 2u);
  EXPECT_EQ(motions[0].position, (std::array{-10.0, 1.0, 100.0, 0.0, 5.0}));
  EXPECT_EQ(motions[0].datum_shift, (std::array{10.0, 0.0, 0.0, 0.0, -5.0}));
  EXPECT_EQ(motions[1].position[0], -11.0);
  EXPECT_EQ(motions[1].datum_shift[0], 11.0);
}

// iTNC 530 manual DIN/ISO, dwell time: G04 F in seconds, up to 3600.
TEST(HeidenhainIsoReader, TheTimeOfADwellIsNoFeed) {
  EXPECT_EQ(last_motion("N40 G04 F5 *\nN50 G01 X+1 *").feed, 200.0);
}

TEST(HeidenhainIsoReader, TheFeedBehindM128IsThatOfTheCompensatingMoves) {
  EXPECT_EQ(last_motion("N40 M128 F1000 *\nN50 G01 X+1 *").feed, 200.0);
  EXPECT_EQ(last_motion("N40 G01 X+1 F300 M128 F1000 *").feed, 300.0);
}

// TNC 410 manual, 7.5: "M128 becomes effective at the start of block, M129 at the end of block."
TEST(HeidenhainIsoReader, M128ActsAtTheStartAndM129AtTheEndOfItsBlock) {
  const auto motions = motions_of("N40 G01 X+1 M128 *\nN50 X+2 Y+1 Z+1 M129 *\nN60 X+3 *");
  ASSERT_EQ(motions.size(), 3u);
  EXPECT_TRUE(motions[0].tcp);
  EXPECT_EQ(motions[0].known, 0b11001);
  EXPECT_TRUE(motions[1].tcp);
  EXPECT_FALSE(motions[2].tcp);
  EXPECT_EQ(motions[2].known, 0b11001);
}

TEST(HeidenhainIsoReader, M91MovesInMachineCoordinatesForItsBlock) {
  const auto motions = motions_of("N40 G00 Z-1 M91 *\nN50 X+1 *");
  ASSERT_EQ(motions.size(), 2u);
  EXPECT_TRUE(motions[0].machine_frame);
  EXPECT_EQ(motions[0].known, 0b00100);
  EXPECT_EQ(motions[0].position[2], -1.0);
  EXPECT_FALSE(motions[1].machine_frame);
  EXPECT_EQ(motions[1].known, 0b11011);
}

TEST(HeidenhainIsoReader, WhereM92GoesIsNotKnown) {
  const auto motion = last_motion("N40 G00 Z-1 M92 *");
  EXPECT_TRUE(motion.machine_frame);
  EXPECT_EQ(motion.stated, 0b00100);
  EXPECT_EQ(motion.known, 0);
}

TEST(HeidenhainIsoReader, M140IsASafeRetract) {
  const auto read = read_after_start("N40 M140 MB MAX *\nN50 M140 MB MAX F500 *\nN60 G01 X+1 *");
  ASSERT_EQ(read.message(), "");
  EXPECT_EQ(read.all<nc::ReadSafeRetract>().size(), 2u);
  EXPECT_EQ(read.motions().back().known, 0b11001);
  EXPECT_EQ(read.motions().back().feed, 200.0);
  expect_refused("N40 M140 MB 50 *", "M140");
  expect_refused("N40 X+5 M140 MB MAX *", "M140");
}

TEST(HeidenhainIsoReader, AToolCallForgetsTheLinearAxes) {
  const auto read = read_after_start("N40 T7 G17 S3000 *\nN50 G00 C+1 M3 *");
  ASSERT_EQ(read.message(), "");
  EXPECT_EQ(read.all<nc::ReadTool>().at(1).number, 7);
  EXPECT_EQ(read.motions().back().known, 0b11000);
  EXPECT_TRUE(read.motions().back().tool_length_offset);
  EXPECT_EQ(read.all<nc::ReadSpindle>().at(0).speed_rpm, 3000.0);
}

TEST(HeidenhainIsoReader, NamingAToolCallsNone) {
  const auto read =
      read_after_start("N40 G51 T6 *\nN50 G99 T6 L+0 R+5 *\nN60 G62 T0.05 P01 1 P02 1.5 *");
  ASSERT_EQ(read.message(), "");
  EXPECT_EQ(read.all<nc::ReadTool>().size(), 1u);
}

TEST(HeidenhainIsoReader, TheBlankFormIsNoMotion) {
  EXPECT_EQ(motions_of("N40 G30 G17 X+0 Y+0 Z-40 *\nN50 G31 G90 X+100 Y+100 Z+0 *").size(), 0u);
}

TEST(HeidenhainIsoReader, M126IsUnderstoodBelowHalfATurn) {
  EXPECT_EQ(last_motion("N40 M126 *\nN50 G01 C+179 *").position[4], 179.0);
  expect_refused("N40 M126 *\nN50 G01 C+180 *", "M126");
  EXPECT_EQ(last_motion("N40 M126 *\nN50 M127 *\nN60 G01 C+180 *").position[4], 180.0);
}

// TNC 620 manual DIN/ISO (34056x-04), 11.4: "Before positioning with M91 or M92 and before a T
// BLOCK, RESET M128."
TEST(HeidenhainIsoReader, RefusesWithM128WhatTheManualForbids) {
  expect_refused("N40 M128 *\nN50 G00 Z-1 M91 *", "M128");
  expect_refused("N40 M128 *\nN50 T6 G17 *", "M128");
  expect_refused("N40 M128 *\nN50 M6 *", "M128");
  expect_refused("N40 M128 *\nN50 M116 *", "M128");
}

TEST(HeidenhainIsoReader, RefusesWhatMayMoveTheMachineOtherwise) {
  const std::pair<std::string_view, std::string_view> cases[] = {
      {"N40 G41 X+5 *", "G41"},
      {"N40 G42 *", "G42"},
      {"N40 G43 X+5 *", "G43"},
      {"N40 G28 X *", ""},
      {"N40 G28 *", "G28"},
      {"N40 G72 F2 *", "G72"},
      {"N40 G73 H+30 *", "G73"},
      {"N40 G80 A+10 *", "G80"},
      {"N40 G53 P01 1 *", "G53"},
      {"N40 G10 R+5 H+30 *", "G10"},
      {"N40 G12 H+30 *", "G12"},
      {"N40 G05 X+5 *", "G5"},
      {"N40 G06 X+5 *", "G6"},
      {"N40 G07 X+5 *", "G7"},
      {"N40 G24 R1 *", "G24"},
      {"N40 G25 R1 *", "G25"},
      {"N40 G26 R1 *", "G26"},
      {"N40 G79 *", "G79"},
      {"N40 G200 Q200=2 *", "G200"},
      {"N40 G83 P01 -2 *", "G83"},
      {"N40 G98 L1 *", "G98"},
      {"N40 L1,0 *", "character"},
      {"N40 %SUB *", "program call"},
      {"N40 %SUB G71 *", "program call"},
      {"N40 G20 *", "G20"},
      {"N40 G70 *", "unit"},
      {"N40 G247 Q339=1 *", "G247"},
      {"N40 X+Q5 *", "Q param"},
      {"N40 D00 Q1 P01 +5 *", ""},
      {"N40 M99 *", "M99"},
      {"N40 M89 *", "M89"},
      {"N40 M94 *", "M94"},
      {"N40 M97 *", "M97"},
      {"N40 M98 *", "M98"},
      {"N40 M103 F50 *", "M103"},
      {"N40 M109 *", "M109"},
      {"N40 M114 *", "M114"},
      {"N40 M118 X1 *", "M118"},
      {"N40 M120 *", "M120"},
      {"N40 M124 *", "M124"},
      {"N40 M130 X+5 *", "M130"},
      {"N40 M136 *", "M136"},
      {"N40 M138 *", "M138"},
      {"N40 M144 *", "M144"},
      {"N40 M101 *", "M101"},
      {"N40 G01 X+5 B+5 *", "B5"},
      {"N40 G01 X+5 H+5 *", "H5"},
      {"N40 G01 X+5 R+5 *", "R5"},
      {"N40 G01 X+5 X+6 *", "twice"},
      {"N40 G00 G01 X+5 *", "two motion"},
      {"/N40 G01 X+5 *", "block skip"},
      {"N40 (G01) *", "character"},
      {"N40 G01 X+5", "closed"},
      {"N40 G01 X+5 * Y+5", "behind"},
      {"N40 G01 X+5,5 *", "character"},
      {"N40 g01 x+5 *", "character"},
      {"N40 X+5 N50 *", "block number"},
      {"N40 G91 X+1 M91 *", "G91"},
      {"N40 T6 X+5 *", "tool call"},
      {"N40 G54 G01 X+5 *", "G54"},
      {"N40 G54 REF X+5 *", ""},
      {"N40 T\"MILL\" *", ""},
  };
  for (const auto& [blocks, word] : cases) {
    SCOPED_TRACE(blocks);
    const auto read = read_after_start(blocks);
    EXPECT_FALSE(read.status.has_value());
    EXPECT_NE(read.message().find(word), std::string::npos) << read.message();
  }
}

TEST(HeidenhainIsoReader, PassesWhatMovesNothing) {
  EXPECT_EQ(
      motions_of("N40 G40 *\nN50 M8 *\nN60 M00 *\nN70 G38 *\n; remark\nN80 ; remark *\n\n% NOTE\n"
                 "N81 M116 *\nN82 M117 *\nN83 M9 * ; remark\nN84 M107 *\nN85 *\nN86 M25 *")
          .size(),
      0u);
}

TEST(HeidenhainIsoReader, RefusesNumbersThatAreNone) {
  for (const std::string_view blocks :
       {"N40 G01 XNAN *", "N40 G01 X *", "N40 G01 X+ *", "N40 G01 X1234567890123456 *",
        "N40 G01 X+100000 *", "N40 G01 X+1 F100000 *", "N40 T5.5 *", "N40 S-5 *"})
    expect_refused(blocks, "", Code::bad_number);
  expect_refused("N40 G01 X+1 F0 *", "F0", Code::no_feed);
}

TEST(HeidenhainIsoReader, RefusesACutWithoutFeed) {
  const auto read =
      sample::read_items("heidenhain-iso", "%A G71 *\nN10 G90 *\nN20 G01 X+1 *\nN30 M30 *\n");
  ASSERT_FALSE(read.status.has_value());
  EXPECT_EQ(read.status.error().code, Code::no_feed);
  EXPECT_EQ(read.message(), "NC text line 3: a cutting motion has no feed");
}

TEST(HeidenhainIsoReader, InchModeScalesLengthsAndNotDegrees) {
  const auto read =
      sample::read_items("heidenhain-iso", "%A G70 *\nN10 G90 G00 X+1 C+90 *\nN20 M30 *\n");
  ASSERT_EQ(read.message(), "");
  EXPECT_EQ(read.motions().at(0).position, (std::array{25.4, 0.0, 0.0, 0.0, 90.0}));
}

TEST(HeidenhainIsoReader, NeedsTheProgramLine) {
  for (const std::string_view text :
       {"", "N10 G90 *\n", "%\n", "%A\n", "%A *\n", "%A G71\n", "%A G21 *\n"})
    EXPECT_FALSE(sample::read_items("heidenhain-iso", text).status.has_value()) << text;
}

TEST(HeidenhainIsoReader, RefusesAxisWordsWithoutG90) {
  EXPECT_FALSE(
      sample::read_items("heidenhain-iso", "%A G71 *\nG00 X+1 *\nM30 *\n").status.has_value());
}

TEST(HeidenhainIsoReader, TheClosingLineEndsTheProgramToo) {
  const auto read = sample::read_items("heidenhain-iso", "%A G71 *\nN10 G90 *\nN99 %A G71 *\n");
  ASSERT_EQ(read.message(), "");
  EXPECT_EQ(read.all<nc::ReadEnd>().size(), 1u);
}

TEST(HeidenhainIsoReader, ReadsCrLf) {
  const auto read = sample::read_items(
      "heidenhain-iso", "%A G71 *\r\nN10 G90 G00 X+1 *\r\nN20 M30 *\r\nN99 %A G71 *\r\n");
  ASSERT_EQ(read.message(), "");
  EXPECT_EQ(read.motions().size(), 1u);
}

TEST(HeidenhainIsoReader, AnUnfinishedProgramIsAProblem) {
  const std::string whole = "%A G71 *\nN10 G90 *\nN20 G01 X+10.5 F100 *\nN30 M30 *\n";
  ASSERT_TRUE(sample::read_items("heidenhain-iso", whole).status.has_value());
  for (std::size_t length = 0; length + 2 < whole.size(); ++length) {
    SCOPED_TRACE(length);
    EXPECT_FALSE(sample::read_items("heidenhain-iso", whole.substr(0, length)).status.has_value());
  }
}

TEST(HeidenhainIsoReader, RefusesWordsBehindTheEnd) {
  EXPECT_FALSE(sample::read_items("heidenhain-iso", "%A G71 *\nM30 *\nG90 *\n").status.has_value());
  EXPECT_FALSE(sample::read_items("heidenhain-iso", "%A G71 *\nM30 *\nN9 %A G71 *\nN10 G90 *\n")
                   .status.has_value());
}

}  // namespace
