#include "lib/kinematics/hard_chains.hpp"
#include "pentapost/kinematics/forward.hpp"
#include "pentapost/kinematics/inverse.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace pentapost::kinematics {
namespace {

constexpr double axis_tolerance = 1e-13;

/// Distances from a pole or a boundary at which digits get lost if they can.
const std::vector<double> tiny_angles_rad{0.0,   1e-16, -1e-16, 1e-15, 1e-12, -1e-12, 1e-9,
                                          -1e-9, 1e-8,  1e-6,   -1e-6, 1e-4,  -1e-4};

/// Largest distance between the axes of all branches, by forward(), and `axis`.
double worst_axis_error(const Model& model, const RotarySolutions& found, const Vec3& axis) {
  double worst = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(found.count); ++i) {
    const auto& branch = found.branch[i];
    const double error = (forward_axis(model, branch.first_rad, branch.second_rad) - axis).norm();
    worst = std::isfinite(error) ? std::max(worst, error) : INFINITY;
  }
  return worst;
}

class InverseRotaryOn : public ::testing::TestWithParam<sample::NamedChain> {
 protected:
  Model model{GetParam().chain};
  std::mt19937_64 random{42};
  std::uniform_real_distribution<double> turn_rad{-pi, pi};
};

TEST_P(InverseRotaryOn, FindsEveryAxisThatTheJointsGive) {
  for (int i = 0; i < 20'000; ++i) {
    const Vec3 axis = forward_axis(model, turn_rad(random), turn_rad(random)).normalized();

    const auto found = inverse_rotary(model, axis);

    ASSERT_EQ(found.count, model.rotary_count == 2 ? 2 : 1) << i;
    ASSERT_LT(worst_axis_error(model, found, axis), axis_tolerance) << i;
  }
}

TEST_P(InverseRotaryOn, IsRightOrSaysNoOnTheWholeSphere) {
  for (int i = 0; i < 20'000; ++i) {
    const Vec3 axis = sample::random_axis(random);

    const auto found = inverse_rotary(model, axis);

    ASSERT_EQ(found.count == 0, found.beyond_rad > 1e-14) << i;
    ASSERT_LT(worst_axis_error(model, found, axis), axis_tolerance) << i;
  }
}

TEST_P(InverseRotaryOn, GivesFirstJointWithinOneTurn) {
  for (int i = 0; i < 20'000; ++i) {
    for (const auto& branch : inverse_rotary(model, sample::random_axis(random)).branch)
      ASSERT_LE(std::abs(branch.first_rad), pi);
  }
}

INSTANTIATE_TEST_SUITE_P(, InverseRotaryOn, ::testing::ValuesIn(sample::all_chains()),
                         sample::name_of_chain);

class FiveAxisInverseOn : public InverseRotaryOn {};

TEST_P(FiveAxisInverseOn, KeepsItsDigitsNextToPolesAndBoundaries) {
  for (const double end_rad : {0.0, pi}) {
    for (const double off_rad : tiny_angles_rad) {
      SCOPED_TRACE(off_rad);
      for (int i = 0; i < 100; ++i) {
        const double second_rad = model.beta_zero_rad + end_rad + off_rad;
        const Vec3 axis = forward_axis(model, turn_rad(random), second_rad).normalized();

        const auto found = inverse_rotary(model, axis);

        ASSERT_EQ(found.count, 2);
        ASSERT_LT(worst_axis_error(model, found, axis), axis_tolerance);
      }
    }
  }
}

// At gamma = |lambda - mu| and lambda + mu itself, on either side of the boundary.
TEST_P(FiveAxisInverseOn, IsRightOrSaysNoAcrossTheBoundaries) {
  const Vec3 a_drawn = model.a_flipped ? Vec3{-model.a} : model.a;
  for (const double gamma_rad :
       {std::abs(model.lambda_rad - model.mu_rad), model.lambda_rad + model.mu_rad}) {
    for (const double off_rad : tiny_angles_rad) {
      SCOPED_TRACE(off_rad);
      for (int i = 0; i < 100; ++i) {
        const Vec3 axis = sample::random_axis_at(random, a_drawn, gamma_rad + off_rad);

        const auto found = inverse_rotary(model, axis);

        ASSERT_EQ(found.count == 0, found.beyond_rad > 1e-14);
        ASSERT_LT(worst_axis_error(model, found, axis), axis_tolerance);
      }
    }
  }
}

// Stronger than a round trip of the axis: branch[0] is the +opening side, branch[1] the other, so
// each follows a path without a jump.
TEST_P(FiveAxisInverseOn, GivesEachSideItsOwnBranch) {
  std::uniform_real_distribution<double> opening_rad{0.05, pi - 0.05};
  for (int i = 0; i < 5'000; ++i) {
    const double first_rad = turn_rad(random), opening = opening_rad(random);
    for (const double side : {+1.0, -1.0}) {
      const double second_rad = model.beta_zero_rad + side * opening;
      // What rounding of the axis does to the joints grows as the triangle shrinks.
      const double tolerance_rad =
          4e-15 / (std::sin(model.lambda_rad) * std::sin(model.mu_rad) * std::sin(opening));

      const auto found = inverse_rotary(model, forward_axis(model, first_rad, second_rad));

      const auto& branch = found.branch[side > 0.0 ? 0 : 1];
      ASSERT_NEAR(branch.second_rad, second_rad, tolerance_rad) << i;
      ASSERT_NEAR(wrapped_rad(branch.first_rad - first_rad), 0.0, tolerance_rad) << i;
      ASSERT_NEAR(found.opening_rad, opening, tolerance_rad) << i;
    }
  }
}

// lib/README.md section 3: |[a, o, b']| = sin lambda sin mu |sin B|.
TEST_P(FiveAxisInverseOn, OpeningObeysTheDeterminantIdentity) {
  const double sines = std::sin(model.lambda_rad) * std::sin(model.mu_rad);
  for (int i = 0; i < 2'000; ++i) {
    const double first_rad = turn_rad(random), second_rad = turn_rad(random);
    const Vec3 b_turned = Eigen::AngleAxisd{first_rad, model.a} * model.b;
    const Vec3 axis =
        Eigen::AngleAxisd{first_rad, model.a} * (Eigen::AngleAxisd{second_rad, model.b} * model.t);

    const auto found = inverse_rotary(model, axis.normalized());

    const double triple = std::abs(model.a.dot(axis.cross(b_turned)));
    ASSERT_NEAR(sines * std::sin(second_rad - model.beta_zero_rad),
                std::copysign(triple, std::sin(second_rad - model.beta_zero_rad)), 2e-15);
    // The opening itself is not well known from the axis next to the ends: squares are.
    ASSERT_NEAR(std::pow(sines * std::sin(found.opening_rad), 2), triple * triple, 1e-14);
  }
}

TEST_P(FiveAxisInverseOn, GivesGammaAsTheAngleToTheFirstAxis) {
  const Vec3 a_drawn = model.a_flipped ? Vec3{-model.a} : model.a;
  for (int i = 0; i < 1'000; ++i) {
    const double gamma_rad = std::abs(turn_rad(random));

    const auto found = inverse_rotary(model, sample::random_axis_at(random, a_drawn, gamma_rad));

    ASSERT_NEAR(found.gamma_rad, gamma_rad, 1e-15);
    ASSERT_NEAR(found.beyond_rad,
                std::max(std::abs(model.lambda_rad - model.mu_rad) - gamma_rad,
                         gamma_rad - model.lambda_rad - model.mu_rad),
                2e-15);
  }
}

INSTANTIATE_TEST_SUITE_P(, FiveAxisInverseOn, ::testing::ValuesIn(sample::five_axis_chains()),
                         sample::name_of_chain);

// acos() would lose half its digits here: a tilt of 1e-9 rad would come back as 0 or as 1.5e-8.
TEST(InverseRotary, KeepsATinyTiltNextToThePole) {
  const Model model{sample::trunnion_ac()};
  for (const double tilt_rad : {1e-12, 1e-9, 1e-6}) {
    SCOPED_TRACE(tilt_rad);
    const auto found = inverse_rotary(model, {0.0, std::sin(tilt_rad), std::cos(tilt_rad)});

    ASSERT_EQ(found.count, 2);
    EXPECT_NEAR(found.branch[0].second_rad, tilt_rad, 1e-15);
    EXPECT_NEAR(found.branch[0].first_rad, 0.0, 1e-15);
    EXPECT_NEAR(found.branch[1].second_rad, -tilt_rad, 1e-15);
    EXPECT_FALSE(found.first_is_free);
  }
}

// The same on a machine of oblique axes, where no coordinate is exactly zero. On the 45 deg table a
// tilt of gamma needs B = gamma / sin 45 deg.
TEST(InverseRotary, KeepsATinyTiltNextToThePoleOfAnObliqueMachine) {
  const Model model{sample::head_of(pi / 4, pi / 4)};
  std::mt19937_64 random{42};
  for (const double tilt_rad : {1e-9, 1e-6}) {
    SCOPED_TRACE(tilt_rad);
    const auto found = inverse_rotary(model, sample::random_axis_at(random, model.a, tilt_rad));

    EXPECT_NEAR(found.opening_rad, tilt_rad * std::sqrt(2.0), 2e-15 + tilt_rad * tilt_rad);
  }
}

}  // namespace
}  // namespace pentapost::kinematics
