#include "pentapost/kinematics/forward.hpp"

#include "lib/kinematics/hard_chains.hpp"

#include <gtest/gtest.h>

#include <random>

namespace pentapost::kinematics {
namespace {

void expect_near(const Vec3& found, const Vec3& expected, double tolerance) {
  EXPECT_LT((found - expected).norm(), tolerance)
      << found.transpose() << " instead of " << expected.transpose();
}

TEST(Rotation, IsRightHanded) {
  const Mat3 quarter = rotation(Vec3::UnitZ(), pi / 2);

  expect_near(quarter * Vec3::UnitX(), Vec3::UnitY(), 1e-15);
  expect_near(quarter * Vec3::UnitY(), -Vec3::UnitX(), 1e-15);
  expect_near(quarter * Vec3::UnitZ(), Vec3::UnitZ(), 1e-15);
}

TEST(Rotation, AgreesWithEigen) {
  const Vec3 axis = Vec3{1, -2, 3}.normalized();

  const Mat3 expected = Eigen::AngleAxisd{1.234, axis}.toRotationMatrix();

  EXPECT_LT((rotation(axis, 1.234) - expected).norm(), 1e-15);
}

TEST(Forward, PutsTheTipBelowTheOriginWithAllJointsAtZero) {
  for (const auto& [name, chain] : sample::bundled_chains()) {
    SCOPED_TRACE(name);
    const Pose pose = forward(Model{chain}, Joints{}, 120.0);

    expect_near(pose.tip_mm, {0, 0, -120}, 1e-12);
    expect_near(pose.axis, {0, 0, 1}, 1e-15);
  }
}

// The table goes along -y, so the tool goes along +y as seen from it.
TEST(Forward, CountsAJointUnderTheTableBackwards) {
  const Model model{sample::nutating_head()};
  ASSERT_EQ(model.linear_names[1], "Y");

  const Pose pose = forward(model, {.linear_mm = {0, 7, 0}}, 0.0);

  expect_near(pose.tip_mm, {0, 7, 0}, 1e-12);
}

// Cripps et al. 2017 eq. (1) and (2): A = 90 deg, C = 0 puts the tool along +y of the workpiece.
TEST(Forward, TurnsTheTableOfCrippsAndOthers) {
  const Model model{sample::trunnion_ac()};

  const Pose pose = forward(model, {.linear_mm = {1, 2, 3}, .second_rad = pi / 2}, 0.0);

  expect_near(pose.axis, {0, 1, 0}, 1e-15);
  expect_near(pose.tip_mm, {1, 3, -2}, 1e-14);
}

// B of the head 90 deg about +y through (100, 114, 195): the tip, 195 + 80 below the axis and 100
// beside it, comes to the height of the axis plus 100.
TEST(Forward, SwingsTheTipAboutTheAxisOfTheHead) {
  const Model model{sample::swivel_head()};

  const Pose pose = forward(model, {.second_rad = pi / 2}, 80.0);

  expect_near(pose.axis, {1, 0, 0}, 1e-15);
  expect_near(pose.tip_mm, {100 - 275, 0, 195 + 100}, 1e-12);
}

// A about +x through (0, 20, 10): -90 deg of the table takes the tool to -y of the workpiece.
TEST(Forward, TurnsAboutAxesThatDoNotMeet) {
  const Model model{sample::trunnion_ac_offset()};

  const Pose pose = forward(model, {.second_rad = -pi / 2}, 0.0);

  expect_near(pose.axis, {0, -1, 0}, 1e-15);
  expect_near(pose.tip_mm, {0, 30, -10}, 1e-13);
}

TEST(Forward, IgnoresRotaryValuesOfJointsThatTheChainLacks) {
  const Model model{sample::three_axis()};

  const Pose pose = forward(model, {.first_rad = 1.0, .second_rad = 2.0}, 50.0);

  expect_near(pose.axis, {0, 0, 1}, 1e-15);
  expect_near(pose.tip_mm, {0, 0, -50}, 1e-15);
}

class ForwardOn : public ::testing::TestWithParam<sample::NamedChain> {};

TEST_P(ForwardOn, IsAffineInTheLinearJoints) {
  const Model model{GetParam().chain};
  std::mt19937_64 random{42};
  std::uniform_real_distribution<double> angle_rad{-pi, pi};
  for (int i = 0; i < 100; ++i) {
    const Joints joints{500.0 * sample::random_axis(random), angle_rad(random), angle_rad(random)};

    const LinearMap map = linear_map(model, joints.first_rad, joints.second_rad, 90.0);

    const Vec3 tip_mm = map.matrix * joints.linear_mm + map.offset_mm;
    expect_near(forward(model, joints, 90.0).tip_mm, tip_mm, 1e-11);
  }
}

TEST_P(ForwardOn, GivesTheSameAxisAlone) {
  const Model model{GetParam().chain};
  const Joints joints{{1, 2, 3}, 0.4, -1.3};

  EXPECT_EQ(forward_axis(model, 0.4, -1.3), forward(model, joints, 10.0).axis);
}

INSTANTIATE_TEST_SUITE_P(, ForwardOn, ::testing::ValuesIn(sample::all_chains()),
                         sample::name_of_chain);

}  // namespace
}  // namespace pentapost::kinematics
