#include "pentapost/plan/retract.hpp"

#include "lib/plan/program_case.hpp"

#include <gtest/gtest.h>

namespace pentapost::plan {
namespace {

using Lines = std::vector<std::string>;

/// A trunnion with ranges of Y and Z whose tool, gauge length 0, stands at a place of the path.
struct RetractCase {
  machine::Chain chain =
      sample::chain_of({sample::rotary("C", Vec3::UnitZ()), sample::rotary("A", Vec3::UnitX())},
                       {sample::x(), sample::linear("Y", Vec3::UnitY(), Range<double>{-1000, 40}),
                        sample::linear("Z", Vec3::UnitZ(), Range<double>{-1000, 300})});
  kinematics::Model model{chain};
  JointRanges ranges = joint_ranges(chain, model);
  Settings settings{};
  path::ToolPath path{};
  path::Motion motion{};
  RetractPlace place{.tip_mm = {10, 20, 30}, .axis = Vec3::UnitZ(), .point = 0, .cl_line = 7};
  bool check_linear = true;

  RetractCase() {
    path.add_event(6, path::FeedRate{.value = 400.0});
    path.add_point(place.tip_mm, place.axis, 7, path::Move::feed);
  }
  BlockMaker maker() const { return {model, ranges, settings, 0.0, check_linear}; }

  Result<Posture> reposition(const RotaryPair& before, const RotaryPair& after) {
    motion = {};
    motion.letters = word_columns(model).letters;
    motion.output = settings.output;
    Frame frame{model, path, settings, motion};
    frame.take_events(0);
    motion.actions.clear();
    frame.tcp_on();
    BlockMaker made = maker();
    return retract_and_reposition(place, before, after, settings, check_linear, made, frame);
  }
  std::optional<Posture> above(double distance_mm, const RotaryPair& rotary = {}) const {
    BlockMaker made = maker();
    return posture_above(place, rotary, distance_mm, made);
  }
};

TEST(PostureAbove, LiesAlongTheToolAxis) {
  RetractCase job;
  job.place.axis = {0.0, 0.6, 0.8};
  const auto found = job.above(10.0);
  ASSERT_TRUE(found);
  EXPECT_NEAR((found->tip_mm - Vec3{10, 26, 38}).norm(), 0.0, 1e-12);
}

/// Z ends at 300, 270 above the place: 400 does not fit, half of it does.
TEST(PostureAbove, IsNearerWhereTheRangeEnds) {
  const RetractCase job;
  const auto found = job.above(400.0);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->tip_mm.z(), 230.0);
}

TEST(PostureAbove, NeedsAMillimetreOfRoom) {
  RetractCase job;
  job.place.tip_mm.z() = 299.5;
  EXPECT_FALSE(job.above(100.0));
  job.place.tip_mm.z() = 298.0;
  EXPECT_TRUE(job.above(100.0));
}

/// Away by feed, up, the rotary axes alone without TCP, back over the place, down by feed.
TEST(Retract, TurnsTheRotaryAxesAtTheSafeEndWithTcpOff) {
  RetractCase job;
  job.check_linear = false;
  job.settings.plunge_feed_mm_min = 150.0;
  const auto back = job.reposition({0.0, 0.0}, {pi, 0.0});
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(sample::outline(job.motion),
            (Lines{"tcp on", "line X10 Y20 Z130 A0 C0 F150 off path", "tcp off", "safe retract",
                   "rapid A0 C180 off path", "tcp on", "rapid X10 Y20 Z130 A0 C180 off path",
                   "line X10 Y20 Z30 A0 C180 F150 off path"}));
}

TEST(Retract, ComesBackToExactlyThePlace) {
  RetractCase job;
  job.place.tip_mm = {1.2345, -2.3456, 3.4567};
  job.settings.output = Output::axes;
  const RotaryPair after{1.25, 0.0};
  const auto back = job.reposition({0.25, 0.0}, after);
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_LE((back->tip_mm - job.place.tip_mm).norm(), 0.5e-3 * std::sqrt(3.0) + 1e-12);
  EXPECT_EQ(job.motion.blocks.back().word, back->word);
}

TEST(Retract, WithoutAPlungeFeedTheActiveOneHolds) {
  RetractCase job;
  ASSERT_TRUE(job.reposition({0.0, 0.0}, {pi, 0.0}));
  EXPECT_EQ(job.motion.blocks.front().feed, 400.0);
  EXPECT_EQ(job.motion.blocks.back().feed, 400.0);
}

/// Z ends at 300: with a known travel the tool goes there, and not by the setting of 100 mm.
TEST(Retract, GoesToTheEndOfTheTravelWhereThatIsKnown) {
  RetractCase job;
  ASSERT_TRUE(job.reposition({0.0, 0.0}, {0.5, 0.0}));
  EXPECT_EQ(job.motion.blocks.front().word[2], 300'000);
}

/// A at 30 deg: the tool along (0, 0.5, 0.866) keeps the joint Y = 0.866 * 20 - 0.5 * 30; the way
/// is that of Z, from 0.5 * 20 + 0.866 * 30 = 35.981 to 300.
TEST(Retract, OfATiltedToolIsMeasuredAlongItsAxis) {
  RetractCase job;
  job.settings.output = Output::axes;
  job.place.axis = {0.0, 0.5, 0.5 * std::sqrt(3.0)};
  const double tilt_rad = pi / 6.0;
  ASSERT_TRUE(job.reposition({0.0, tilt_rad}, {2.0 * pi, tilt_rad}));
  const auto& blocks = job.motion.blocks;
  EXPECT_EQ(blocks.front().word[2], 300'000);
  EXPECT_EQ(blocks.front().word[1], 2'321);
  EXPECT_EQ(blocks.back().word[2], 35'981);
}

/// On a fork head with the tool across, along X, it is the travel of X that ends the retract.
TEST(Retract, OfAHeadThatTurnsEndsWithTheTravelAlongTheTool) {
  const machine::Chain chain = sample::chain_of(
      {}, {sample::linear("X", Vec3::UnitX(), Range<double>{-500, 200}), sample::y(), sample::z(),
           sample::rotary("C", Vec3::UnitZ()), sample::rotary("B", Vec3::UnitY())});
  RetractCase job;
  job.model = kinematics::Model{chain};
  job.ranges = joint_ranges(chain, job.model);
  job.place.axis = Vec3::UnitX();
  const RotaryPair before{0.0, pi / 2.0}, after{2.0 * pi, pi / 2.0};
  ASSERT_TRUE(job.reposition(before, after));
  EXPECT_NEAR(static_cast<double>(job.motion.blocks.front().word[0]), 200'000.0, 1.0);
}

/// The table turned by 180 deg brings Y to -20, where there is room; by 90 deg Y is at -10, by
/// -90 deg at 10, and beyond 40 nothing reaches.
TEST(Retract, NeedsRoomWithTheNewRotaryValuesToo) {
  RetractCase job;
  job.place.tip_mm = {50, 20, 30};
  EXPECT_TRUE(job.reposition({0.0, 0.0}, {pi, 0.0}));
  const auto back = job.reposition({0.0, 0.0}, {pi / 2.0, 0.0});  // Y = 50
  ASSERT_FALSE(back);
  EXPECT_EQ(back.error().code, Code::linear_range);
  EXPECT_EQ(back.error().cl_line, 7U);
  EXPECT_TRUE(job.motion.blocks.empty());
}

/// A turns 20 mm beside C: the tool axis (0, 0.5, 0.866) is reached with A30 C0 and with A-30 C180,
/// and Z is 2 * 20 * 0.5 = 20 higher in one of them. That one ends the retract, in either order.
TEST(Retract, EndsWhereEitherPostureMeetsTheRange) {
  const machine::Chain chain = sample::chain_of(
      {sample::rotary("C", Vec3::UnitZ()), sample::rotary("A", Vec3::UnitX(), {0, 20, 0})},
      {sample::x(), sample::y(), sample::linear("Z", Vec3::UnitZ(), Range<double>{-1000, 300})});
  const RotaryPair one{0.0, pi / 6.0}, other{pi, -pi / 6.0};
  for (const bool reversed : {false, true}) {
    RetractCase job;
    job.model = kinematics::Model{chain};
    job.ranges = joint_ranges(chain, job.model);
    job.settings.output = Output::axes;
    job.place.axis = {0.0, 0.5, 0.5 * std::sqrt(3.0)};
    ASSERT_TRUE(job.reposition(reversed ? other : one, reversed ? one : other));
    const auto& blocks = job.motion.blocks;
    ASSERT_EQ(blocks.size(), 4U);
    const auto away = blocks[0].word[2], back = blocks[2].word[2];
    EXPECT_EQ(std::max(away, back), 300'000);
    EXPECT_EQ(std::abs(away - back), 20'000);
  }
}

TEST(Retract, WithoutRoomIsRefusedAtItsLine) {
  RetractCase job;
  job.place.tip_mm.z() = 299.5;
  const auto back = job.reposition({0.0, 0.0}, {0.1, 0.0});
  ASSERT_FALSE(back);
  EXPECT_EQ(back.error().code, Code::linear_range);
  EXPECT_EQ(back.error().cl_line, 7U);
}

}  // namespace
}  // namespace pentapost::plan
