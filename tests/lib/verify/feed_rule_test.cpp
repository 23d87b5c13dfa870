#include "pentapost/verify/feed_rule.hpp"

#include <gtest/gtest.h>

namespace pentapost::verify {
namespace {

nc::ReadMotion motion_with(nc::ReadMotion::Feed mode, double feed) {
  nc::ReadMotion motion;
  motion.feed_mode = mode;
  motion.feed = feed;
  return motion;
}

TEST(FeedRule, TakesAFeedPerRevolutionTimesTheSpeed) {
  path::ToolPath cl;
  cl.add_event(1, path::Spindle{path::Spindle::State::clockwise, 2000.0});
  cl.add_event(2, path::FeedRate{0.1, path::FeedRate::Unit::mm_per_revolution});
  ClState state{cl};
  state.advance_to(0);

  ASSERT_TRUE(state.feed_mm_min());
  EXPECT_DOUBLE_EQ(*state.feed_mm_min(), 200.0);
}

TEST(FeedRule, SkipsTheFeedOfJointsThatTurn) {
  const auto motion = motion_with(nc::ReadMotion::Feed::per_minute, 900.0);
  EXPECT_EQ(wrong_feed(motion, {.programmed_mm_min = 500.0, .f_is_tip_speed = false}), "");
  EXPECT_NE(wrong_feed(motion, {.programmed_mm_min = 500.0, .f_is_tip_speed = true}), "");
}

TEST(FeedRule, ForgivesAMillionthForRounding) {
  const FeedCase feed_case{.programmed_mm_min = 500.0, .f_is_tip_speed = true};
  EXPECT_EQ(wrong_feed(motion_with(nc::ReadMotion::Feed::per_minute, 500.0004), feed_case), "");
  EXPECT_NE(wrong_feed(motion_with(nc::ReadMotion::Feed::per_minute, 500.0006), feed_case), "");
}

TEST(FeedRule, WantsThePitchOfATapOnBothSides) {
  path::ToolPath cl;
  cl.add_event(1, path::Spindle{path::Spindle::State::clockwise, 400.0});
  cl.add_event(
      2, path::CycleStart{.kind = path::CycleStart::Kind::tap, .depth_mm = 10, .pitch_mm = 1.25});
  ClState state{cl};
  state.advance_to(0);

  EXPECT_EQ(wrong_hole_feed(motion_with(nc::ReadMotion::Feed::per_minute, 500.0), state), "");
  EXPECT_NE(wrong_hole_feed(motion_with(nc::ReadMotion::Feed::per_minute, 500.1), state), "");
  EXPECT_NE(wrong_hole_feed(motion_with(nc::ReadMotion::Feed::per_minute, 499.9), state), "");
}

TEST(FeedRule, HoldsAStatedPitchAgainstThePitchOfTheTap) {
  path::ToolPath cl;
  cl.add_event(1, path::Spindle{path::Spindle::State::clockwise, 400.0});
  cl.add_event(2, path::CycleStart{.kind = path::CycleStart::Kind::tap,
                                   .depth_mm = 10,
                                   .feed_mm_min = 400.0 * 25.4 / 28.0});
  ClState state{cl};
  state.advance_to(0);
  nc::ReadMotion motion = motion_with(nc::ReadMotion::Feed::per_minute, 362.8);

  motion.pitch_mm = 0.9071;  // 25.4 / 28 = 0.90714
  EXPECT_EQ(wrong_hole_feed(motion, state), "");
  motion.pitch_mm = 0.9072;
  EXPECT_NE(wrong_hole_feed(motion, state), "");
  motion.pitch_mm = 0.907;
  EXPECT_NE(wrong_hole_feed(motion, state), "");
}

TEST(SettingRule, TakesToolOneForAPathThatNamesNone) {
  path::ToolPath cl;
  const ClState state{cl};
  EXPECT_EQ(wrong_setting(state, 1, {}), "");
  EXPECT_EQ(wrong_setting(state, std::nullopt, {}), "");
  EXPECT_NE(wrong_setting(state, 2, {}), "");
}

nc::ReadMotion motion_with_register(int length_register) {
  nc::ReadMotion motion;
  motion.length_register = length_register;
  return motion;
}

TEST(LengthRegisterRule, TakesTheToolsNumberWhereTheClDataNamesNone) {
  path::ToolPath cl;
  cl.add_event(1, path::ToolChange{.number = 5});
  ClState state{cl};
  EXPECT_EQ(wrong_length_register(state, motion_with_register(1)), "");  // before any tool change
  state.advance_to(0);
  EXPECT_EQ(wrong_length_register(state, motion_with_register(5)), "");
  EXPECT_EQ(wrong_length_register(state, motion_with_register(4)),
            "the length register is 4, expected is 5 of tool 5");
}

TEST(LengthRegisterRule, TakesTheRegisterThatTheClDataNames) {
  path::ToolPath cl;
  cl.add_event(1, path::ToolChange{.number = 5, .length_register = 15});
  ClState state{cl};
  state.advance_to(0);
  EXPECT_EQ(wrong_length_register(state, motion_with_register(15)), "");
  EXPECT_NE(wrong_length_register(state, motion_with_register(5)), "");
}

TEST(LengthRegisterRule, KeepsTheRegisterWhereTheSameToolIsNamedAgain) {
  path::ToolPath cl;
  cl.add_event(1, path::ToolChange{.number = 5, .length_register = 15});
  cl.add_event(2, path::ToolChange{.number = 5});
  cl.add_point(Vec3::Zero(), Vec3::UnitZ(), 3, path::Move::feed);
  cl.add_event(4, path::ToolChange{.number = 5, .length_register = 25});
  ClState state{cl};
  state.advance_to(0);
  EXPECT_EQ(state.length_register(), 15);
  state.advance_to(1);
  EXPECT_EQ(state.length_register(), 25);
}

TEST(LengthRegisterRule, DoesNotCarryTheRegisterToAnotherTool) {
  path::ToolPath cl;
  cl.add_event(1, path::ToolChange{.number = 5, .length_register = 15});
  cl.add_event(2, path::ToolChange{.number = 6});
  ClState state{cl};
  state.advance_to(0);
  EXPECT_EQ(wrong_length_register(state, motion_with_register(6)), "");
  EXPECT_NE(wrong_length_register(state, motion_with_register(15)), "");
}

TEST(LengthRegisterRule, LeavesAControlAloneThatTakesTheToolsOwnLength) {
  path::ToolPath cl;
  cl.add_event(1, path::ToolChange{.number = 5, .length_register = 15});
  ClState state{cl};
  state.advance_to(0);
  EXPECT_EQ(wrong_length_register(state, motion_with_register(0)), "");
}

}  // namespace
}  // namespace pentapost::verify
