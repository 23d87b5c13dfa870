#include "pentapost/kinematics/singularity.hpp"

#include "lib/kinematics/hard_chains.hpp"
#include "pentapost/kinematics/forward.hpp"

#include <gtest/gtest.h>

#include <random>

namespace pentapost::kinematics {
namespace {

void expect_pole(const Singularity& found, const Vec3& direction) {
  EXPECT_EQ(found.kind, SingularityKind::pole);
  EXPECT_LT((found.centre - direction).norm(), 1e-15);
  EXPECT_EQ(found.half_angle_rad, 0.0);
}

// Cripps et al. 2017: the tool upright on the table, and (out of its range) upside down.
TEST(Singularities, OfATrunnionAreTheTwoPoles) {
  const auto found = singularities(Model{sample::trunnion_ac()});

  ASSERT_EQ(found.size(), 2u);
  expect_pole(found[0], {0, 0, 1});
  expect_pole(found[1], {0, 0, -1});
}

TEST(Singularities, OfThePocketNcLieAlongY) {
  const auto found = singularities(Model{sample::trunnion_ba()});

  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(std::abs(found[0].centre.y()), 1.0, 1e-15);
  EXPECT_LT((found[0].centre + found[1].centre).norm(), 1e-15);
}

// K = 0 is B = 180 deg: all horizontal tool axes.
TEST(Singularities, OfANutatingTableAreAPoleAndTheHorizon) {
  const auto found = singularities(Model{sample::nutating_table()});

  ASSERT_EQ(found.size(), 2u);
  expect_pole(found[0], {0, 0, 1});
  EXPECT_EQ(found[1].kind, SingularityKind::reach_boundary);
  EXPECT_NEAR(found[1].half_angle_rad, pi / 2, 1e-15);
  EXPECT_EQ(found[1].opening_rad, pi);
}

TEST(Singularities, OfUnequalSidesAreTwoBoundaries) {
  const auto found = singularities(Model{sample::head_of(30 * rad_per_deg, 70 * rad_per_deg)});

  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].kind, SingularityKind::reach_boundary);
  EXPECT_NEAR(found[0].half_angle_rad, 40 * rad_per_deg, 1e-14);
  EXPECT_EQ(found[1].kind, SingularityKind::reach_boundary);
  EXPECT_NEAR(found[1].half_angle_rad, 100 * rad_per_deg, 1e-14);
}

TEST(Singularities, OfOneRotaryJointAreNone) {
  EXPECT_TRUE(singularities(Model{sample::four_axis_a()}).empty());
  EXPECT_TRUE(singularities(Model{sample::three_axis()}).empty());
}

class SingularitiesOn : public ::testing::TestWithParam<sample::NamedChain> {};

// The two rotary velocities of the axis become parallel there, by the plain cross product.
TEST_P(SingularitiesOn, AreWhereTheTwoRotaryVelocitiesAreParallel) {
  const Model model{GetParam().chain};
  const auto all = singularities(model);
  std::mt19937_64 random{42};
  std::uniform_real_distribution<double> turn_rad{-pi, pi};
  for (int i = 0; i < 200; ++i) {
    const double first_rad = turn_rad(random);
    for (const auto& singularity : all) {
      const double second_rad = model.beta_zero_rad + singularity.opening_rad;
      const Vec3 b_turned = Eigen::AngleAxisd{first_rad, model.a} * model.b;
      const Vec3 axis = forward_axis(model, first_rad, second_rad);

      ASSERT_LT(distance_rad(singularity, axis), 1e-14);
      ASSERT_LT(model.a.cross(axis).cross(b_turned.cross(axis)).norm(), 1e-15);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, SingularitiesOn, ::testing::ValuesIn(sample::five_axis_chains()),
                         sample::name_of_chain);

TEST(NearestSingularity, IsThePoleOrTheHorizonByAngle) {
  const auto all = singularities(Model{sample::nutating_table()});
  const auto at = [](double tilt_deg) {
    return Vec3{std::sin(tilt_deg * rad_per_deg), 0.0, std::cos(tilt_deg * rad_per_deg)};
  };

  const auto upper = nearest_singularity(all, at(20)), lower = nearest_singularity(all, at(75));

  ASSERT_TRUE(upper && lower);
  EXPECT_EQ(upper->singularity.kind, SingularityKind::pole);
  EXPECT_NEAR(upper->distance_rad, 20 * rad_per_deg, 1e-15);
  EXPECT_EQ(lower->singularity.kind, SingularityKind::reach_boundary);
  EXPECT_NEAR(lower->distance_rad, 15 * rad_per_deg, 1e-15);
}

TEST(NearestSingularity, IsNoneWhereThereAreNone) {
  EXPECT_FALSE(nearest_singularity({}, Vec3::UnitZ()));
}

TEST(LinearVolumeRatio, IsTheCosineOfTheQuillsLean) {
  const Model model{sample::quill_on_head()};

  EXPECT_NEAR(linear_volume_ratio(model, 1.0, pi / 3), 0.5, 1e-15);
  EXPECT_NEAR(linear_volume_ratio(model, 1.0, pi / 2), 0.0, 1e-15);
}

TEST(LinearVolumeRatio, StaysOneWhereTheLinearJointsStandTogether) {
  EXPECT_EQ(linear_volume_ratio(Model{sample::trunnion_ac()}, 1.0, 2.0), 1.0);
}

}  // namespace
}  // namespace pentapost::kinematics
