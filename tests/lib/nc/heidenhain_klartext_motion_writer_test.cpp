#include "lib/nc/writer_case.hpp"

#include <gtest/gtest.h>

#include <string>

namespace pentapost {
namespace {

using sample::MotionCase;
using sample::klartext::body;
using sample::klartext::options_with;
using Kind = path::Block::Kind;

TEST(HeidenhainKlartextMotion, SignsEveryCoordinate) {
  EXPECT_EQ(body(MotionCase{}.rapid({1.5, -2, 0, 0.001, -90}).motion),
            "L X+1.5 Y-2 Z+0 A+0.001 C-90 R0 FMAX\n");
}

TEST(HeidenhainKlartextMotion, LeavesOutWordsThatDoNotChange) {
  const auto motion = MotionCase{}
                          .line({0, 0, 0, 0, 0}, 100.0)
                          .line({1, 0, 0, 0, 0}, 100.0)
                          .line({1, 0, 0, 2, 3}, 200.0)
                          .motion;

  EXPECT_EQ(body(motion), "L X+0 Y+0 Z+0 A+0 C+0 R0 F100\nL X+1\nL A+2 C+3 F200\n");
}

TEST(HeidenhainKlartextMotion, StatesAllWordsOnRequest) {
  const auto motion = MotionCase{}.line({0, 0, 0, 0, 0}, 100.0).line({1, 0, 0, 0, 0}, 100.0).motion;

  EXPECT_EQ(body(motion, options_with("modal_words", false)),
            "L X+0 Y+0 Z+0 A+0 C+0 R0 F100\nL X+1 Y+0 Z+0 A+0 C+0\n");
}

TEST(HeidenhainKlartextMotion, NamesAnAxisInABlockWithoutAWay) {
  const auto motion = MotionCase{}.line({1, 2, 3, 4, 5}, 100.0).line({1, 2, 3, 4, 5}, 100.0).motion;

  EXPECT_EQ(body(motion), "L X+1 Y+2 Z+3 A+4 C+5 R0 F100\nL X+1 Y+2 Z+3 A+4 C+5\n");
}

TEST(HeidenhainKlartextMotion, KeepsTheFeedOverRapidBlocks) {
  const auto motion = MotionCase{}
                          .line({0, 0, 0, 0, 0}, 100.0)
                          .rapid({1, 0, 0, 0, 0})
                          .line({2, 0, 0, 0, 0}, 100.0)
                          .motion;

  EXPECT_EQ(body(motion), "L X+0 Y+0 Z+0 A+0 C+0 R0 F100\nL X+1 R0 FMAX\nL X+2\n");
}

TEST(HeidenhainKlartextMotion, WritesRapidsAsLinesOnRequest) {
  const auto motion = MotionCase{}.rapid({0, 0, 0, 0, 0}).line({1, 0, 0, 0, 0}, 100.0).motion;

  EXPECT_EQ(body(motion, {{"comments", false},
                          {"block_numbers", false},
                          {"rapid_as_line", true},
                          {"rapid_feed_mm_min", 15'000.0}}),
            "L X+0 Y+0 Z+0 A+0 C+0 R0 F15000\nL X+1 F100\n");
}

TEST(HeidenhainKlartextMotion, RoundsFeedsDown) {
  EXPECT_EQ(body(MotionCase{}.line({0, 0, 0, 0, 0}, 99.9999).motion),
            "L X+0 Y+0 Z+0 A+0 C+0 R0 F99.999\n");
  EXPECT_EQ(
      body(MotionCase{}.line({0, 0, 0, 0, 0}, 99.9999).motion, options_with("feed_decimals", 0.0)),
      "L X+0 Y+0 Z+0 A+0 C+0 R0 F99\n");
}

TEST(HeidenhainKlartextMotion, HoldsFeedsToWhatTheControlTakes) {
  EXPECT_EQ(body(MotionCase{}.line({0, 0, 0, 0, 0}, 2e5).motion),
            "L X+0 Y+0 Z+0 A+0 C+0 R0 F99999.999\n");
}

TEST(HeidenhainKlartextMotion, TakesFiveDigitsBeforeThePoint) {
  EXPECT_EQ(body(MotionCase{}.line({99'999.999, 0, 0, 0, 0}, 10.0).motion),
            "L X+99999.999 Y+0 Z+0 A+0 C+0 R0 F10\n");
  EXPECT_EQ(
      sample::refused("heidenhain", MotionCase{}.line({100'000, 0, 0, 0, 0}, 10.0).motion)
          .code,
      Code::out_of_domain);
}

TEST(HeidenhainKlartextMotion, TakesInverseTimeForADefect) {
  EXPECT_THROW(
      sample::program("heidenhain", MotionCase{}.inverse({0, 0, 0, 0, 0}, 5.0).motion),
      std::logic_error);
}

TEST(HeidenhainKlartextMotion, WritesArcsAboutThePole) {
  const auto motion = MotionCase{}
                          .line({0, 0, 0, 0, 0}, 100.0)
                          .arc(Kind::arc_clockwise, {10, 10, 0, 0, 0}, 10, 0, 100.0)
                          .arc(Kind::arc_counterclockwise, {0, 0, 0, 0, 0}, 0, -10, 80.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "L X+0 Y+0 Z+0 A+0 C+0 R0 F100\n"
            "CC X+10 Y+0\n"
            "C X+10 Y+10 DR-\n"
            "CC X+10 Y+0\n"
            "C X+0 Y+0 DR+ F80\n");
}

TEST(HeidenhainKlartextMotion, StatesBothWordsOfAnArcsEnd) {
  const auto motion = MotionCase{}
                          .line({10, 0, 0, 0, 0}, 100.0)
                          .arc(Kind::arc_counterclockwise, {-10, 0, 0, 0, 0}, -10, 0, 100.0)
                          .motion;

  EXPECT_EQ(body(motion), "L X+10 Y+0 Z+0 A+0 C+0 R0 F100\nCC X+0 Y+0\nC X-10 Y+0 DR+\n");
}

TEST(HeidenhainKlartextMotion, WritesHelicesByTheirAngle) {
  const auto motion = MotionCase{}
                          .line({10, 0, 0, 0, 0}, 100.0)
                          .arc(Kind::arc_counterclockwise, {0, 10, -1, 0, 0}, -10, 0, 100.0)
                          .arc(Kind::arc_clockwise, {10, 0, -2, 0, 0}, 0, -10, 100.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "L X+10 Y+0 Z+0 A+0 C+0 R0 F100\n"
            "CC X+0 Y+0\n"
            "CP IPA+90 Z-1 DR+\n"
            "CC X+0 Y+0\n"
            "CP IPA-90 Z-2 DR-\n");
}

TEST(HeidenhainKlartextMotion, WritesMoreThanHalfATurnOfAHelixInItsSense) {
  const auto motion = MotionCase{}
                          .line({10, 0, 0, 0, 0}, 100.0)
                          .arc(Kind::arc_clockwise, {0, 10, -1, 0, 0}, -10, 0, 100.0)
                          .motion;

  EXPECT_NE(body(motion).find("CP IPA-270 Z-1 DR-\n"), std::string::npos);
}

TEST(HeidenhainKlartextMotion, WritesAWholeTurnOfAHelix) {
  for (const auto& [kind, block] :
       {std::pair{Kind::arc_clockwise, "CP IPA-360 Z-1 DR-\n"},
        std::pair{Kind::arc_counterclockwise, "CP IPA+360 Z-1 DR+\n"}}) {
    const auto motion = MotionCase{}
                            .line({10, 0, 0, 0, 0}, 100.0)
                            .arc(kind, {10, 0, -1, 0, 0}, -10, 0, 100.0)
                            .motion;
    EXPECT_NE(body(motion).find(block), std::string::npos) << body(motion);
  }
}

TEST(HeidenhainKlartextMotion, StatesAllWordsBehindAHelix) {
  const auto motion = MotionCase{}
                          .line({10, 0, 0, 0, 0}, 100.0)
                          .arc(Kind::arc_counterclockwise, {0, 10, -1, 0, 0}, -10, 0, 100.0)
                          .line({0, 10, 5, 0, 0}, 100.0)
                          .motion;

  EXPECT_NE(body(motion).find("DR+\nL X+0 Y+10 Z+5 A+0 C+0\n"), std::string::npos);
}

TEST(HeidenhainKlartextMotion, RefusesARotaryAxisInAnArc) {
  const auto motion = MotionCase{}
                          .line({10, 0, 0, 0, 0}, 100.0)
                          .arc(Kind::arc_clockwise, {0, 10, 0, 1, 0}, -10, 0, 100.0)
                          .motion;

  EXPECT_EQ(sample::refused("heidenhain", motion).code, Code::not_in_dialect);
}

TEST(HeidenhainKlartextMotion, RefusesACentreWithTooManyDigits) {
  const auto motion = MotionCase{}
                          .line({99'000, 0, 0, 0, 0}, 100.0)
                          .arc(Kind::arc_clockwise, {99'000, 10, 0, 0, 0}, 1'500, 5, 100.0)
                          .motion;

  EXPECT_EQ(sample::refused("heidenhain", motion).code, Code::out_of_domain);
}

TEST(HeidenhainKlartextMotion, TakesAnArcWithoutACentreForADefect) {
  auto motion = MotionCase{}.line({0, 0, 0, 0, 0}, 100.0).line({1, 0, 0, 0, 0}, 100.0).motion;
  motion.blocks[1].kind = Kind::arc_clockwise;

  EXPECT_THROW(sample::program("heidenhain", motion), std::logic_error);
}

}  // namespace
}  // namespace pentapost
