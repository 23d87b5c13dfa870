#include "lib/nc/writer_case.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace pentapost {
namespace {

using sample::MotionCase;
using sample::fanuc::body;
using CycleKind = path::CycleStart::Kind;

path::NativeCycle cycle(CycleKind kind) {
  return {.kind = kind, .clearance_z = 2000, .bottom_z = -10500, .feed_mm_min = 120.0};
}

std::string one_hole(const path::NativeCycle& what) {
  const auto motion =
      MotionCase{"XYZ"}.act(what).hole({1, 2, -10.5}).act(path::NativeCycleEnd{}).motion;
  const std::string nc = body(motion);
  const auto at = nc.find("G9");
  return nc.substr(at, nc.find('\n', at) - at);
}

TEST(Fanuc30iWriter, WritesEachCycleByItsWord) {
  const auto with = [](CycleKind kind, std::int64_t peck, double dwell_s) {
    auto what = cycle(kind);
    what.peck = peck;
    what.dwell_s = dwell_s;
    return one_hole(what);
  };
  EXPECT_EQ(with(CycleKind::drill, 0, 0), "G99 G81 X1. Y2. Z-10.5 R2. F120.");
  EXPECT_EQ(with(CycleKind::drill, 0, 0.5), "G99 G82 X1. Y2. Z-10.5 R2. P500 F120.");
  EXPECT_EQ(with(CycleKind::face, 0, 0.25), "G99 G82 X1. Y2. Z-10.5 R2. P250 F120.");
  EXPECT_EQ(with(CycleKind::deep, 3000, 0), "G99 G83 X1. Y2. Z-10.5 R2. Q3. F120.");
  EXPECT_EQ(with(CycleKind::deep, 0, 0), "G99 G81 X1. Y2. Z-10.5 R2. F120.");
  EXPECT_EQ(with(CycleKind::break_chip, 1500, 0), "G99 G73 X1. Y2. Z-10.5 R2. Q1.5 F120.");
  EXPECT_EQ(with(CycleKind::tap, 0, 0), "G99 G84 X1. Y2. Z-10.5 R2. F120.");
  EXPECT_EQ(with(CycleKind::tap_left, 0, 0), "G99 G74 X1. Y2. Z-10.5 R2. F120.");
  EXPECT_EQ(with(CycleKind::bore, 0, 0), "G99 G85 X1. Y2. Z-10.5 R2. F120.");
  EXPECT_EQ(with(CycleKind::bore, 0, 1), "G99 G89 X1. Y2. Z-10.5 R2. P1000 F120.");
  EXPECT_EQ(with(CycleKind::ream, 0, 0), "G99 G85 X1. Y2. Z-10.5 R2. F120.");
  EXPECT_EQ(with(CycleKind::bore_drag, 0, 0), "G99 G86 X1. Y2. Z-10.5 R2. F120.");
}

TEST(Fanuc30iWriter, RetractsToTheLevelBeforeTheCycleWithG98) {
  auto what = cycle(CycleKind::drill);
  what.retract_to_clearance = false;

  EXPECT_EQ(one_hole(what), "G98 G81 X1. Y2. Z-10.5 R2. F120.");
}

// 381.6 mm/min at 477 rpm is the pitch of M5; rounded down it would be another thread.
TEST(Fanuc30iWriter, DoesNotRoundTheFeedOfATapDown) {
  auto what = cycle(CycleKind::tap);
  what.feed_mm_min = 381.6;
  EXPECT_EQ(one_hole(what), "G99 G84 X1. Y2. Z-10.5 R2. F381.6");
  what.feed_mm_min = 333.3333;
  EXPECT_EQ(one_hole(what), "G99 G84 X1. Y2. Z-10.5 R2. F333.333");
}

TEST(Fanuc30iWriter, WritesThePlaceOfEveryHoleAndEndsTheCycle) {
  const auto motion = MotionCase{"XYZ"}
                          .rapid({1, 2, 20})
                          .act(cycle(CycleKind::drill))
                          .hole({1, 2, -10.5})
                          .hole({1, 2, -10.5})
                          .hole({5, 2, -10.5})
                          .hole({5, 2, -12})
                          .act(path::NativeCycleEnd{})
                          .line({5, 2, 30}, 120.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "G0 X1. Y2. Z20.\n"
            "G99 G81 X1. Y2. Z-10.5 R2. F120.\n"
            "X1. Y2.\n"
            "X5. Y2.\n"
            "X5. Y2. Z-12.\n"
            "G80\n"
            "G1 X5. Y2. Z30. F120.\n");
}

TEST(Fanuc30iWriter, EndsACycleBeforeAnyOtherMove) {
  const auto motion =
      MotionCase{"XYZ"}.act(cycle(CycleKind::drill)).hole({1, 2, -10.5}).rapid({1, 2, 30}).motion;

  EXPECT_EQ(body(motion),
            "G99 G81 X1. Y2. Z-10.5 R2. F120.\n"
            "G80\n"
            "G0 X1. Y2. Z30.\n");
}

TEST(Fanuc30iWriter, StartsTheNextCycleAfresh) {
  const auto motion = MotionCase{"XYZ"}
                          .act(cycle(CycleKind::drill))
                          .hole({1, 2, -10.5})
                          .act(cycle(CycleKind::tap))
                          .hole({1, 2, -10.5})
                          .act(path::NativeCycleEnd{})
                          .motion;

  EXPECT_EQ(body(motion),
            "G99 G81 X1. Y2. Z-10.5 R2. F120.\n"
            "G80\n"
            "M29\n"
            "G99 G84 X1. Y2. Z-10.5 R2. F120.\n"
            "G80\n");
}

/// Two holes of a tap at 477 rpm, then one more level.
path::Motion taps() {
  auto deeper = cycle(CycleKind::tap_left);
  deeper.bottom_z = -12000;
  return MotionCase{"XYZ"}
      .act(path::Spindle{path::Spindle::State::clockwise, 476.7})
      .act(cycle(CycleKind::tap))
      .hole({1, 2, -10.5})
      .hole({5, 2, -10.5})
      .act(deeper)
      .hole({9, 2, -12})
      .motion;
}

/// Without M29 parameter 5200 decides whether G84 couples feed and spindle (FANUC Series 30i
/// operator's manual, rigid tapping).
TEST(Fanuc30iWriter, MakesEachTappingCycleRigidOnce) {
  EXPECT_EQ(body(taps()),
            "S477 M3\n"
            "M29 S477\n"
            "G99 G84 X1. Y2. Z-10.5 R2. F120.\n"
            "X5. Y2.\n"
            "G80\n"
            "M29 S477\n"
            "G99 G74 X9. Y2. Z-12. R2. F120.\n");
}

TEST(Fanuc30iWriter, TakesTheBlocksOfRigidTappingFromItsOption) {
  const std::string none = body(taps(), {{"rigid_tapping", std::vector<std::string>{}}});
  EXPECT_EQ(none.find("M29"), std::string::npos);
  const std::string own =
      body(taps(), {{"rigid_tapping", std::vector<std::string>{"M135 {speed}", "M1"}}});
  EXPECT_NE(own.find("M3\nM135 S477\nM1\nG99 G84"), std::string::npos);
}

TEST(Fanuc30iWriter, WritesNoCycleThatDrillsNothing) {
  const auto motion =
      MotionCase{"XYZ"}.act(cycle(CycleKind::drill)).act(path::NativeCycleEnd{}).motion;

  EXPECT_EQ(body(motion), "");
}

TEST(Fanuc30iWriter, SwitchesTheToolLengthOnInTheFirstHoleIfNothingDidBefore) {
  const auto motion =
      MotionCase{"XYZ", Output::axes}.act(cycle(CycleKind::drill)).hole({1, 2, -10.5}).motion;

  EXPECT_EQ(body(motion), "G43 G99 G81 X1. Y2. Z-10.5 H1 R2. F120.\n");
}

TEST(Fanuc30iWriter, TakesAHoleWithoutCycleForADefect) {
  EXPECT_THROW(body(MotionCase{"XYZ"}.hole({1, 2, 3}).motion), std::logic_error);
}

}  // namespace
}  // namespace pentapost
