#include "pentapost/plan/native_arc.hpp"

#include "sample/chains.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pentapost::plan {
namespace {

using Pieces = std::optional<std::vector<ArcPiece>>;

constexpr double tolerance_mm = 0.01;

/// Arcs of radius 10 about a centre, from `start_mm`, on one machine.
struct ArcCase {
  machine::Chain chain = sample::three_axis();
  Settings settings{};
  RotaryPair rotary{};
  Vec3 tool_axis = Vec3::UnitZ();
  Vec3 end_axis = tool_axis;
  Vec3 start_mm{10, 0, 5}, end_mm{0, 10, 5};
  path::Arc arc{.centre_wp_mm = {0, 0, 5}, .sweep_rad = pi / 2};

  ArcCase() {
    settings.output = Output::axes;
    settings.arcs = true;
    settings.tip_tolerance_mm = tolerance_mm;
  }
  Pieces pieces() const {
    const kinematics::Model model{chain};
    const JointRanges ranges;
    BlockMaker maker{model, ranges, settings, 0.0, false};
    const path::Segment segment{start_mm, tool_axis, end_mm, end_axis, &arc};
    const auto from = maker.posture(start_mm, rotary, 1);
    return native_arc(model, settings, maker, segment, rotary, from.value(), 1);
  }
  /// Ends the arc after `sweep_deg` about +Z.
  void sweep(double sweep_deg) {
    arc.sweep_rad = sweep_deg * rad_per_deg;
    end_mm = arc.centre_wp_mm +
             Vec3{10.0 * std::cos(arc.sweep_rad), 10.0 * std::sin(arc.sweep_rad), 0.0};
  }
};

TEST(NativeArc, AQuarterAcrossZIsOneBlockWithItsCentre) {
  const Pieces pieces = ArcCase{}.pieces();
  ASSERT_TRUE(pieces);
  ASSERT_EQ(pieces->size(), 1U);
  const ArcPiece& piece = pieces->front();
  EXPECT_EQ(piece.posture.word[0], 0);
  EXPECT_EQ(piece.posture.word[1], 10'000);
  EXPECT_EQ(piece.posture.word[2], 5'000);
  EXPECT_EQ(piece.centre.i, -10'000);
  EXPECT_EQ(piece.centre.j, 0);
  EXPECT_FALSE(piece.clockwise);
  EXPECT_EQ(piece.fraction, 1.0);
}

/// About -Z the same ends are three quarters the other way.
TEST(NativeArc, WithTheNormalAgainstTheToolItRunsClockwise) {
  ArcCase job;
  job.arc.normal_wp = -Vec3::UnitZ();
  job.arc.sweep_rad = 1.5 * pi;
  const Pieces pieces = job.pieces();
  ASSERT_TRUE(pieces);
  EXPECT_TRUE(pieces->front().clockwise);
  EXPECT_EQ(pieces->front().centre.i, -10'000);
}

TEST(NativeArc, NeedsAControlThatHasThem) {
  ArcCase job;
  job.settings.arcs = false;
  EXPECT_FALSE(job.pieces());
}

TEST(NativeArc, NeedsARestingToolAxis) {
  ArcCase job;
  job.chain = sample::trunnion_ac();
  ASSERT_TRUE(job.pieces());
  job.end_axis = Vec3{0, 1e-6, 1}.normalized();
  EXPECT_FALSE(job.pieces());
}

TEST(NativeArc, NeedsAControlThatRunsThemUnderTcp) {
  ArcCase job;
  job.chain = sample::trunnion_ac();
  job.settings.output = Output::tcp;
  EXPECT_FALSE(job.pieces());
  job.settings.arcs_with_tcp = true;
  EXPECT_TRUE(job.pieces());
}

TEST(NativeArc, InAPlaneAlongTheToolIsNone) {
  ArcCase job;
  job.arc.normal_wp = Vec3::UnitX();
  job.arc.centre_wp_mm = {10, 0, 15};
  job.end_mm = {10, 10, 15};
  EXPECT_FALSE(job.pieces());
}

/// With A30 the plane across the tool is that of X and Y of the joints, and not of the workpiece.
TEST(NativeArc, AcrossATiltedToolNeedsJointValues) {
  ArcCase job;
  job.chain = sample::trunnion_ac();
  job.rotary = {0.0, 30.0 * rad_per_deg};
  job.tool_axis = job.end_axis = Vec3{0.0, 0.5, 0.5 * std::sqrt(3.0)};
  const Vec3 across = job.tool_axis.cross(Vec3::UnitX());
  job.arc = {.centre_wp_mm = {0, 0, 0}, .normal_wp = job.tool_axis, .sweep_rad = pi / 2};
  job.start_mm = {10, 0, 0};
  job.end_mm = 10.0 * across;
  const Pieces pieces = job.pieces();
  ASSERT_TRUE(pieces);
  EXPECT_EQ(pieces->front().posture.word[1], 10'000);
  EXPECT_EQ(pieces->front().posture.word[2], 0);
  EXPECT_FALSE(pieces->front().clockwise);

  job.settings.output = Output::tcp;
  job.settings.arcs_with_tcp = true;
  EXPECT_FALSE(job.pieces());
}

/// A machine whose X counts the other way shows the arc in a mirror.
TEST(NativeArc, OnAMachineWithAMirroredAxisItRunsTheOtherWayRound) {
  ArcCase job;
  job.chain = sample::chain_of({}, {sample::linear("X", -Vec3::UnitX()), sample::y(), sample::z()});
  const Pieces pieces = job.pieces();
  ASSERT_TRUE(pieces);
  EXPECT_TRUE(pieces->front().clockwise);
  EXPECT_EQ(pieces->front().centre.i, 10'000);
  EXPECT_EQ(pieces->front().centre.j, 0);
}

/// Axes that are not square to each other make an ellipse of the words.
TEST(NativeArc, OnSkewAxesIsNone) {
  ArcCase job;
  job.chain = sample::chain_of({}, {sample::x(), sample::linear("Y", {0.1, 1, 0}), sample::z()});
  EXPECT_FALSE(job.pieces());
}

TEST(NativeArc, AFullCircleIsTwoHalves) {
  ArcCase job;
  job.arc.sweep_rad = 2.0 * pi;
  job.end_mm = job.start_mm;
  const Pieces pieces = job.pieces();
  ASSERT_TRUE(pieces);
  ASSERT_EQ(pieces->size(), 2U);
  EXPECT_EQ((*pieces)[0].fraction, 0.5);
  EXPECT_EQ((*pieces)[0].posture.word[0], -10'000);
  EXPECT_EQ((*pieces)[0].centre.i, -10'000);
  EXPECT_EQ((*pieces)[1].posture.word[0], 10'000);
  EXPECT_EQ((*pieces)[1].centre.i, 10'000);
}

/// 359.9 deg: one block of it could be read as 0.1 deg too little or a turn too much.
TEST(NativeArc, NearlyAFullCircleIsTwoBlocks) {
  ArcCase job;
  job.sweep(359.9);
  const Pieces pieces = job.pieces();
  ASSERT_TRUE(pieces);
  ASSERT_EQ(pieces->size(), 2U);
  EXPECT_EQ(pieces->back().posture.word[1], -17);  // 10 sin(-0.1 deg) = -0.01745
}

TEST(NativeArc, OfLessThanThreeHundredFiftyDegreesIsOneBlock) {
  ArcCase job;
  job.sweep(349.9);
  const Pieces pieces = job.pieces();
  ASSERT_TRUE(pieces);
  EXPECT_EQ(pieces->size(), 1U);
}

TEST(NativeArc, AHelixNeedsAControlThatHasThem) {
  ArcCase job;
  job.arc.sweep_rad = 4.5 * pi;
  job.end_mm.z() = 11.0;
  EXPECT_FALSE(job.pieces());
  job.settings.helices = true;
  const Pieces pieces = job.pieces();
  ASSERT_TRUE(pieces);
  ASSERT_EQ(pieces->size(), 5U);
  EXPECT_EQ((*pieces)[0].posture.word[2], 6'200);
  EXPECT_EQ((*pieces)[4].posture.word[2], 11'000);
}

TEST(NativeArc, OfMillionsOfTurnsIsNone) {
  ArcCase job;
  job.end_mm = job.start_mm;
  job.arc.sweep_rad = 2.0 * pi * 1e12;
  EXPECT_FALSE(job.pieces());
}

TEST(NativeArc, WhoseEndsArePrintedAlikeIsNone) {
  ArcCase job;
  job.sweep(0.001);  // 0.17 micrometres
  EXPECT_FALSE(job.pieces());
}

/// The digits leave a chord of 0.001 mm along the radius: the control would run half a turn.
TEST(NativeArc, WhoseDigitsTurnItsChordIsNone) {
  ArcCase job;
  job.settings.tip_tolerance_mm = 0.1;
  job.start_mm = {0.01750001, 0, 5};
  job.arc.sweep_rad = 0.57 * rad_per_deg;
  job.end_mm = {job.start_mm.x() * std::cos(job.arc.sweep_rad),
                job.start_mm.x() * std::sin(job.arc.sweep_rad), 5};
  EXPECT_FALSE(job.pieces());
}

TEST(NativeArc, WithRadiiThatDifferBeyondTheToleranceIsNone) {
  ArcCase job;
  job.end_mm.y() = 10.02;
  EXPECT_FALSE(job.pieces());
  job.end_mm.y() = 10.002;
  EXPECT_TRUE(job.pieces());
}

TEST(NativeArc, OutOfRangeIsNone) {
  ArcCase job;
  const kinematics::Model model{job.chain};
  JointRanges ranges;
  ranges.linear_mm[1] = Range<double>{-1.0, 9.0};
  BlockMaker maker{model, ranges, job.settings, 0.0, true};
  const path::Segment segment{job.start_mm, job.tool_axis, job.end_mm, job.tool_axis, &job.arc};
  const auto from = maker.posture(job.start_mm, {}, 1);
  EXPECT_FALSE(native_arc(model, job.settings, maker, segment, {}, from.value(), 1));
}

/// The circle that the control makes of the words keeps the tolerance all the way.
TEST(NativeArc, AsTheControlRunsItStaysWithinTheToleranceOfTheClArc) {
  std::mt19937_64 random{5};
  std::uniform_real_distribution<double> place_mm{-50.0, 50.0}, angle_rad{-pi, pi},
      exponent{-2.0, 3.0}, sweep_exponent{-4.0, 1.0};
  int native = 0;
  for (int i = 0; i < 20'000; ++i) {
    ArcCase job;
    const double radius_mm = std::pow(10.0, exponent(random)), start_rad = angle_rad(random);
    const double sweep_rad = std::pow(10.0, sweep_exponent(random));
    job.arc.centre_wp_mm = {place_mm(random), place_mm(random), 5.0};
    job.arc.normal_wp = (i % 2 == 0 ? 1.0 : -1.0) * Vec3::UnitZ();
    job.arc.sweep_rad = sweep_rad;
    const double sense = job.arc.normal_wp.z();
    const auto on_arc = [&](double turned_rad) -> Vec3 {
      const double at_rad = start_rad + sense * turned_rad;
      return job.arc.centre_wp_mm + radius_mm * Vec3{std::cos(at_rad), std::sin(at_rad), 0.0};
    };
    job.start_mm = on_arc(0.0);
    job.end_mm = on_arc(sweep_rad);
    const Pieces pieces = job.pieces();
    if (!pieces) continue;
    ++native;
    Eigen::Vector2d start{std::round(1e3 * job.start_mm.x()) / 1e3,
                          std::round(1e3 * job.start_mm.y()) / 1e3};
    double turned_rad = 0.0;
    for (const ArcPiece& piece : *pieces) {
      const Eigen::Vector2d centre = start + 1e-3 * Eigen::Vector2d{piece.centre.i, piece.centre.j};
      const Eigen::Vector2d end{1e-3 * static_cast<double>(piece.posture.word[0]),
                                1e-3 * static_cast<double>(piece.posture.word[1])};
      const Eigen::Vector2d from_arm = start - centre, to_arm = end - centre;
      double printed_rad =
          (piece.clockwise ? -1.0 : 1.0) *
          std::atan2(from_arm.x() * to_arm.y() - from_arm.y() * to_arm.x(), from_arm.dot(to_arm));
      if (printed_rad <= 0.0) printed_rad += 2.0 * pi;
      ASSERT_EQ(piece.clockwise, sense < 0.0);
      const double share_rad = piece.fraction * sweep_rad - turned_rad;
      ASSERT_NEAR(printed_rad * radius_mm, share_rad * radius_mm, 2.0 * tolerance_mm) << i;
      for (int step = 0; step <= 20; ++step) {
        const double at_rad = (piece.clockwise ? -1.0 : 1.0) * printed_rad * step / 20.0;
        const Eigen::Vector2d at = centre + Eigen::Rotation2Dd{at_rad} * from_arm;
        const double off_mm = std::abs((at - job.arc.centre_wp_mm.head<2>()).norm() - radius_mm);
        ASSERT_LE(off_mm, tolerance_mm) << i;
      }
      ASSERT_LE(std::abs(from_arm.norm() - to_arm.norm()), tolerance_mm) << i;
      start = end;
      turned_rad = piece.fraction * sweep_rad;
    }
  }
  EXPECT_GT(native, 3000);
}

}  // namespace
}  // namespace pentapost::plan
