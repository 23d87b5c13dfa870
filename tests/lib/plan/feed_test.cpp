#include "pentapost/plan/feed.hpp"

#include "lib/plan/program_case.hpp"

#include <gtest/gtest.h>

namespace pentapost::plan {
namespace {

using FeedMode = path::Block::Feed;

/// The trunnion of sample::trunnion_ac(): C is the first rotary joint, A the second.
class Feed : public ::testing::Test {
 protected:
  void limit_deg_s(const std::string& name, double speed) {
    settings_.limits[name].max_speed = speed * rad_per_deg;
  }
  void limit_mm_s(const std::string& name, double speed) {
    settings_.limits[name].max_speed = speed;
  }

  /// A block that moves the joints by this much and the tip by `length_mm` along X.
  Status set(double length_mm, const Vec3& linear_mm, double c_deg, double a_deg,
             std::optional<double> feed_mm_min) {
    Posture from, to;
    to.linear_mm = linear_mm;
    to.tip_mm = Vec3{length_mm, 0, 0};
    to.printed = {c_deg * rad_per_deg, a_deg * rad_per_deg};
    block_ = {};
    block_.cl_line = 17;
    return FeedRule{model_, settings_, word_columns(model_)}.set(block_, from, to, length_mm,
                                                                 feed_mm_min);
  }
  void expect(FeedMode mode, double feed) const {
    EXPECT_EQ(block_.feed_mode, mode);
    EXPECT_NEAR(block_.feed, feed, 1e-9 * feed);
  }

  const kinematics::Model model_{sample::trunnion_ac()};
  Settings settings_;
  path::Block block_;
};

TEST_F(Feed, WithTcpItIsThatOfTheClDataWhateverTheAxesDo) {
  limit_deg_s("C", 1.0);
  ASSERT_TRUE(set(10, Vec3::Zero(), 90, 30, 500.0));
  expect(FeedMode::per_minute, 500.0);
}

TEST_F(Feed, OfJointValuesIsThatOfTheClDataWhileTheRotaryAxesStand) {
  settings_.output = Output::axes;
  settings_.inverse_time = true;
  ASSERT_TRUE(set(10, {10, 0, 0}, 0, 0, 500.0));
  expect(FeedMode::per_minute, 500.0);
}

class JointFeed : public Feed {
 protected:
  JointFeed() { settings_.output = Output::axes; }
};

/// 10 mm at 500 mm/min: 50 times a minute, however far the joints go.
TEST_F(JointFeed, InInverseTimeIsFeedOverLengthOfTheTip) {
  settings_.inverse_time = true;
  ASSERT_TRUE(set(10, {77, -30, 5}, 90, 30, 500.0));
  expect(FeedMode::inverse_time, 50.0);
}

/// 90 deg at 150 deg/s take 0.6 s: 100 times a minute and no more.
TEST_F(JointFeed, InInverseTimeKeepsTheSpeedOfTheRotaryAxis) {
  settings_.inverse_time = true;
  limit_deg_s("C", 150.0);
  ASSERT_TRUE(set(10, Vec3::Zero(), 90, 0, 5000.0));
  expect(FeedMode::inverse_time, 100.0);
}

/// 30 mm at 10 mm/s take 3 s: 20 times a minute.
TEST_F(JointFeed, InInverseTimeKeepsTheSpeedOfALinearAxisThatFollows) {
  settings_.inverse_time = true;
  limit_deg_s("C", 150.0);
  limit_mm_s("Y", 10.0);
  ASSERT_TRUE(set(10, {0, -30, 0}, 90, 0, 5000.0));
  expect(FeedMode::inverse_time, 20.0);
}

/// A way of a millionth of a millimetre at 1000 mm/min would be F 1e9.
TEST_F(JointFeed, OfATinyBlockIsTheLargestThatTheControlTakes) {
  settings_.inverse_time = true;
  settings_.largest_inverse_time = 99'999.0;
  ASSERT_TRUE(set(1e-6, Vec3::Zero(), 0.001, 0, 1000.0));
  expect(FeedMode::inverse_time, 99'999.0);
}

/// The control counts millimetres and degrees alike: hypot(3, 4, 12) = 13 in 2 mm / 100 mm/min.
TEST_F(JointFeed, WithoutInverseTimeIsTheWayOfAllAxesInTheTimeOfTheTip) {
  ASSERT_TRUE(set(2, {3, 0, 0}, 4, 12, 100.0));
  expect(FeedMode::per_minute, 650.0);
}

TEST_F(JointFeed, WithoutInverseTimeKeepsTheSpeedOfTheRotaryAxis) {
  limit_deg_s("A", 6.0);  // 12 deg take 2 s
  ASSERT_TRUE(set(2, {3, 0, 0}, 4, 12, 1000.0));
  expect(FeedMode::per_minute, 13.0 * 30.0);
}

TEST_F(Feed, IsNoFasterThanTheControlCanBeTold) {
  settings_.largest_feed = 20'000.0;
  ASSERT_TRUE(set(10, Vec3::Zero(), 0, 0, 30'000.0));
  expect(FeedMode::per_minute, 20'000.0);
  settings_.output = Output::axes;
  ASSERT_TRUE(set(0.001, {0, 0, 0}, 90, 0, 1000.0));
  expect(FeedMode::per_minute, 20'000.0);
}

TEST_F(Feed, BelowTheDigitsOfTheControlIsRefused) {
  const Status status = set(10, Vec3::Zero(), 0, 0, 0.5);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, Code::out_of_domain);
  EXPECT_EQ(status.error().cl_line, 17U);
  settings_.feed_decimals = 1;
  EXPECT_TRUE(set(10, Vec3::Zero(), 0, 0, 0.5));
}

TEST_F(Feed, ThatIsMissingIsRefusedAtItsLine) {
  const Status status = set(10, Vec3::Zero(), 0, 0, std::nullopt);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, Code::no_feed);
  EXPECT_EQ(status.error().cl_line, 17U);
}

/// 90 deg at 150 deg/s take 0.01 min.
TEST_F(Feed, OfATurnInPlaceIsTheTimeThatTheAxisNeeds) {
  limit_deg_s("C", 150.0);
  ASSERT_TRUE(set(0, Vec3::Zero(), 90, 0, 500.0));
  expect(FeedMode::per_minute, 9000.0);
  settings_.inverse_time = true;  // is for moves without TCP
  ASSERT_TRUE(set(0, Vec3::Zero(), 90, 0, 500.0));
  expect(FeedMode::per_minute, 9000.0);
  settings_.output = Output::axes;
  ASSERT_TRUE(set(0, Vec3::Zero(), 90, 0, 500.0));
  expect(FeedMode::inverse_time, 100.0);
}

/// C needs 0.6 s and A 3 s: 20 times a minute.
TEST_F(JointFeed, OfATurnInPlaceWaitsForTheSlowestAxis) {
  settings_.inverse_time = true;
  limit_deg_s("C", 150.0);
  limit_deg_s("A", 10.0);
  ASSERT_TRUE(set(0, Vec3::Zero(), 90, 30, 500.0));
  expect(FeedMode::inverse_time, 20.0);
  limit_mm_s("X", 10.0);  // 100 mm: 10 s
  ASSERT_TRUE(set(0, {100, 0, 0}, 90, 30, 500.0));
  expect(FeedMode::inverse_time, 6.0);
}

/// hypot(3, 4) = 5 deg at 10 deg/min take half a minute.
TEST_F(JointFeed, OfATurnInPlaceWithoutLimitsIsTheStatedRotaryFeed) {
  settings_.inverse_time = true;
  settings_.rotary_feed_rad_min = 10.0 * rad_per_deg;
  ASSERT_TRUE(set(0, Vec3::Zero(), 3, 4, 500.0));
  expect(FeedMode::inverse_time, 2.0);
}

TEST_F(Feed, OfATurnInPlaceNeedsALimitOfEveryAxisThatTurns) {
  limit_deg_s("C", 150.0);
  EXPECT_TRUE(set(0, Vec3::Zero(), 90, 0, 500.0));
  const Status status = set(0, Vec3::Zero(), 90, 1, 500.0);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, Code::no_rotary_feed);
  EXPECT_EQ(status.error().cl_line, 17U);
}

/// A CL way that vanishes in the digits printed is a turn in place for the control.
TEST_F(Feed, OfATipThatStandsInPrintIsThatOfATurnInPlace) {
  limit_deg_s("C", 150.0);
  const Posture from;
  Posture to;
  to.printed.first_rad = 90.0 * rad_per_deg;
  path::Block block;
  ASSERT_TRUE(
      (FeedRule{model_, settings_, word_columns(model_)}.set(block, from, to, 1e-4, 500.0)));
  EXPECT_NEAR(block.feed, 9000.0, 1e-6);
}

/// Blocks of a divided move share its time: 1/F adds up to length over feed.
TEST(FeedOfAProgram, OfDividedBlocksAddsUpToTheTimeOfTheMove) {
  sample::ProgramCase job{sample::trunnion_ac(), Output::axes};
  job.settings.inverse_time = true;
  job.feed_rate(800.0);
  job.rapid({40, 0, 10}, {0, 0.6, 0.8});
  job.point({40, 30, 10}, {0.6, 0, 0.8});
  job.event(path::Arc{.centre_wp_mm = {40, 50, 10}, .sweep_rad = pi / 2});
  job.point({60, 50, 10}, {0, -0.6, 0.8});
  const auto program = job.planned();
  ASSERT_TRUE(program) << program.error().message;
  double straight_min = 0.0, round_min = 0.0;
  int blocks = 0;
  for (const auto& block : program->motion.blocks) {
    if (block.kind != path::Block::Kind::line) continue;
    ASSERT_EQ(block.feed_mode, FeedMode::inverse_time);
    (block.point == 1 ? straight_min : round_min) += 1.0 / block.feed;
    ++blocks;
  }
  EXPECT_GT(blocks, 20);
  EXPECT_NEAR(straight_min, 30.0 / 800.0, 1e-12);
  EXPECT_NEAR(round_min, 0.5 * pi * 20.0 / 800.0, 1e-12);
  EXPECT_NEAR(program->programmed_time_s, 60.0 * (30.0 + 10.0 * pi) / 800.0, 1e-9);
}

}  // namespace
}  // namespace pentapost::plan
