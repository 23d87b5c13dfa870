#include "pentapost/plan/pole_bump.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pentapost::plan {
namespace {

constexpr double delta_rad = 1.0 * rad_per_deg;

/// A straight passage of +Z at delta: the axis at the angle `along_rad` from the nearest place.
Vec3 passing(double along_rad) {
  return {std::cos(along_rad) * std::sin(delta_rad), std::sin(along_rad),
          std::cos(along_rad) * std::cos(delta_rad)};
}

/// Reach of the bump: sqrt(2 delta), as a chord.
const double reach_rad = std::sqrt(2.0 * delta_rad);
const double reach_chord = 2.0 * std::sin(0.5 * reach_rad);

PoleBump bump() {
  PoleBump made{Vec3::UnitZ(), passing(0.0), {reach_chord, reach_chord}};
  const GreatCircle turn{passing(-0.3), passing(0.3)};
  const auto in = turn.axis(made.divisions(turn, 0.0, 0.5, PoleBump::before).back());
  const auto out = turn.axis(made.divisions(turn, 0.5, 1.0, PoleBump::after).front());
  EXPECT_TRUE(made.set_core({in, out}));
  return made;
}

TEST(PoleBump, LeadsTheNearestPlaceToThePole) {
  EXPECT_LT((bump().bent(passing(0.0), PoleBump::before, 0.0) - Vec3::UnitZ()).norm(), 1e-15);
}

TEST(PoleBump, MovesNoAxisByMoreThanTheDistanceOfThePassage) {
  const PoleBump made = bump();
  for (double along = 0.0; along < 0.3; along += 1e-4) {
    const Vec3 axis = passing(along);
    EXPECT_LE(angle_between_rad(axis, made.bent(axis, PoleBump::after, 0.0)),
              delta_rad * (1.0 + 1e-9));
  }
}

TEST(PoleBump, LeavesTheAxisAloneBeyondItsReach) {
  const Vec3 axis = passing(0.19);  // the reach is 10.7 deg = 0.187 rad
  EXPECT_LT((bump().bent(axis, PoleBump::after, 0.0) - axis).norm(), 1e-15);
}

/// Azimuth about the pole for each radian along the path: delta / rho^2 = 1/2 of (2 - 3 x^2) in
/// the plane, at most 1 in size; against 1 / sin(1 deg) = 57.3 of the passage itself.
TEST(PoleBump, TurnsTheFirstJointAboutAsFastAsTheToolAxis) {
  const PoleBump made = bump();
  const double step = 1e-5;
  double largest = 0.0;
  for (double along = 0.003; along < 0.19; along += 1e-3) {
    const Vec3 from = made.bent(passing(along), PoleBump::after, 0.0);
    const Vec3 to = made.bent(passing(along + step), PoleBump::after, 0.0);
    const double turned = wrapped_rad(std::atan2(to.y(), to.x()) - std::atan2(from.y(), from.x()));
    largest = std::max(largest, std::abs(turned) / step);
  }
  EXPECT_GT(largest, 0.9);
  EXPECT_LT(largest, 1.1);
}

TEST(PoleBump, ItsCoreIsOneGreatCircleThroughThePole) {
  const PoleBump made = bump();
  const double core_rad = 0.9 * reach_rad * PoleBump::core;
  const Vec3 in = made.bent(passing(-core_rad), PoleBump::before, 0.0);
  const Vec3 out = made.bent(passing(core_rad), PoleBump::after, 0.0);
  EXPECT_LT(std::abs(Vec3::UnitZ().dot(in.cross(out).normalized())), 1e-12);
  EXPECT_EQ(turn_ratio(Vec3::UnitZ(), in, out), 0.0);
}

TEST(PoleBump, DividesALongMoveByFortyPercentOrATenth) {
  const PoleBump made = bump();
  const GreatCircle turn{passing(0.0), passing(0.5)};
  const auto fractions = made.divisions(turn, 0.0, 1.0, PoleBump::after);
  ASSERT_GT(fractions.size(), 10U);
  EXPECT_LT(fractions.size(), 25U);
  double before = made.x_of(turn.axis(fractions.front()), PoleBump::after);
  EXPECT_NEAR(before, PoleBump::core, 1e-9);
  for (const double fraction : fractions) {
    const double x = made.x_of(turn.axis(fraction), PoleBump::after);
    EXPECT_LE(x - before, 0.42 * before + 1e-9);
    EXPECT_LE(x - before, 0.1 + 1e-9);
    before = x;
  }
  EXPECT_NEAR(before, 1.0, 1e-9);
}

/// sin(foot) / sin^2(distance): 1 / sin(1 deg) where the foot lies on the piece.
TEST(PoleBump, TurnRatioOfAPassageIsOneOverTheSineOfItsDistance) {
  EXPECT_NEAR(turn_ratio(Vec3::UnitZ(), passing(-0.1), passing(0.1)), 57.2987, 1e-3);
}

}  // namespace
}  // namespace pentapost::plan
