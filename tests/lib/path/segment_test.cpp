#include "pentapost/path/segment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pentapost::path {
namespace {

Vec3 tilted(double angle_rad) { return {0.0, std::sin(angle_rad), std::cos(angle_rad)}; }

Arc quarter_about_z() {
  return {.centre_wp_mm = {1, 2, 0}, .normal_wp = Vec3::UnitZ(), .sweep_rad = pi / 2};
}

TEST(Segment, EndsAreExactOnALine) {
  const Segment move{{0.1, 0.2, 0.3}, tilted(0.1), {7.7, -1.3, 0.9}, tilted(1.2)};

  EXPECT_EQ(move.tip_mm(0.0), Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(move.tip_mm(1.0), Vec3(7.7, -1.3, 0.9));
  EXPECT_EQ(move.axis(0.0), tilted(0.1));
  EXPECT_EQ(move.axis(1.0), tilted(1.2));
}

TEST(Segment, TurnsTheAxisEvenlyOnTheGreatCircle) {
  const Segment move{Vec3::Zero(), tilted(0.2), Vec3::UnitX(), tilted(1.4)};

  EXPECT_NEAR(move.axis_angle_rad(), 1.2, 1e-15);
  EXPECT_LT((move.axis(0.25) - tilted(0.5)).norm(), 1e-15);
}

TEST(Segment, KeepsAVerySmallTurn) {
  const Segment move{Vec3::Zero(), tilted(0.7), Vec3::UnitX(), tilted(0.7 + 1e-9)};

  EXPECT_NEAR(move.axis_angle_rad(), 1e-9, 1e-15);
  EXPECT_LT((move.axis(0.5) - tilted(0.7 + 0.5e-9)).norm(), 1e-15);
}

TEST(Segment, KeepsTheAxisOfUnitLengthBetweenOppositeAxes) {
  const Segment move{Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitX(), -Vec3::UnitZ()};

  EXPECT_NEAR(move.axis_angle_rad(), pi, 1e-15);
  for (const double fraction : {0.1, 0.5, 0.9})
    EXPECT_NEAR(move.axis(fraction).norm(), 1.0, 1e-15) << fraction;
}

TEST(Segment, RunsAnArcRightHandedAboutItsNormal) {
  const Arc arc = quarter_about_z();
  const Segment move{{11, 2, 0}, Vec3::UnitZ(), {1, 12, 0}, Vec3::UnitZ(), &arc};

  const double half = 10.0 / std::sqrt(2.0);
  EXPECT_LT((move.tip_mm(0.5) - Vec3(1 + half, 2 + half, 0)).norm(), 1e-14);
  EXPECT_NEAR(move.length_mm(), 5.0 * pi, 1e-13);
}

TEST(Segment, RunsTheOtherWayRoundWhereTheNormalIsNegated) {
  const Arc arc{.centre_wp_mm = {1, 2, 0}, .normal_wp = -Vec3::UnitZ(), .sweep_rad = 1.5 * pi};
  const Segment move{{11, 2, 0}, Vec3::UnitZ(), {1, 12, 0}, Vec3::UnitZ(), &arc};

  EXPECT_LT((move.tip_mm(1.0 / 3.0) - Vec3(1, -8, 0)).norm(), 1e-14);
}

TEST(Segment, RunsWholeTurnsOfAHelix) {
  const Arc arc{.centre_wp_mm = {0, 0, 0}, .normal_wp = Vec3::UnitZ(), .sweep_rad = 4 * pi};
  const Segment move{{3, 0, 0}, Vec3::UnitZ(), {3, 0, 2}, Vec3::UnitZ(), &arc};

  EXPECT_LT((move.tip_mm(0.25) - Vec3(-3, 0, 0.5)).norm(), 1e-14);
  EXPECT_LT((move.tip_mm(0.5) - Vec3(3, 0, 1)).norm(), 1e-14);
  EXPECT_NEAR(move.length_mm(), std::hypot(12 * pi, 2.0), 1e-12);
}

// CL files print 4 to 7 digits: the sweep of the statement misses the end point by a little.
TEST(Segment, IsContinuousUpToAnEndThatMissesTheSweepByRounding) {
  const Arc arc = quarter_about_z();
  const Vec3 end{1.004, 12.003, 0.001};
  const Segment move{{11, 2, 0}, Vec3::UnitZ(), end, Vec3::UnitZ(), &arc};

  EXPECT_LT((move.tip_mm(1.0 - 1e-12) - end).norm(), 1e-9);
}

TEST(Segment, KeepsAFullCircleWhoseEndIsBeforeItsStartByRounding) {
  const Arc arc{.centre_wp_mm = {0, 0, 0}, .normal_wp = Vec3::UnitZ(), .sweep_rad = 2 * pi};
  const Segment move{{10, 0, 0}, Vec3::UnitZ(), {10, -0.001, 0}, Vec3::UnitZ(), &arc};

  EXPECT_NEAR(move.sweep_rad(), 2 * pi - 1e-4, 1e-9);
  EXPECT_LT((move.tip_mm(0.5) - Vec3(-10, 0, 0)).norm(), 1e-3);
}

TEST(Segment, TakesAnArcWithoutRadiusWithoutLosingItsNumbers) {
  const Arc arc{.centre_wp_mm = {5, 5, 5}, .normal_wp = Vec3::UnitZ(), .sweep_rad = 1.0};
  const Segment move{{5, 5, 5}, Vec3::UnitZ(), {5, 5, 5}, Vec3::UnitZ(), &arc};

  EXPECT_TRUE(move.tip_mm(0.5).allFinite());
  EXPECT_EQ(move.nearest_fraction({5, 5, 5}, 0.5), 0.0);
}

/// Rates and accelerations against central differences, on a line, a circle and a spiral helix.
TEST(Segment, HasItsDerivatives) {
  const Arc arc = quarter_about_z();
  const Segment moves[] = {
      Segment{{0.1, 0.2, 0.3}, tilted(0.1), {7.7, -1.3, 0.9}, tilted(1.2)},
      Segment{{11, 2, 0}, tilted(0.3), {1, 12, 0}, tilted(0.3), &arc},
      Segment{{11, 2, 0}, tilted(0.4), {1, 11.5, 3}, tilted(-0.2), &arc},
  };
  constexpr double h = 1e-4;
  for (const Segment& move : moves)
    for (const double s : {0.2, 0.5, 0.9}) {
      const Vec3 tip_rate = (move.tip_mm(s + h) - move.tip_mm(s - h)) / (2.0 * h);
      const Vec3 tip_acceleration =
          (move.tip_mm(s + h) - 2.0 * move.tip_mm(s) + move.tip_mm(s - h)) / (h * h);
      const Vec3 axis_rate = (move.axis(s + h) - move.axis(s - h)) / (2.0 * h);
      const Vec3 axis_acceleration =
          (move.axis(s + h) - 2.0 * move.axis(s) + move.axis(s - h)) / (h * h);
      EXPECT_LT((move.tip_rate_mm(s) - tip_rate).norm(), 1e-6);
      EXPECT_LT((move.tip_acceleration_mm(s) - tip_acceleration).norm(), 1e-5);
      EXPECT_LT((move.axis_rate(s) - axis_rate).norm(), 1e-8);
      EXPECT_LT((move.axis_acceleration(s) - axis_acceleration).norm(), 1e-6);
    }
}

TEST(Segment, FindsTheNearestFractionOnALine) {
  const Segment move{{0, 0, 0}, Vec3::UnitZ(), {10, 0, 0}, Vec3::UnitZ()};

  EXPECT_DOUBLE_EQ(move.nearest_fraction({2.5, 3, -1}, 0.0), 0.25);
  EXPECT_EQ(move.nearest_fraction({-4, 0, 0}, 0.0), 0.0);
  EXPECT_EQ(move.nearest_fraction({14, 0, 0}, 0.0), 1.0);
}

TEST(Segment, ProjectsBeyondItsEnds) {
  const Segment move{{0, 0, 0}, Vec3::UnitZ(), {10, 0, 0}, Vec3::UnitZ()};

  EXPECT_DOUBLE_EQ(move.projected_fraction({-4, 1, 0}, 0.0), -0.4);
  EXPECT_DOUBLE_EQ(move.projected_fraction({14, 1, 0}, 0.0), 1.4);
}

TEST(Segment, GivesFractionZeroWhereTheTipStandsStill) {
  const Segment move{{1, 1, 1}, Vec3::UnitZ(), {1, 1, 1}, Vec3::UnitX()};

  EXPECT_EQ(move.nearest_fraction({9, 9, 9}, 0.7), 0.0);
}

TEST(Segment, TellsTheTurnsOfAHelixApartByTheFractionNearby) {
  const Arc arc{.centre_wp_mm = {0, 0, 0}, .normal_wp = Vec3::UnitZ(), .sweep_rad = 6 * pi};
  const Segment move{{3, 0, 0}, Vec3::UnitZ(), {3, 0, 3}, Vec3::UnitZ(), &arc};

  EXPECT_NEAR(move.nearest_fraction({0, 3, 0.25}, 0.1), 1.0 / 12.0, 1e-14);
  EXPECT_NEAR(move.nearest_fraction({0, 3, 1.25}, 0.45), 5.0 / 12.0, 1e-14);
  EXPECT_NEAR(move.nearest_fraction({0, 3, 2.25}, 0.7), 9.0 / 12.0, 1e-14);
}

/// A radius of a hundredth on a rise of 10: half a radius beside the helix says little of the
/// place.
TEST(Segment, FindsThePlaceOnASteepHelixByTheHeight) {
  const Arc arc{.centre_wp_mm = {0, 0, 0}, .normal_wp = Vec3::UnitZ(), .sweep_rad = pi};
  const Segment move{{0.01, 0, 0}, Vec3::UnitZ(), {-0.01, 0, 10}, Vec3::UnitZ(), &arc};

  EXPECT_NEAR(move.nearest_fraction({0.01, 0, 5}, 0.5), 0.5, 1e-5);
}

TEST(Segment, FindsItsOwnPointsOnRandomArcs) {
  std::mt19937_64 random{42};
  std::uniform_real_distribution<double> coordinate{-50.0, 50.0}, angle{0.01, 12.0},
      share{0.0, 1.0};
  for (int i = 0; i < 10'000; ++i) {
    SCOPED_TRACE(i);
    const Vec3 normal =
        Vec3{coordinate(random), coordinate(random), coordinate(random)}.normalized();
    const Arc arc{.centre_wp_mm = {coordinate(random), coordinate(random), coordinate(random)},
                  .normal_wp = normal,
                  .sweep_rad = angle(random)};
    const Vec3 arm = normal.unitOrthogonal() * (1.0 + std::abs(coordinate(random)));
    const Vec3 end = Eigen::AngleAxisd{arc.sweep_rad, normal} * arm;
    const Segment move{arc.centre_wp_mm + arm, Vec3::UnitZ(), arc.centre_wp_mm + end + normal,
                       Vec3::UnitZ(), &arc};
    const double fraction = share(random);

    ASSERT_NEAR(move.nearest_fraction(move.tip_mm(fraction), fraction), fraction, 1e-11);
  }
}

}  // namespace
}  // namespace pentapost::path
