#include "pentapost/core/units.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

using namespace pentapost;

namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

}  // namespace

TEST(Angle, ConvertsDegrees) {
  EXPECT_DOUBLE_EQ(Angle::degrees(180.0).rad(), 3.14159265358979323846);
  EXPECT_DOUBLE_EQ(Angle::radians(0.5).deg(), 28.64788975654116);
  EXPECT_EQ((-Angle::radians(0.5)).rad(), -0.5);
  EXPECT_LT(Angle::degrees(-110.0), Angle::degrees(110.0));
}

TEST(Range, IncludesItsEnds) {
  constexpr Range<double> range{-110.0, 110.0};

  EXPECT_TRUE(range.contains(-110.0));
  EXPECT_TRUE(range.contains(110.0));
  EXPECT_FALSE(range.contains(110.0000001));
  EXPECT_FALSE(range.contains(std::numeric_limits<double>::quiet_NaN()));
}

TEST(UnitVector, HasLengthOne) {
  std::mt19937_64 random{42};
  std::normal_distribution<double> component;
  for (int i = 0; i < 10'000; ++i) {
    const Vec3 direction{component(random), component(random), component(random)};
    ASSERT_NEAR(UnitVector::normalised(direction).vec().norm(), 1.0, 4e-16);
  }
}

TEST(UnitVector, KeepsAUnitVectorAsItIs) {
  EXPECT_EQ(UnitVector::normalised(Vec3::UnitZ()).vec(), Vec3::UnitZ());
  EXPECT_EQ((-UnitVector::normalised(Vec3::UnitX())).vec(), -Vec3::UnitX());
}

TEST(UnitVector, NormalisesTheLargestAndSmallestNumbers) {
  const double third = 0.57735026918962576;
  for (const double size : {largest, 1e200, 1e-200, smallest}) {
    SCOPED_TRACE(size);
    const Vec3 unit = UnitVector::normalised({size, -size, size}).vec();
    EXPECT_NEAR(unit.x(), third, 1e-15);
    EXPECT_NEAR(unit.y(), -third, 1e-15);
    EXPECT_NEAR(unit.z(), third, 1e-15);
  }
}

TEST(UnitVector, RefusesWhatHasNoDirection) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();

  EXPECT_THROW(UnitVector::normalised(Vec3::Zero()), std::logic_error);
  EXPECT_THROW(UnitVector::normalised({nan, 0.0, 1.0}), std::logic_error);
  EXPECT_THROW(UnitVector::normalised({1.0, nan, nan}), std::logic_error);
  EXPECT_THROW(UnitVector::normalised({infinity, 0.0, 1.0}), std::logic_error);
}

// acos would give 0 for all of these.
TEST(AngleBetween, KeepsItsDigitsNextToNought) {
  for (const double angle_rad : {1e-15, 1e-12, 1e-9, 1e-6}) {
    SCOPED_TRACE(angle_rad);
    const Vec3 turned{std::sin(angle_rad), 0.0, std::cos(angle_rad)};
    EXPECT_NEAR(angle_between_rad(Vec3::UnitZ(), turned), angle_rad, 1e-15 * angle_rad);
  }
}

TEST(AngleBetween, KeepsItsDigitsNextToAHalfTurn) {
  for (const double short_of_pi_rad : {1e-9, 1e-6}) {
    SCOPED_TRACE(short_of_pi_rad);
    const Vec3 turned{std::sin(short_of_pi_rad), 0.0, -std::cos(short_of_pi_rad)};
    EXPECT_NEAR(pi - angle_between_rad(Vec3::UnitZ(), turned), short_of_pi_rad, 1e-15);
  }
}

TEST(AngleBetween, KnowsTheExactCases) {
  EXPECT_EQ(angle_between_rad(Vec3::UnitX(), Vec3::UnitX()), 0.0);
  EXPECT_EQ(angle_between_rad(Vec3::UnitX(), -Vec3::UnitX()), pi);
  EXPECT_EQ(angle_between_rad(Vec3::UnitX(), Vec3::UnitY()), pi / 2.0);
  EXPECT_DOUBLE_EQ(angle_between_rad({5.0, 0.0, 0.0}, {0.1, 0.1, 0.0}), pi / 4.0);
}

TEST(Wrapped, TakesWholeTurnsAway) {
  EXPECT_EQ(wrapped_rad(0.0), 0.0);
  EXPECT_EQ(wrapped_rad(1.0), 1.0);
  EXPECT_NEAR(wrapped_rad(1.0 + 2.0 * pi), 1.0, 1e-15);
  EXPECT_NEAR(wrapped_rad(4.0), 4.0 - 6.283185307179586, 1e-15);
  EXPECT_NEAR(wrapped_rad(-4.0), 6.283185307179586 - 4.0, 1e-15);
}

TEST(Wrapped, StaysWithinAHalfTurn) {
  EXPECT_EQ(std::abs(wrapped_rad(pi)), pi);
  EXPECT_EQ(std::abs(wrapped_rad(-pi)), pi);
  std::mt19937_64 random{42};
  std::uniform_real_distribution<double> angle{-1e6, 1e6};
  for (int i = 0; i < 10'000; ++i) ASSERT_LE(std::abs(wrapped_rad(angle(random))), pi);
}
