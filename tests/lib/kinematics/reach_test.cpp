#include "lib/kinematics/hard_chains.hpp"
#include "pentapost/kinematics/forward.hpp"
#include "pentapost/kinematics/inverse.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

/// Which tool axes a machine reaches, in how many ways (lib/README.md section 2).
namespace pentapost::kinematics {
namespace {

TEST(Reach, HasNoSolutionOutOfReach) {
  const Model model{sample::nutating_table()};

  const auto found = inverse_rotary(model, {0, 0, -1});

  EXPECT_EQ(found.count, 0);
  EXPECT_NEAR(found.beyond_rad, pi / 2, 1e-15);
}

TEST(Reach, HasTwoSolutionsInsideTheReach) {
  const Model model{sample::nutating_table()};

  const auto found = inverse_rotary(model, Vec3{0.3, 0.4, 0.8}.normalized());

  EXPECT_EQ(found.count, 2);
  EXPECT_LT(found.beyond_rad, 0.0);
  EXPECT_FALSE(found.first_is_free);
  EXPECT_GT(found.branch[0].second_rad, found.branch[1].second_rad);
}

TEST(Reach, HasInfinitelyManySolutionsAtThePole) {
  const Model model{sample::nutating_table()};

  const auto found = inverse_rotary(model, {0, 0, 1});

  EXPECT_TRUE(found.first_is_free);
  EXPECT_EQ(found.branch[0].first_rad, 0.0);
  for (const double first_rad : {-3.0, -1.0, 0.5, 2.0}) {
    const Vec3 axis = forward_axis(model, first_rad, found.branch[0].second_rad);
    EXPECT_LT((axis - Vec3::UnitZ()).norm(), 1e-15);
  }
}

// Table 1 of Cripps et al. 2017: k = -1 needs A = 180 deg and leaves C free.
TEST(Reach, HasTheOppositePoleWhereTheSidesMakeAHalfTurn) {
  const auto found = inverse_rotary(Model{sample::trunnion_ac()}, {0, 0, -1});

  EXPECT_TRUE(found.first_is_free);
  EXPECT_NEAR(found.branch[0].second_rad, pi, 1e-15);
  EXPECT_NEAR(found.branch[1].second_rad, -pi, 1e-15);
}

// lambda = 60 deg, mu = 120 deg: o = -a is the pole, and o = a is out of reach by 60 deg.
TEST(Reach, HasThePoleBehindWhereTheSidesMakeAHalfTurnObliquely) {
  const Model model{sample::head_of(pi / 3, 2 * pi / 3)};

  EXPECT_TRUE(inverse_rotary(model, -model.a).first_is_free);
  EXPECT_EQ(inverse_rotary(model, model.a).count, 0);
  EXPECT_NEAR(inverse_rotary(model, model.a).beyond_rad, pi / 3, 1e-14);
}

// lib/README.md section 4: straight through the pole the first joint turns by -(a . b) / 2 per unit
// of the second one, and the branch changes.
TEST(Reach, RunsThroughThePoleWithTheSlopeOfTheObliqueAxes) {
  for (const auto& chain :
       {sample::nutating_table(), sample::nutating_head(), sample::trunnion_ac(),
        sample::head_of(1.2, 1.2), sample::head_of(1.2, pi - 1.2)}) {
    const Model model{chain};
    const Vec3 pole = model.a_flipped ? Vec3{-model.a} : model.a;
    const Vec3 aside = pole.cross(Vec3{0.3, 0.5, -0.1}).normalized();
    const double step_rad = 1e-4;

    const auto before =
        inverse_rotary(model, std::cos(step_rad) * pole - std::sin(step_rad) * aside).branch[1];
    const auto after =
        inverse_rotary(model, std::cos(step_rad) * pole + std::sin(step_rad) * aside).branch[0];

    const double first_turn_rad = wrapped_rad(after.first_rad - before.first_rad);
    const double second_turn_rad = after.second_rad - before.second_rad;
    EXPECT_NEAR(first_turn_rad / second_turn_rad, -model.a.dot(model.b) / 2.0, 1e-6);
  }
}

// 45 deg nutating table: every horizontal tool axis has one solution only, B = 180 deg.
TEST(Reach, MergesItsSolutionsOnTheReachBoundary) {
  const Model model{sample::nutating_table()};
  for (const double around_rad : {0.0, 1.0, 3.0, -2.0}) {
    const auto found = inverse_rotary(model, {std::cos(around_rad), std::sin(around_rad), 0.0});

    ASSERT_EQ(found.count, 2);
    // A boundary that is met to 1e-16 is known to its square root.
    EXPECT_NEAR(found.opening_rad, pi, 5e-8);
    EXPECT_NEAR(wrapped_rad(found.branch[0].first_rad - found.branch[1].first_rad), 0.0, 1e-7);
  }
}

// lambda = 30 deg, mu = 70 deg reaches from 40 to 100 deg off the first axis.
TEST(Reach, ReachesARingWhereTheSidesDiffer) {
  const Model model{sample::head_of(30 * rad_per_deg, 70 * rad_per_deg)};
  const Vec3 a_drawn = model.a_flipped ? Vec3{-model.a} : model.a;
  std::mt19937_64 random{42};
  const auto count_at = [&](double gamma_deg) {
    return inverse_rotary(model, sample::random_axis_at(random, a_drawn, gamma_deg * rad_per_deg))
        .count;
  };

  EXPECT_EQ(count_at(39.99), 0);
  EXPECT_EQ(count_at(40.01), 2);
  EXPECT_EQ(count_at(99.99), 2);
  EXPECT_EQ(count_at(100.01), 0);
}

TEST(Reach, TakesAnAxisWithinTheSlackAsOnTheBoundary) {
  const Model model{sample::head_of(45 * rad_per_deg + 2e-5, 45 * rad_per_deg)};
  ASSERT_FALSE(model.a_flipped);

  const auto strict = inverse_rotary(model, model.a);
  const auto lenient = inverse_rotary(model, model.a, 3e-5);

  EXPECT_EQ(strict.count, 0);
  EXPECT_NEAR(strict.beyond_rad, 2e-5, 1e-15);
  ASSERT_EQ(lenient.count, 2);
  EXPECT_EQ(lenient.opening_rad, 0.0);
  EXPECT_TRUE(lenient.first_is_free);
  for (const auto& branch : lenient.branch) {
    const Vec3 reached = forward_axis(model, branch.first_rad, branch.second_rad);
    EXPECT_LT((reached - model.a).norm(), 2e-5 + 1e-14);
  }
}

TEST(Reach, TurnsTheFirstJointTowardsAnAxisWithinTheSlack) {
  const Model model{sample::nutating_table()};
  const double below_rad = 1e-4;  // of the horizon, which is the boundary
  const Vec3 axis{std::cos(below_rad) * 0.6, std::cos(below_rad) * 0.8, -std::sin(below_rad)};

  const auto found = inverse_rotary(model, axis, 1.5e-4);

  ASSERT_EQ(found.count, 2);
  EXPECT_EQ(found.opening_rad, pi);
  for (const auto& branch : found.branch) {
    const Vec3 reached = forward_axis(model, branch.first_rad, branch.second_rad);
    EXPECT_LT((reached - Vec3{0.6, 0.8, 0.0}).norm(), 1e-15);
  }
}

TEST(Reach, ForgivesNoMoreThanTheSlack) {
  const Model model{sample::nutating_table()};
  const Vec3 axis{std::cos(1e-4), 0.0, -std::sin(1e-4)};

  EXPECT_EQ(inverse_rotary(model, axis, 0.9e-4).count, 0);
}

// The table turns by ISO 841, so its tool turns right-handed about +x, to -y.
TEST(Reach, TurnsTheOneRotaryJointOfAFourAxisMachine) {
  const Model model{sample::four_axis_a()};
  const double a_rad = 25 * rad_per_deg;

  const auto found = inverse_rotary(model, {0, -std::sin(a_rad), std::cos(a_rad)});

  ASSERT_EQ(found.count, 1);
  EXPECT_NEAR(found.branch[0].first_rad, a_rad, 1e-15);
  EXPECT_EQ(found.branch[0].second_rad, 0.0);
}

TEST(Reach, HoldsAFourAxisMachineToItsCone) {
  const Model model{sample::four_axis_a()};
  const Vec3 leaning{std::sin(0.001), 0.0, std::cos(0.001)};

  EXPECT_EQ(inverse_rotary(model, leaning).count, 0);
  EXPECT_NEAR(inverse_rotary(model, leaning).beyond_rad, 0.001, 1e-15);
  EXPECT_EQ(inverse_rotary(model, leaning, 0.0011).count, 1);
}

TEST(Reach, LeavesARotaryJointAlongTheToolFree) {
  const Model model{sample::chain_of({sample::rotary("C", -Vec3::UnitZ())},
                                     {sample::x(), sample::y(), sample::z()})};

  const auto upright = inverse_rotary(model, {0, 0, 1});

  EXPECT_EQ(upright.count, 1);
  EXPECT_TRUE(upright.first_is_free);
  EXPECT_EQ(inverse_rotary(model, {0, 0, -1}).count, 0);
}

TEST(Reach, ReachesOneAxisWithoutRotaryJoints) {
  const Model model{sample::three_axis()};
  const Vec3 leaning{std::sin(0.001), 0.0, std::cos(0.001)};

  EXPECT_EQ(inverse_rotary(model, {0, 0, 1}).count, 1);
  EXPECT_EQ(inverse_rotary(model, leaning).count, 0);
  EXPECT_EQ(inverse_rotary(model, leaning, 0.0011).count, 1);
}

TEST(Reach, HasNoSolutionForWhatIsNoAxis) {
  const Model model{sample::trunnion_ac()};

  EXPECT_EQ(inverse_rotary(model, {NAN, 0, 1}).count, 0);
  EXPECT_EQ(inverse_rotary(model, {INFINITY, 0, 1}).count, 0);
}

}  // namespace
}  // namespace pentapost::kinematics
