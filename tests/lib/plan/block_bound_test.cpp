#include "pentapost/plan/block_bound.hpp"

#include "pentapost/kinematics/inverse.hpp"
#include "sample/chains.hpp"

#include <gtest/gtest.h>

namespace pentapost::plan {
namespace {

/// Dense sampling of one block: distance of the tip from the part of the straight move, and angle
/// to the great circle at the fraction of the block.
BlockBound sampled(const BlockMaker& maker, const path::Segment& segment, const Posture& from,
                   const Posture& to, bool in_joints) {
  BlockBound largest;
  constexpr int count = 400;
  // The middle of a block whose ends are placed around s is the block at s.
  const auto mixed = [](const Posture& x, const Posture& y, double s) {
    Posture posture = x;
    posture.printed = {x.printed.first_rad + s * (y.printed.first_rad - x.printed.first_rad),
                       x.printed.second_rad + s * (y.printed.second_rad - x.printed.second_rad)};
    posture.linear_mm = x.linear_mm + s * (y.linear_mm - x.linear_mm);
    posture.tip_mm = x.tip_mm + s * (y.tip_mm - x.tip_mm);
    return posture;
  };
  for (int i = 0; i <= count; ++i) {
    const double s = static_cast<double>(i) / count;
    const Posture there = mixed(from, to, s);
    const Posture at = maker.middle(there, there);
    const double nearest = segment.nearest_fraction(at.tip_mm, s);
    largest.tip_mm = std::max(largest.tip_mm, (at.tip_mm - segment.tip_mm(nearest)).norm());
    if (!in_joints)
      largest.axis_rad = std::max(largest.axis_rad, angle_between_rad(at.axis, segment.axis(s)));
  }
  return largest;
}

void expect_upper_bounds(Output output) {
  std::mt19937_64 random{7};
  std::uniform_real_distribution<double> angle_rad{-2.0, 2.0}, length_mm{-1.0, 1.0};
  for (const auto& sample : sample::chains()) {
    const kinematics::Model model{sample.chain};
    if (model.rotary_count != 2) continue;
    Settings settings;
    settings.output = output;
    settings.decimals_mm = 4;
    settings.decimals_deg = 4;
    const JointRanges ranges;
    BlockMaker maker{model, ranges, settings, 120.0, false};
    for (int i = 0; i < 40; ++i) {
      const double step = std::pow(10.0, -1.0 - (i % 4));
      const RotaryPair pair{angle_rad(random), angle_rad(random)};
      const RotaryPair next{pair.first_rad + step * angle_rad(random),
                            pair.second_rad + step * angle_rad(random)};
      const Vec3 tip_mm{30.0 * length_mm(random), 30.0 * length_mm(random), 40.0};
      const Vec3 next_mm =
          tip_mm + 10.0 * step * Vec3{length_mm(random), length_mm(random), length_mm(random)};
      const auto from = maker.posture(tip_mm, pair, 1);
      const auto to = maker.posture(next_mm, next, 1);
      if (!from || !to) continue;  // at a linear singularity
      const path::Segment segment{tip_mm, from->axis, next_mm, to->axis};
      const BlockBound bound = bound_block(model, settings, maker, segment, 0.0, *from, 1.0, *to);
      const BlockBound truth = sampled(maker, segment, *from, *to, output == Output::axes);
      EXPECT_GE(bound.tip_mm, truth.tip_mm - 1e-9) << sample.name << ' ' << i;
      EXPECT_GE(bound.axis_rad, truth.axis_rad - 1e-9) << sample.name << ' ' << i;
    }
  }
}

/// Nearest to the tip is any place of a circle smaller than the tip's deviation from it: the tool
/// axis may be held against that of either end of the block.
TEST(BlockBound, OnACircleSmallerThanTheDeviationTheAxisCountsFromEitherEnd) {
  const kinematics::Model model{sample::trunnion_ac()};
  Settings settings;
  settings.output = Output::axes;
  const JointRanges ranges;
  BlockMaker maker{model, ranges, settings, 0.0, false};
  const double tilt_from = 0.30, tilt_to = 0.33;
  const auto axis = [](double tilt) { return Vec3{0.0, std::sin(tilt), std::cos(tilt)}; };
  const Vec3 start_mm{50.0, 0.03, 40.0};
  const auto from = maker.posture(start_mm + Vec3{0.05, 0.0, 0.0}, {0.0, tilt_from}, 1);
  const auto to = maker.posture(start_mm + Vec3{0.05, 0.0, 0.0}, {0.0, tilt_to}, 1);
  ASSERT_TRUE(from && to);
  const path::Arc arc{.centre_wp_mm = {50.0, 0.0, 40.0}, .sweep_rad = 2.0 * pi};
  const path::Segment segment{start_mm, axis(tilt_from), start_mm, axis(tilt_to), &arc};
  const BlockBound bound = bound_block(model, settings, maker, segment, 0.0, *from, 1.0, *to);
  EXPECT_GE(bound.tip_mm, 0.03);
  EXPECT_GE(bound.axis_rad, tilt_to - tilt_from);
}

TEST(BlockBound, LiesAboveEverySampleOfAJointLinearBlock) { expect_upper_bounds(Output::axes); }
TEST(BlockBound, LiesAboveEverySampleOfATcpBlock) { expect_upper_bounds(Output::tcp); }

}  // namespace
}  // namespace pentapost::plan
