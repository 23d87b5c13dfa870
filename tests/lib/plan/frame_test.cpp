#include "pentapost/plan/frame.hpp"

#include "lib/plan/program_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pentapost::plan {
namespace {

using sample::planned_outline;
using sample::ProgramCase;
using Lines = std::vector<std::string>;
using SpindleState = path::Spindle::State;
using CoolantState = path::Coolant::State;

// A tool axis that the trunnion of sample::trunnion_ac() reaches with A = asin 0.6 and C = 0.
const Vec3 tilted{0.0, 0.6, 0.8};

/// Tool 5 at 8000 rpm with coolant: a rapid to the first point and one cut, the tool tilted.
ProgramCase one_cut(Output output, const machine::Chain& chain = sample::trunnion_ac()) {
  ProgramCase job{chain, output};
  job.event(path::ToolChange{.number = 5});
  job.event(path::Spindle{SpindleState::clockwise, 8000.0});
  job.event(path::Coolant{CoolantState::flood});
  job.feed_rate(500.0);
  job.rapid({10, 20, 30}, tilted);
  job.point({15, 20, 30}, tilted);
  return job;
}

/// The tool comes down by 100 mm along (0, 0.6, 0.8), with TCP on, to the first point.
TEST(Frame, WithTcpTheRotaryAxesComeFirstAndTcpIsOnFromThereToTheRetract) {
  EXPECT_EQ(planned_outline(one_cut(Output::tcp)),
            (Lines{"safe retract", "tool 5 S8000", "spindle right S8000", "coolant on",
                   "rapid A36.87 C0 off path", "tcp on", "rapid X10 Y80 Z110 A36.87 C0 off path",
                   "rapid X10 Y20 Z30 A36.87 C0", "line X15 Y20 Z30 A36.87 C0 F500", "tcp off",
                   "safe retract", "coolant off", "spindle off", "end"}));
}

/// The table turns the point to Y = 0.8 * 20 - 0.6 * 30, Z = 0.6 * 20 + 0.8 * 30; the tool comes
/// down on Z alone.
TEST(Frame, WithJointValuesThereIsNoTcpAndZAloneComesDown) {
  EXPECT_EQ(planned_outline(one_cut(Output::axes)),
            (Lines{"safe retract", "tool 5 S8000", "spindle right S8000", "coolant on",
                   "rapid A36.87 C0 off path", "rapid X10 Y-2 off path",
                   "rapid X10 Y-2 Z36 A36.87 C0", "line X15 Y-2 Z36 A36.87 C0 F500", "safe retract",
                   "coolant off", "spindle off", "end"}));
}

/// Ending TCP may move the axes by the tool length: not before the tool is at its safe end.
TEST(Frame, TcpMayEndAfterTheRetractOnly) {
  ProgramCase job = one_cut(Output::tcp);
  job.settings.retracts_with_tcp = true;
  const Lines lines = planned_outline(job);
  ASSERT_GE(lines.size(), 5U);
  EXPECT_EQ(Lines(lines.end() - 5, lines.end()),
            (Lines{"safe retract", "tcp off", "coolant off", "spindle off", "end"}));
}

/// A retract along the tool axis needs a tool; between two tools it comes before the change.
TEST(Frame, TheFirstRetractMayHaveToWaitForTheTool) {
  ProgramCase job = one_cut(Output::tcp);
  job.settings.retract_needs_tool = true;
  job.event(path::ToolChange{.number = 6});
  job.point({16, 20, 30}, tilted);
  const Lines lines = planned_outline(job);
  ASSERT_GE(lines.size(), 3U);
  EXPECT_EQ(Lines(lines.begin(), lines.begin() + 2), (Lines{"tool 5 S8000", "safe retract"}));
  const auto second = std::find(lines.begin(), lines.end(), "tool 6 S8000");
  ASSERT_NE(second, lines.end());
  EXPECT_EQ(std::count(lines.begin() + 2, second, "safe retract"), 1);
  EXPECT_NE(*(second + 1), "safe retract");
}

TEST(Frame, AThreeAxisMachineHasNeitherTcpNorRotaryWords) {
  ProgramCase job{sample::three_axis()};
  job.feed_rate(500.0);
  job.rapid({1, 2, 3});
  job.point({4, 2, 3});
  EXPECT_EQ(planned_outline(job),
            (Lines{"safe retract", "tool 1", "rapid X1 Y2 off path", "rapid X1 Y2 Z3",
                   "(warning: the spindle is off, the CL data do not start it)",
                   "line X4 Y2 Z3 F500", "safe retract", "end"}));
}

TEST(Frame, AFourAxisMachineTurnsItsOneRotaryAxisFirst) {
  ProgramCase job{sample::four_axis_a(), Output::axes};
  job.feed_rate(500.0);
  job.rapid({1, 2, 3});
  const Lines lines = planned_outline(job);
  ASSERT_GE(lines.size(), 3U);
  EXPECT_EQ(lines[2], "rapid A0 off path");
}

/// On the fork head no linear axis follows the tool: with the tool axis along X it comes down by
/// 100 mm along X, towards smaller values (the X of ISO 841 counts the tool's way).
TEST(Frame, AHeadThatTurnsComesDownAlongItsToolAxis) {
  ProgramCase job{sample::fork_head_cb(), Output::axes};
  job.settings.gauge_length_mm[1] = 120.0;
  job.feed_rate(500.0);
  job.rapid({10, 20, 30}, Vec3::UnitX());
  const auto program = job.planned();
  ASSERT_TRUE(program) << program.error().message;
  const auto& blocks = program->motion.blocks;
  ASSERT_GE(blocks.size(), 3U);
  EXPECT_EQ(blocks[0].stated, 0x18);
  EXPECT_EQ(blocks[1].stated, 0x1F);
  EXPECT_FALSE(blocks[1].on_path);
  EXPECT_EQ(blocks[2].word[0] - blocks[1].word[0], -100'000);
  EXPECT_EQ(blocks[2].word[1], blocks[1].word[1]);
  EXPECT_EQ(blocks[2].word[2], blocks[1].word[2]);
}

/// A way up along Z would drag the tilted tool sideways through the part.
TEST(Frame, AHeadThatHasTurnedTakesTheToolOutAlongItsAxis) {
  ProgramCase job{sample::fork_head_cb(), Output::tcp};
  job.feed_rate(500.0);
  job.rapid({10, 20, 30}, Vec3::UnitX());
  const Lines lines = planned_outline(job);
  ASSERT_GE(lines.size(), 4U);
  const auto last = lines.end() - 4;
  EXPECT_EQ(last->substr(0, 20), "rapid X110 Y20 Z30 B");
  EXPECT_NE(last->find("off path"), std::string::npos);
  EXPECT_EQ(Lines(last + 1, lines.end()), (Lines{"tcp off", "safe retract", "end"}));
}

TEST(Frame, AnUprightHeadNeedsNoWayOfItsOwn) {
  ProgramCase job{sample::fork_head_cb(), Output::tcp};
  job.feed_rate(500.0);
  job.rapid({10, 20, 30});
  const Lines lines = planned_outline(job);
  ASSERT_GE(lines.size(), 4U);
  EXPECT_EQ((lines.end() - 4)->find("off path"), std::string::npos);
}

TEST(Frame, AFirstMoveByFeedComesDownFromTenMillimetres) {
  ProgramCase job{sample::trunnion_ac()};
  job.event(path::ToolChange{.number = 1});
  job.feed_rate(300.0);
  job.point({10, 20, 30}, tilted);
  const Lines lines = planned_outline(job);
  ASSERT_GE(lines.size(), 6U);
  EXPECT_EQ(lines[4], "rapid X10 Y26 Z38 A36.87 C0 off path");
  EXPECT_EQ(lines[5], "line X10 Y20 Z30 A36.87 C0 F300");
}

TEST(Frame, ComesDownFromTheRetractOfTheControlWhereThatIsNearer) {
  ProgramCase job = one_cut(Output::tcp);
  job.settings.retract_mm = 5.0;
  EXPECT_EQ(planned_outline(job)[6], "rapid X10 Y23 Z34 A36.87 C0 off path");
}

/// TCP and the coolant are off, the tool is up and the spindle stands before another tool comes.
TEST(Frame, AToolChangeEndsTcpRetractsAndStopsEverythingBefore) {
  ProgramCase job = one_cut(Output::tcp);
  job.event(path::ToolChange{.number = 6, .length_register = 16});
  job.event(path::Spindle{SpindleState::counterclockwise, 900.0});
  job.rapid({0, 0, 50});
  job.point({1, 0, 50});
  const Lines lines = planned_outline(job);
  ASSERT_GT(lines.size(), 9U);
  EXPECT_EQ(Lines(lines.begin() + 9, lines.end()),
            (Lines{"tcp off", "safe retract", "coolant off", "spindle off", "tool 6 H16 S900",
                   "coolant on", "spindle left S900", "rapid A0 C0 off path", "tcp on",
                   "rapid X0 Y0 Z150 A0 C0 off path", "rapid X0 Y0 Z50 A0 C0",
                   "line X1 Y0 Z50 A0 C0 F500", "tcp off", "safe retract", "coolant off",
                   "spindle off", "end"}));
}

TEST(Frame, TheSameToolNamedAgainIsNoChange) {
  ProgramCase job = one_cut(Output::tcp);
  const std::size_t before = planned_outline(job).size();
  job.event(path::ToolChange{.number = 5});
  job.point({20, 20, 30}, tilted);
  EXPECT_EQ(planned_outline(job).size(), before + 1);
}

TEST(Frame, HomeIsSafeAndTheReturnIsAnApproach) {
  ProgramCase job = one_cut(Output::tcp);
  job.event(path::GoHome{});
  job.rapid({0, 0, 50});
  const Lines lines = planned_outline(job);
  ASSERT_GT(lines.size(), 9U);
  EXPECT_EQ(Lines(lines.begin() + 9, lines.end()),
            (Lines{"tcp off", "safe retract", "rapid A0 C0 off path", "tcp on",
                   "rapid X0 Y0 Z150 A0 C0 off path", "rapid X0 Y0 Z50 A0 C0", "tcp off",
                   "safe retract", "coolant off", "spindle off", "end"}));
}

/// For controls whose end of TCP moves the axes by the tool length.
TEST(Frame, WhereTcpEndsWithAMoveTheToolIsUpBefore) {
  ProgramCase job = one_cut(Output::tcp);
  job.settings.retracts_with_tcp = true;
  const Lines lines = planned_outline(job);
  ASSERT_GT(lines.size(), 9U);
  EXPECT_EQ(Lines(lines.begin() + 9, lines.end()),
            (Lines{"safe retract", "tcp off", "coolant off", "spindle off", "end"}));
}

TEST(Frame, WhereTheRetractNeedsAToolTheToolIsCalledFirst) {
  ProgramCase job = one_cut(Output::tcp);
  job.settings.retract_needs_tool = true;
  const Lines lines = planned_outline(job);
  ASSERT_GT(lines.size(), 4U);
  EXPECT_EQ(Lines(lines.begin(), lines.begin() + 4),
            (Lines{"tool 5 S8000", "safe retract", "spindle right S8000", "coolant on"}));
}

TEST(Frame, WhatIsOnAlreadyIsNotSaidAgain) {
  ProgramCase job = one_cut(Output::tcp);
  const std::size_t before = planned_outline(job).size();
  job.event(path::Spindle{SpindleState::clockwise, 8000.0});
  job.event(path::Coolant{CoolantState::flood});
  job.point({20, 20, 30}, tilted);
  EXPECT_EQ(planned_outline(job).size(), before + 1);
}

/// SPINDL/ON after SPINDL/OFF goes on with the speed that was set.
TEST(Frame, ASpindleWithoutSpeedTurnsAsBefore) {
  ProgramCase job = one_cut(Output::tcp);
  job.event(path::Spindle{});
  job.event(path::Spindle{.state = SpindleState::counterclockwise});
  const Lines lines = planned_outline(job);
  EXPECT_NE(std::find(lines.begin(), lines.end(), "spindle left S8000"), lines.end());
}

TEST(Frame, AFeedPerTurnFollowsTheSpindle) {
  ProgramCase job{sample::trunnion_ac()};
  job.event(path::Spindle{SpindleState::clockwise, 1000.0});
  job.event(path::FeedRate{0.2, path::FeedRate::Unit::mm_per_revolution});
  job.rapid({0, 0, 0});
  job.point({1, 0, 0});
  job.event(path::Spindle{SpindleState::clockwise, 500.0});
  job.point({2, 0, 0});
  const auto program = job.planned();
  ASSERT_TRUE(program) << program.error().message;
  const auto& blocks = program->motion.blocks;
  ASSERT_GE(blocks.size(), 2U);
  EXPECT_DOUBLE_EQ(blocks[blocks.size() - 2].feed, 200.0);
  EXPECT_DOUBLE_EQ(blocks.back().feed, 100.0);
}

TEST(Frame, EventsKeepTheirPlaceBetweenTheMoves) {
  ProgramCase job = one_cut(Output::tcp);
  job.event(path::Dwell{1.5});
  job.event(path::Comment{"slot"});
  job.event(path::Stop{});
  job.point({20, 20, 30}, tilted);
  const Lines lines = planned_outline(job);
  ASSERT_GT(lines.size(), 13U);
  EXPECT_EQ(Lines(lines.begin() + 8, lines.begin() + 13),
            (Lines{"line X15 Y20 Z30 A36.87 C0 F500", "dwell 1.5", "(slot)", "stop",
                   "line X20 Y20 Z30 A36.87 C0 F500"}));
}

/// The last events of the CL data come with the tool up and TCP off.
TEST(Frame, WhatFollowsTheLastPointComesAfterTheRetract) {
  ProgramCase job = one_cut(Output::tcp);
  job.event(path::Stop{});
  const Lines lines = planned_outline(job);
  ASSERT_GT(lines.size(), 9U);
  EXPECT_EQ(Lines(lines.begin() + 9, lines.end()),
            (Lines{"tcp off", "safe retract", "stop", "coolant off", "spindle off", "end"}));
}

}  // namespace
}  // namespace pentapost::plan
