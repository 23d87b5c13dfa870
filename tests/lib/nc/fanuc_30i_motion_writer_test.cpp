#include "lib/nc/writer_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace pentapost {
namespace {

using sample::bare_with;
using sample::MotionCase;
using sample::fanuc::body;
using Kind = path::Block::Kind;

// X10 without a point is 0.01 mm on this control.
TEST(Fanuc30iWriter, WritesAPointInEveryAxisWordAndFeed) {
  const auto motion = MotionCase{}
                          .line({10, -0.5, 0.05, 100, 0}, 500.0)
                          .line({-1000.25, 0.001, -10, 999999.999, -999999.999}, 88.97)
                          .motion;

  EXPECT_EQ(body(motion),
            "G1 X10. Y-0.5 Z0.05 A100. C0. F500.\n"
            "X-1000.25 Y0.001 Z-10. A999999.999 C-999999.999 F88.97\n");
}

TEST(Fanuc30iWriter, LeavesOutWordsThatDoNotChange) {
  const auto motion = MotionCase{"XYZ"}
                          .line({1, 2, 3}, 100.0)
                          .line({1, 2, 4}, 100.0)
                          .line({0, 2, 4}, 200.0)
                          .rapid({0, 5, 4})
                          .motion;

  EXPECT_EQ(body(motion),
            "G1 X1. Y2. Z3. F100.\n"
            "Z4.\n"
            "X0. F200.\n"
            "G0 Y5.\n");
}

TEST(Fanuc30iWriter, WritesAllWordsOnRequest) {
  const auto motion = MotionCase{"XYZ"}.line({1, 2, 3}, 100.0).line({1, 2, 4}, 100.0).motion;

  EXPECT_EQ(body(motion, bare_with("modal_words", false)),
            "G1 X1. Y2. Z3. F100.\n"
            "X1. Y2. Z4.\n");
}

TEST(Fanuc30iWriter, KeepsABlockThatMovesNothingAMotionBlock) {
  const auto motion = MotionCase{"XYZ"}.line({1, 2, 3}, 100.0).line({1, 2, 3}, 100.0).motion;

  EXPECT_EQ(body(motion),
            "G1 X1. Y2. Z3. F100.\n"
            "X1. Y2. Z3.\n");
}

TEST(Fanuc30iWriter, StatesAllWordsAgainAfterTheModeChanges) {
  const path::ActionKind changes[] = {path::TcpOn{},
                                      path::TcpOff{},
                                      path::SafeRetract{},
                                      path::Stop{},
                                      path::InsertedText{"#100=1"},
                                      path::ToolCall{.number = 2}};
  for (const auto& change : changes) {
    const auto motion =
        MotionCase{"XYZ"}.line({1, 2, 3}, 100.0).act(change).line({1, 2, 3}, 100.0).motion;
    const std::string nc = body(motion);
    EXPECT_TRUE(nc.ends_with("G1 X1. Y2. Z3. F100.\n")) << nc;
    EXPECT_TRUE(nc.starts_with("G1 X1. Y2. Z3. F100.\n")) << nc;
  }
}

TEST(Fanuc30iWriter, DoesNotTakeUnstatedWordsForKnown) {
  const auto motion = MotionCase{"XYZ"}.rapid({0, 0, 7}).stating(0x03).rapid({0, 0, 0}).motion;

  EXPECT_EQ(body(motion),
            "G0 X0. Y0.\n"
            "Z0.\n");
}

TEST(Fanuc30iWriter, StatesInverseTimeOnEveryBlock) {
  const auto motion = MotionCase{"XYZC", Output::tcp}
                          .line({0, 0, 0, 0}, 100.0)
                          .inverse({1, 0, 0, 10}, 12.5)
                          .inverse({2, 0, 0, 20}, 12.5)
                          .inverse({3, 0, 0, 30}, 0.00001)
                          .inverse({4, 0, 0, 40}, 1e9)
                          .line({5, 0, 0, 40}, 100.0)
                          .line({6, 0, 0, 40}, 100.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "G1 X0. Y0. Z0. C0. F100.\n"
            "G93 X1. C10. F12.5\n"
            "X2. C20. F12.5\n"
            "X3. C30. F0.001\n"
            "X4. C40. F9999.999\n"
            "G94 X5. F100.\n"
            "X6.\n");
}

TEST(Fanuc30iWriter, RoundsInverseTimeDown) {
  const auto motion = MotionCase{"XYZC"}.inverse({1, 0, 0, 10}, 12.34599).motion;

  EXPECT_EQ(body(motion), "G93 G1 X1. Y0. Z0. C10. F12.345\n");
  EXPECT_EQ(body(motion, bare_with("inverse_time_decimals", 1.0)),
            "G93 G1 X1. Y0. Z0. C10. F12.3\n");
  EXPECT_EQ(body(motion, bare_with("largest_inverse_time", 10.0)),
            "G93 G1 X1. Y0. Z0. C10. F10.\n");
}

TEST(Fanuc30iWriter, LeavesInverseTimeForARapid) {
  const auto motion = MotionCase{"XYZC"}
                          .inverse({1, 0, 0, 10}, 5.0)
                          .rapid({0, 0, 0, 0})
                          .inverse({1, 0, 0, 1}, 5.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "G93 G1 X1. Y0. Z0. C10. F5.\n"
            "G94 G0 X0. C0.\n"
            "G93 G1 X1. C1. F5.\n");
}

TEST(Fanuc30iWriter, LeavesInverseTimeBeforeWhateverIsNoCuttingBlock) {
  const path::ActionKind others[] = {path::Dwell{1.0},
                                     path::TcpOn{},
                                     path::TcpOff{},
                                     path::SafeRetract{},
                                     path::Stop{},
                                     path::InsertedText{"M100"},
                                     path::ToolCall{.number = 1},
                                     path::ProgramEnd{}};
  for (const auto& other : others) {
    const auto motion = MotionCase{"XYZC"}.inverse({1, 0, 0, 10}, 5.0).act(other).motion;
    const std::string nc = body(motion);
    EXPECT_EQ(nc.find("\nG94\n"), nc.find('\n')) << nc;
  }
}

TEST(Fanuc30iWriter, StatesTheFeedModeAgainAfterTextOfTheCaller) {
  const auto motion = MotionCase{"XYZ"}
                          .line({1, 0, 0}, 100.0)
                          .act(path::InsertedText{"G93"})
                          .line({2, 0, 0}, 100.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "G1 X1. Y0. Z0. F100.\n"
            "G93\n"
            "G94 G1 X2. Y0. Z0. F100.\n");
}

TEST(Fanuc30iWriter, WritesArcsWithIncrementalCentres) {
  const auto motion = MotionCase{}
                          .line({45, 25, -5, 0, 0}, 200.0)
                          .arc(Kind::arc_counterclockwise, {25, 45, -5, 0, 0}, -20, 0, 200.0)
                          .arc(Kind::arc_clockwise, {45, 25, -6, 0, 0}, 0, -20, 150.0)
                          .line({45, 0, -6, 0, 0}, 150.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "G1 X45. Y25. Z-5. A0. C0. F200.\n"
            "G3 X25. Y45. I-20. J0.\n"
            "G2 X45. Y25. Z-6. I0. J-20. F150.\n"
            "G1 Y0.\n");
}

TEST(Fanuc30iWriter, WritesEndAndCentreOfAFullCircle) {
  const auto motion = MotionCase{"XYZ"}
                          .line({10, 0, 0}, 200.0)
                          .arc(Kind::arc_clockwise, {10, 0, 0}, -10, 0, 200.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "G1 X10. Y0. Z0. F200.\n"
            "G2 X10. Y0. I-10. J0.\n");
}

TEST(Fanuc30iWriter, RefusesAnArcThatTurnsARotaryAxis) {
  const auto motion = MotionCase{"XYZC"}
                          .line({10, 0, 0, 0}, 200.0)
                          .arc(Kind::arc_clockwise, {-10, 0, 0, 5}, -10, 0, 200.0)
                          .motion;

  EXPECT_EQ(sample::refused("fanuc-30i", motion).code, Code::not_in_dialect);
}

TEST(Fanuc30iWriter, LeavesRotaryWordsOutOfAnArcAfterAStop) {
  const auto motion = MotionCase{"XYZC"}
                          .line({10, 0, 0, 5}, 200.0)
                          .act(path::Stop{})
                          .arc(Kind::arc_clockwise, {-10, 0, 0, 5}, -10, 0, 200.0)
                          .line({-20, 0, 0, 5}, 200.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "G1 X10. Y0. Z0. C5. F200.\n"
            "M0\n"
            "G2 X-10. Y0. I-10. J0. F200.\n"
            "G1 X-20. Z0. C5.\n");
}

TEST(Fanuc30iWriter, WritesRapidsAsLinesOnRequest) {
  machine::Options options = bare_with("rapid_as_line", true);
  options["rapid_feed_mm_min"] = 15000.0;
  const auto motion =
      MotionCase{"XYZC"}.rapid({1, 0, 0, 0}).inverse({2, 0, 0, 5}, 7.0).rapid({3, 0, 0, 0}).motion;

  EXPECT_EQ(body(motion, options),
            "G1 X1. Y0. Z0. C0. F15000.\n"
            "G93 X2. C5. F7.\n"
            "G94 X3. C0. F15000.\n");
}

TEST(Fanuc30iWriter, NumbersTensOfThousandsOfBlocksWithoutLosingOne) {
  MotionCase many;
  for (int i = 0; i < 100'000; ++i) many.line({i * 0.001, 0, -8, 11, 360}, 2000.0);

  const std::string nc = body(many.motion);

  EXPECT_EQ(std::ranges::count(nc, '\n'), 100'000);
  EXPECT_TRUE(nc.ends_with("\nX99.999\n"));
}

}  // namespace
}  // namespace pentapost
