#include "lib/nc/writer_case.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace pentapost {
namespace {

using sample::MotionCase;
using sample::siemens::body;
using CycleKind = path::CycleStart::Kind;
using State = path::Spindle::State;

path::NativeCycle cycle(CycleKind kind) {
  return {.kind = kind,
          .clearance_z = 2000,
          .bottom_z = -10500,
          .feed_mm_min = 120.0,
          .clearance = 1500};
}

MotionCase turning(State state, double speed_rpm) {
  return MotionCase{"XYZ"}.act(path::Spindle{state, speed_rpm});
}

std::string call_of(const path::NativeCycle& what, State state = State::clockwise) {
  const std::string nc =
      body(turning(state, 477.0).act(what).hole({1, 2, -10.5}).act(path::NativeCycleEnd{}).motion);
  const auto at = nc.find("CYCLE");
  return nc.substr(at, nc.find('\n', at) - at);
}

/// RTP, RFP, SDIS, DP, DPR and what follows: Programming Guide Cycles, 2.1 Drilling cycles.
TEST(Siemens840dWriter, WritesEachCycleByItsName) {
  const auto with = [](CycleKind kind, std::int64_t peck, double dwell_s) {
    auto what = cycle(kind);
    what.peck = peck;
    what.dwell_s = dwell_s;
    return call_of(what);
  };
  EXPECT_EQ(with(CycleKind::drill, 0, 0), "CYCLE81(2,0.5,1.5,-10.5)");
  EXPECT_EQ(with(CycleKind::drill, 0, 0.5), "CYCLE82(2,0.5,1.5,-10.5,,0.5)");
  EXPECT_EQ(with(CycleKind::face, 0, 0.25), "CYCLE82(2,0.5,1.5,-10.5,,0.25)");
  EXPECT_EQ(with(CycleKind::deep, 3000, 0), "CYCLE83(2,0.5,1.5,-10.5,,,3,0,0,0,1,1)");
  EXPECT_EQ(with(CycleKind::break_chip, 3000, 0), "CYCLE83(2,0.5,1.5,-10.5,,,3,0,0,0,1,0)");
  EXPECT_EQ(with(CycleKind::deep, 0, 0), "CYCLE81(2,0.5,1.5,-10.5)");
  EXPECT_EQ(with(CycleKind::bore, 0, 1), "CYCLE85(2,0.5,1.5,-10.5,,1,120,120)");
  EXPECT_EQ(with(CycleKind::ream, 0, 0), "CYCLE85(2,0.5,1.5,-10.5,,0,120,120)");
  EXPECT_EQ(with(CycleKind::bore_drag, 0, 0), "CYCLE86(2,0.5,1.5,-10.5,,0,3,0,0,0,0)");
}

/// The pitch is the feed over the speed, its sign the hand of the thread; 3 and 4 are the
/// spindle's sense behind the cycle.
TEST(Siemens840dWriter, TapsByThePitch) {
  auto what = cycle(CycleKind::tap);
  what.feed_mm_min = 381.6;
  EXPECT_EQ(call_of(what), "CYCLE84(2,0.5,1.5,-10.5,,0,3,,0.8,0,477,477)");
  what.kind = CycleKind::tap_left;
  EXPECT_EQ(call_of(what, State::counterclockwise),
            "CYCLE84(2,0.5,1.5,-10.5,,0,4,,-0.8,0,477,477)");
}

TEST(Siemens840dWriter, KeepsThePitchAtASpeedThatIsNoWholeNumber) {
  auto what = cycle(CycleKind::tap);
  what.feed_mm_min = 0.8 * 476.7;
  const auto nc = body(turning(State::clockwise, 476.7).act(what).hole({1, 2, -10.5}).motion);

  EXPECT_NE(nc.find(",,0.8,0,476.7,476.7)\n"), std::string::npos) << nc;
}

TEST(Siemens840dWriter, RefusesATapWithoutASpeed) {
  const auto motion = MotionCase{"XYZ"}.act(cycle(CycleKind::tap)).hole({1, 2, -10.5}).motion;

  EXPECT_EQ(sample::refused("siemens-840d", motion).code, Code::out_of_domain);
}

TEST(Siemens840dWriter, DrillsBehindEveryPlaceUntilMcallEnds) {
  const auto motion = MotionCase{"XYZ", Output::axes}
                          .rapid({1, 2, 20})
                          .act(cycle(CycleKind::drill))
                          .hole({1, 2, -10.5})
                          .hole({5, 2, -10.5})
                          .hole({5, 3, -12})
                          .act(path::NativeCycleEnd{})
                          .line({5, 2, 30}, 120.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "G0 X1 Y2 Z20 D1\n"
            "F120\n"
            "MCALL CYCLE81(2,0.5,1.5,-10.5)\n"
            "X1 Y2\n"
            "X5 Y2\n"
            "MCALL\n"
            "F120\n"
            "MCALL CYCLE81(2,0.5,1.5,-12)\n"
            "G0 X5 Y3\n"
            "MCALL\n"
            "G1 X5 Y2 Z30 F120\n");
}

TEST(Siemens840dWriter, LeavesRotaryWordsOutThatStay) {
  const auto motion = MotionCase{"XYZC", Output::axes}
                          .rapid({1, 2, 20, 5})
                          .act(path::Dwell{1.0})
                          .act(cycle(CycleKind::drill))
                          .hole({3, 2, -10.5, 5})
                          .motion;

  EXPECT_NE(body(motion).find("\nG0 X3 Y2\n"), std::string::npos);
}

TEST(Siemens840dWriter, EndsACycleBeforeAnyOtherMove) {
  const auto motion =
      MotionCase{"XYZ"}.act(cycle(CycleKind::drill)).hole({1, 2, -10.5}).rapid({1, 2, 30}).motion;

  EXPECT_EQ(body(motion),
            "F120\n"
            "MCALL CYCLE81(2,0.5,1.5,-10.5)\n"
            "G0 X1 Y2\n"
            "MCALL\n"
            "G0 X1 Y2 Z30\n");
}

TEST(Siemens840dWriter, TurnsTheSpindleAgainBehindABoreWithAStop) {
  const auto motion = turning(State::clockwise, 900.0)
                          .act(cycle(CycleKind::bore_drag))
                          .hole({1, 2, -10.5})
                          .act(path::NativeCycleEnd{})
                          .motion;

  EXPECT_EQ(body(motion),
            "S900 M3\n"
            "F120\n"
            "MCALL CYCLE86(2,0.5,1.5,-10.5,,0,3,0,0,0,0)\n"
            "G0 X1 Y2\n"
            "MCALL\n"
            "M3\n");
}

TEST(Siemens840dWriter, SaysD1WithTheFirstHoleIfNothingDidBefore) {
  const auto motion =
      MotionCase{"XYZ", Output::axes}.act(cycle(CycleKind::drill)).hole({1, 2, -10.5}).motion;

  EXPECT_EQ(body(motion), "F120\nMCALL CYCLE81(2,0.5,1.5,-10.5)\nG0 X1 Y2 D1\n");
}

TEST(Siemens840dWriter, WritesNoCycleThatDrillsNothing) {
  const auto motion =
      MotionCase{"XYZ"}.act(cycle(CycleKind::drill)).act(path::NativeCycleEnd{}).motion;

  EXPECT_EQ(body(motion), "");
}

TEST(Siemens840dWriter, TakesAHoleWithoutCycleForADefect) {
  EXPECT_THROW(body(MotionCase{"XYZ"}.hole({1, 2, 3}).motion), std::logic_error);
}

}  // namespace
}  // namespace pentapost
