#include "pentapost/plan/drilling.hpp"

#include "lib/plan/program_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pentapost::plan {
namespace {

using sample::planned_outline;
using sample::ProgramCase;
using Lines = std::vector<std::string>;
using Kind = path::CycleStart::Kind;

const Vec3 tilted{0.0, 0.6, 0.8};

/// Joint values on the trunnion, a rapid to (0, 0, 10), then whatever holes a test adds.
ProgramCase holes(const machine::Chain& chain = sample::trunnion_ac()) {
  ProgramCase job{chain, Output::axes};
  job.settings.native_cycles = true;
  job.feed_rate(500.0);
  job.rapid({0, 0, 10});
  return job;
}

void hole(ProgramCase& job, const Vec3& place_mm, const Vec3& axis = Vec3::UnitZ()) {
  job.point(place_mm, axis, path::Move::hole);
}

/// What the program says of drilling, and what stands between.
Lines from_the_first_cycle(const ProgramCase& job) {
  const Lines lines = planned_outline(job);
  const auto first = std::find_if(lines.begin(), lines.end(), [](const std::string& line) {
    return line.starts_with("cycle");
  });
  return {first, lines.end()};
}

bool is_native(const ProgramCase& job) {
  return native_holes(job.model, job.path,
                      job.settings)(static_cast<std::uint32_t>(job.path.size()) - 1);
}

/// Levels are Z words in micrometres: 2 mm above the hole's place at Z5, 12 mm below it.
TEST(Drilling, ACycleHasItsLevelsPecksDwellAndFeed) {
  ProgramCase job = holes();
  job.event(path::CycleStart{.kind = Kind::deep,
                             .depth_mm = 12.0,
                             .clearance_mm = 2.0,
                             .peck_mm = 3.5,
                             .dwell_s = 0.25,
                             .feed_mm_min = 80.0});
  hole(job, {20, 30, 5});
  EXPECT_EQ(from_the_first_cycle(job),
            (Lines{"cycle R7000 Z-7000 Q3500 P0.25 F80", "drill X20 Y30 Z-7 A0 C0 F80", "cycle end",
                   "safe retract", "end"}));
}

TEST(Drilling, WithoutAFeedOfItsOwnTheActiveOneHolds) {
  ProgramCase job = holes();
  job.event(path::CycleStart{.depth_mm = 12.0, .clearance_mm = 2.0});
  hole(job, {20, 30, 5});
  EXPECT_EQ(from_the_first_cycle(job).front(), "cycle R7000 Z-7000 Q0 P0 F500");
}

TEST(Drilling, WithoutAnyFeedIsRefusedAtItsLine) {
  ProgramCase job{sample::trunnion_ac(), Output::axes};
  job.settings.native_cycles = true;
  job.rapid({0, 0, 10});
  job.event(path::CycleStart{.depth_mm = 12.0, .clearance_mm = 2.0});
  hole(job, {20, 30, 5});
  const auto program = job.planned();
  ASSERT_FALSE(program);
  EXPECT_EQ(program.error().code, Code::no_feed);
  EXPECT_EQ(program.error().cl_line, 3U);
}

TEST(Drilling, ATapIsFedByItsPitch) {
  ProgramCase job = holes();
  job.event(path::Spindle{path::Spindle::State::clockwise, 480.0});
  job.event(
      path::CycleStart{.kind = Kind::tap, .depth_mm = 12.0, .clearance_mm = 2.0, .pitch_mm = 1.25});
  hole(job, {20, 30, 5});
  EXPECT_EQ(from_the_first_cycle(job).front(), "cycle R7000 Z-7000 Q0 P0 F600");
}

/// Holes on one level share a cycle, one on another level needs its own.
TEST(Drilling, TheCycleStaysOnUntilSomethingOfItChanges) {
  ProgramCase job = holes();
  job.event(path::CycleStart{.depth_mm = 12.0, .clearance_mm = 2.0, .feed_mm_min = 80.0});
  hole(job, {20, 30, 5});
  hole(job, {40, 30, 5});
  hole(job, {60, 30, 6});
  EXPECT_EQ(from_the_first_cycle(job),
            (Lines{"cycle R7000 Z-7000 Q0 P0 F80", "drill X20 Y30 Z-7 A0 C0 F80",
                   "drill X40 Y30 Z-7 A0 C0 F80", "cycle end", "rapid Z8 off path",
                   "cycle R8000 Z-6000 Q0 P0 F80", "drill X60 Y30 Z-6 A0 C0 F80", "cycle end",
                   "safe retract", "end"}));
}

/// In a cycle the control moves across at the level where the tool is: from R3 to a hole on a boss
/// 30 mm higher it would go through the boss.
TEST(Drilling, TheToolRisesToAHigherClearanceBeforeItMovesAcross) {
  ProgramCase job = holes();
  job.event(path::CycleStart{.depth_mm = 10.0, .clearance_mm = 3.0, .feed_mm_min = 80.0});
  hole(job, {0, 0, 0});
  hole(job, {20, 0, 30});
  EXPECT_EQ(from_the_first_cycle(job),
            (Lines{"cycle R3000 Z-10000 Q0 P0 F80", "drill X0 Y0 Z-10 A0 C0 F80", "cycle end",
                   "rapid Z33 off path", "cycle R33000 Z20000 Q0 P0 F80",
                   "drill X20 Y0 Z20 A0 C0 F80", "cycle end", "safe retract", "end"}));
}

TEST(Drilling, TheControlItselfComesDownToALowerClearance) {
  ProgramCase job = holes();
  job.rapid({0, 0, 60});
  job.event(path::CycleStart{.depth_mm = 10.0, .clearance_mm = 3.0, .feed_mm_min = 80.0});
  hole(job, {20, 0, 30});
  hole(job, {0, 0, 0});
  EXPECT_EQ(from_the_first_cycle(job),
            (Lines{"cycle R33000 Z20000 Q0 P0 F80", "drill X20 Y0 Z20 A0 C0 F80",
                   "cycle R3000 Z-10000 Q0 P0 F80", "drill X0 Y0 Z-10 A0 C0 F80", "cycle end",
                   "safe retract", "end"}));
}

TEST(Drilling, TheToolRisesIntoACycleThatStartsAboveTheLastMove) {
  ProgramCase job = holes();
  job.point({5, 0, 2});
  job.event(path::CycleStart{.depth_mm = 10.0, .clearance_mm = 3.0, .feed_mm_min = 80.0});
  hole(job, {20, 0, 0});
  const Lines lines = planned_outline(job);
  const auto rise = std::find(lines.begin(), lines.end(), "rapid Z3 off path");
  ASSERT_NE(rise, lines.end());
  EXPECT_EQ(*(rise - 1), "line X5 Y0 Z2 A0 C0 F500");
  EXPECT_EQ(*(rise + 1), "cycle R3000 Z-10000 Q0 P0 F80");
}

/// Z = 0.6 y + 0.8 z of the work: 37 at the first clearance, 10 mm along the axis higher at the
/// second, whose hole lies at (10, 26, 38).
TEST(Drilling, OnATurnedTableTheToolRisesAlongTheDrillingAxis) {
  ProgramCase job = holes();
  job.event(path::CycleStart{.depth_mm = 10.0, .clearance_mm = 1.0, .feed_mm_min = 80.0});
  hole(job, {10, 20, 30}, tilted);
  hole(job, {40, 26, 38}, tilted);
  const Lines lines = from_the_first_cycle(job);
  ASSERT_GE(lines.size(), 6U);
  EXPECT_EQ(Lines(lines.begin() + 2, lines.begin() + 6),
            (Lines{"cycle end", "rapid Z47 off path", "cycle R47000 Z36000 Q0 P0 F80",
                   "drill X40 Y-2 Z36 A36.87 C0 F80"}));
}

TEST(Drilling, AnyOtherMoveEndsTheCycleFirst) {
  ProgramCase job = holes();
  job.event(path::CycleStart{.depth_mm = 12.0, .clearance_mm = 2.0, .feed_mm_min = 80.0});
  hole(job, {20, 30, 5});
  job.rapid({50, 50, 10});
  hole(job, {40, 30, 5});
  job.event(path::CycleEnd{});
  EXPECT_EQ(from_the_first_cycle(job),
            (Lines{"cycle R7000 Z-7000 Q0 P0 F80", "drill X20 Y30 Z-7 A0 C0 F80", "cycle end",
                   "rapid X50 Y50 Z10 A0 C0", "cycle R7000 Z-7000 Q0 P0 F80",
                   "drill X40 Y30 Z-7 A0 C0 F80", "cycle end", "safe retract", "end"}));
}

/// In a cycle the X of a dwell or of an inserted text would be another hole.
TEST(Drilling, ADwellOrAnInsertedTextEndsTheCycleFirst) {
  ProgramCase job = holes();
  job.event(path::CycleStart{.depth_mm = 12.0, .clearance_mm = 2.0, .feed_mm_min = 80.0});
  hole(job, {20, 30, 5});
  job.event(path::Dwell{2.0});
  hole(job, {40, 30, 5});
  job.event(path::InsertedText{"M77"});
  hole(job, {60, 30, 5});
  EXPECT_EQ(from_the_first_cycle(job),
            (Lines{"cycle R7000 Z-7000 Q0 P0 F80", "drill X20 Y30 Z-7 A0 C0 F80", "cycle end",
                   "dwell 2", "cycle R7000 Z-7000 Q0 P0 F80", "drill X40 Y30 Z-7 A0 C0 F80",
                   "cycle end", "M77", "cycle R7000 Z-7000 Q0 P0 F80",
                   "drill X60 Y30 Z-7 A0 C0 F80", "cycle end", "safe retract", "end"}));
}

/// CYCLE/OFF ends it where it stands, not at the next move.
TEST(Drilling, TheEndOfTheCycleComesBeforeWhatFollowsIt) {
  ProgramCase job = holes();
  job.event(path::CycleStart{.depth_mm = 12.0, .clearance_mm = 2.0, .feed_mm_min = 80.0});
  hole(job, {20, 30, 5});
  job.event(path::CycleEnd{});
  job.event(path::Dwell{2.0});
  job.rapid({50, 50, 10});
  const Lines lines = from_the_first_cycle(job);
  ASSERT_GE(lines.size(), 5U);
  EXPECT_EQ(Lines(lines.begin() + 2, lines.begin() + 5),
            (Lines{"cycle end", "dwell 2", "rapid X50 Y50 Z10 A0 C0"}));
}

/// The trunnion turns a hole along (0, 0.6, 0.8) upright: Z = 0.6 * 20 + 0.8 * 30 = 36 at its
/// place. The cycle is off and the tool up while A turns: the part would swing into it.
TEST(Drilling, ATiltedHoleIsDrilledAlongTheTurnedZ) {
  ProgramCase job = holes();
  job.event(path::CycleStart{.depth_mm = 10.0, .clearance_mm = 1.0, .feed_mm_min = 80.0});
  hole(job, {20, 30, 5});
  hole(job, {10, 20, 30}, tilted);
  EXPECT_EQ(from_the_first_cycle(job),
            (Lines{"cycle R6000 Z-5000 Q0 P0 F80", "drill X20 Y30 Z-5 A0 C0 F80", "cycle end",
                   "safe retract", "rapid A36.87 C0 off path", "rapid X10 Y-2 off path",
                   "rapid X10 Y-2 Z37 A36.87 C0 off path", "cycle R37000 Z26000 Q0 P0 F80",
                   "drill X10 Y-2 Z26 A36.87 C0 F80", "cycle end", "safe retract", "end"}));
}

/// A move behind a hole starts at the retract level: 8 mm down to the next point.
TEST(Drilling, ThePathGoesOnFromTheRetractLevel) {
  ProgramCase job = holes();
  job.settings.limits["Z"].max_speed = 1.0;
  job.settings.limits["C"].max_speed = 1.0;
  job.settings.inverse_time = true;
  job.event(path::CycleStart{.depth_mm = 10.0, .clearance_mm = 8.0, .feed_mm_min = 80.0});
  hole(job, {0, 0, 0});
  job.event(path::CycleEnd{});
  job.point({0, 0, 0}, {0, 1e-3, 1});
  const auto program = job.planned();
  ASSERT_TRUE(program) << program.error().message;
  EXPECT_NEAR(program->motion.blocks.back().feed, 60.0 / 8.0, 1e-3);
}

TEST(NativeHoles, AreThoseOfACycleOffTheFirstPoint) {
  ProgramCase job = holes();
  job.event(path::CycleStart{.depth_mm = 10.0, .clearance_mm = 1.0});
  hole(job, {20, 30, 5});
  EXPECT_TRUE(is_native(job));
  EXPECT_FALSE(native_holes(job.model, job.path, job.settings)(0));
}

/// Three decimals of an angle leave 12 um at the end of 1 m along Z.
TEST(NativeHoles, TooDeepForTheDigitsOfTheAnglesAreNone) {
  ProgramCase job = holes();
  job.event(path::CycleStart{.depth_mm = 1000.0, .clearance_mm = 1.0});
  hole(job, {20, 30, 5});
  EXPECT_FALSE(is_native(job));
  job.settings.tip_tolerance_mm = 0.02;
  EXPECT_TRUE(is_native(job));
}

TEST(NativeHoles, TheFirstPointOfAToolIsNone) {
  ProgramCase job = holes();
  job.event(path::ToolChange{.number = 2});
  job.event(path::CycleStart{.depth_mm = 10.0, .clearance_mm = 1.0});
  hole(job, {20, 30, 5});
  EXPECT_FALSE(is_native(job));
  hole(job, {30, 30, 5});
  EXPECT_TRUE(is_native(job));
}

TEST(NativeHoles, NeedAControlWithCycles) {
  ProgramCase job = holes();
  job.event(path::CycleStart{.depth_mm = 10.0, .clearance_mm = 1.0});
  hole(job, {20, 30, 5});
  job.settings.native_cycles = false;
  EXPECT_FALSE(is_native(job));
}

TEST(NativeHoles, NeedTcpToBeOff) {
  ProgramCase job = holes();
  job.event(path::CycleStart{.depth_mm = 10.0, .clearance_mm = 1.0});
  hole(job, {20, 30, 5});
  job.settings.output = Output::tcp;
  EXPECT_FALSE(is_native(job));
}

TEST(NativeHoles, NeedAToolAxisThatIsTheZOfTheWords) {
  for (const auto& chain :
       {sample::fork_head_cb(), sample::swivel_head(),
        sample::chain_of({}, {sample::x(), sample::y(), sample::z()}, Vec3::UnitX()),
        sample::chain_of({}, {sample::x(), sample::y(), sample::linear("Z", -Vec3::UnitZ())})}) {
    ProgramCase job = holes(chain);
    job.event(path::CycleStart{.depth_mm = 10.0, .clearance_mm = 1.0});
    hole(job, {20, 30, 5});
    EXPECT_FALSE(is_native(job));
  }
}

TEST(NativeHoles, NeedACycleThatTheControlCanBeTold) {
  const auto native = [](const path::CycleStart& cycle) {
    ProgramCase job = holes();
    job.event(cycle);
    hole(job, {20, 30, 5});
    return is_native(job);
  };
  const path::CycleStart plain{.depth_mm = 10.0, .clearance_mm = 1.0};
  EXPECT_TRUE(native(plain));

  path::CycleStart retracting = plain;
  retracting.retract_mm = 1.0;
  EXPECT_TRUE(native(retracting));
  retracting.retract_mm = 20.0;
  EXPECT_FALSE(native(retracting));

  for (const Kind kind : {Kind::deep, Kind::break_chip}) {
    path::CycleStart pecking = plain;
    pecking.kind = kind;
    EXPECT_FALSE(native(pecking));
    pecking.peck_mm = 2.0;
    EXPECT_TRUE(native(pecking));
  }
  path::CycleStart dwelling = plain;
  dwelling.dwell_s = 1.0;
  EXPECT_FALSE(native(dwelling));
  dwelling.kind = Kind::face;
  EXPECT_TRUE(native(dwelling));
}

}  // namespace
}  // namespace pentapost::plan
