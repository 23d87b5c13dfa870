#include "pentapost/jobs/setup_steps.hpp"

#include "pentapost/path/turn.hpp"

#include <gtest/gtest.h>

#include <string>

namespace pentapost {
namespace {

bool says(const std::string& step, const std::string& what) {
  return step.find(what) != std::string::npos;
}

std::vector<std::string> steps_of(double theta_x_deg, double theta_z_deg) {
  return jobs::setup_steps({.theta_x_deg = theta_x_deg, .theta_z_deg = theta_z_deg});
}

/// The paper's theta_x of -10 deg is +10 deg right-handed about +X: what points to +Y goes up.
TEST(SetupSteps, TiltTheSideTowardsYUpForANegativeThetaX) {
  const Vec3 side = path::setup_turn(-10.0 * rad_per_deg, 0.0) * Vec3::UnitY();
  ASSERT_GT(side.z(), 0.17);
  const std::string step = steps_of(-10.0, 0.0).at(1);
  EXPECT_TRUE(says(step, "+10 deg, right-handed about +X")) << step;
  EXPECT_TRUE(says(step, "+Y rises")) << step;
}

TEST(SetupSteps, TiltTheSideTowardsYDownForAPositiveThetaX) {
  const Vec3 side = path::setup_turn(25.5 * rad_per_deg, 0.0) * Vec3::UnitY();
  ASSERT_LT(side.z(), -0.4);
  const std::string step = steps_of(25.5, 0.0).at(1);
  EXPECT_TRUE(says(step, "-25.5 deg, right-handed about +X")) << step;
  EXPECT_TRUE(says(step, "+Y sinks")) << step;
}

/// Counterclockwise seen from above: +X goes towards +Y.
TEST(SetupSteps, TurnCounterclockwiseForANegativeThetaZ) {
  const Vec3 side = path::setup_turn(0.0, -30.0 * rad_per_deg) * Vec3::UnitX();
  ASSERT_GT(side.y(), 0.49);
  const std::string step = steps_of(0.0, -30.0).at(0);
  EXPECT_TRUE(says(step, "by 30 deg about the Z axis")) << step;
  EXPECT_TRUE(says(step, "counterclockwise seen from above")) << step;
}

TEST(SetupSteps, TurnClockwiseForAPositiveThetaZ) {
  const Vec3 side = path::setup_turn(0.0, 30.0 * rad_per_deg) * Vec3::UnitX();
  ASSERT_LT(side.y(), -0.49);
  const std::string step = steps_of(0.0, 30.0).at(0);
  EXPECT_TRUE(says(step, ", clockwise seen from above")) << step;
  EXPECT_TRUE(says(step, "-30 deg, right-handed about +Z")) << step;
}

/// The part is turned first, then tilted about an axis of the machine.
TEST(SetupSteps, ComeInTheOrderOfTheTurns) {
  const Vec3 x = path::setup_turn(-20.0 * rad_per_deg, -90.0 * rad_per_deg) * Vec3::UnitX();
  EXPECT_NEAR((x - Vec3{0.0, 0.93969262078591, 0.34202014332567}).norm(), 0.0, 1e-12);
  const auto steps = steps_of(-20.0, -90.0);
  EXPECT_TRUE(says(steps.at(0), "Turn the part")) << steps.at(0);
  EXPECT_TRUE(says(steps.at(1), "Then tilt it")) << steps.at(1);
}

TEST(SetupSteps, SayWhereNothingIsToBeTurned) {
  const auto steps = steps_of(0.0, 0.0);
  EXPECT_TRUE(says(steps.at(0), "don't turn")) << steps.at(0);
  EXPECT_TRUE(says(steps.at(1), "Don't tilt")) << steps.at(1);
}

TEST(SetupSteps, GiveTheDatum) {
  const auto steps = jobs::setup_steps({.origin_mm = Vec3{12.5, -3.0, 100.0}});
  EXPECT_TRUE(says(steps.at(2), "X 12.5, Y -3, Z 100 mm")) << steps.at(2);
  EXPECT_TRUE(says(steps_of(5.0, 5.0).at(2), "Measure the CL origin")) << steps_of(5.0, 5.0).at(2);
}

}  // namespace
}  // namespace pentapost
