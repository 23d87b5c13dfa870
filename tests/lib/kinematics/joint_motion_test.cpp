#include "pentapost/kinematics/joint_motion.hpp"

#include "lib/kinematics/hard_chains.hpp"
#include "pentapost/kinematics/forward.hpp"
#include "pentapost/kinematics/inverse.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <vector>

namespace pentapost::kinematics {
namespace {

std::optional<JointRates> joint_rates(const Model& model, const Joints& joints,
                                      double gauge_length_mm, const Vec3& tip_rate_mm,
                                      const Vec3& axis_rate) {
  return JointMotion{model, joints, gauge_length_mm}.rates({tip_rate_mm, axis_rate});
}

using Columns = Eigen::Matrix<double, 5, 1>;
using Rows = Eigen::Matrix<double, 6, 1>;

Columns columns(const Vec3& linear, double first, double second) {
  Columns all;
  all << linear, first, second;
  return all;
}

Rows pose_rows(const Model& model, const Columns& joints, double gauge_length_mm) {
  const Pose pose = forward(model, {joints.head<3>(), joints[3], joints[4]}, gauge_length_mm);
  Rows rows;
  rows << pose.tip_mm, pose.axis;
  return rows;
}

/// Derivative at 0 by central differences, steps from `h` down, each extrapolated to step 0
/// (Richardson); of all that, the value on which neighbours agree best (Ridders' method).
template <class Value>
Value derivative(const std::function<Value(double)>& function, double h) {
  constexpr std::size_t steps = 14;
  constexpr double shrink = 1.6;
  std::array<Value, steps> row, last;
  Value best = Value::Constant(NAN);
  double best_doubt = INFINITY;
  for (std::size_t i = 0; i < steps; ++i, h /= shrink) {
    row[0] = (function(h) - function(-h)) / (2.0 * h);
    double factor = 1.0;
    for (std::size_t k = 1; k <= i; ++k) {
      factor *= shrink * shrink;
      row[k] = (factor * row[k - 1] - last[k - 1]) / (factor - 1.0);
      const double doubt = std::max((row[k] - row[k - 1]).norm(), (row[k] - last[k - 1]).norm());
      if (doubt < best_doubt) {
        best_doubt = doubt;
        best = row[k];
      }
    }
    last = row;
  }
  return best;
}

/// A random posture at a given opening, and a random motion of the tool through it.
struct Motion {
  Joints joints;
  double gauge_length_mm;
  Pose pose;
  Vec3 tip_rate_mm, axis_rate;
  Pose at(double time) const {
    const double speed = axis_rate.norm();
    return {pose.tip_mm + time * tip_rate_mm,
            std::cos(speed * time) * pose.axis + std::sin(speed * time) * axis_rate / speed};
  }
};

/// Volume of the linear directions; small next to where they lie in a plane.
double linear_volume(const Model& model, const Joints& joints) {
  return std::abs(linear_map(model, joints.first_rad, joints.second_rad, 0.0).matrix.determinant());
}

Motion random_motion(const Model& model, std::mt19937_64& random, double opening_rad) {
  std::uniform_real_distribution<double> turn_rad{-pi, pi}, gauge_mm{0.0, 200.0};
  Motion motion;
  motion.gauge_length_mm = gauge_mm(random);
  do {
    motion.joints = {300.0 * sample::random_axis(random), turn_rad(random),
                     model.beta_zero_rad + opening_rad};
  } while (linear_volume(model, motion.joints) < 0.01);
  motion.pose = forward(model, motion.joints, motion.gauge_length_mm);
  motion.tip_rate_mm = 40.0 * sample::random_axis(random);
  motion.axis_rate = sample::random_axis(random).cross(motion.pose.axis);
  return motion;
}

/// The joints by the inverse on the side of `motion`, in a window about its own values.
Columns joints_at(const Model& model, const Motion& motion, double time) {
  const Pose pose = motion.at(time);
  const auto found = inverse_rotary(model, pose.axis);
  if (found.count == 0) return Columns::Constant(NAN);
  const bool plus = wrapped_rad(motion.joints.second_rad - model.beta_zero_rad) > 0.0;
  const auto& branch = found.branch[plus ? 0 : 1];
  const auto near = [](double value_rad, double to_rad) {
    return to_rad + wrapped_rad(value_rad - to_rad);
  };
  const double first_rad = near(branch.first_rad, motion.joints.first_rad);
  const double second_rad = near(branch.second_rad, motion.joints.second_rad);
  const auto linear =
      inverse_linear(model, pose.tip_mm, first_rad, second_rad, motion.gauge_length_mm);
  return columns(linear.value_or(Vec3{NAN, NAN, NAN}), first_rad, second_rad);
}

/// Joint accelerations on the motion against differences of the joint rates along it.
void expect_accelerations_are_differences(const Model& model, const Motion& motion, double step) {
  const auto rates_at = [&](double time) {
    const Columns joints = joints_at(model, motion, time);
    const double speed = motion.axis_rate.norm();
    const Vec3 axis_rate = std::cos(speed * time) * motion.axis_rate -
                           speed * std::sin(speed * time) * motion.pose.axis;
    const auto rates = joint_rates(model, {joints.head<3>(), joints[3], joints[4]},
                                   motion.gauge_length_mm, motion.tip_rate_mm, axis_rate);
    return rates ? columns(rates->linear_mm, rates->first_rad, rates->second_rad)
                 : Columns{Columns::Constant(NAN)};
  };
  const JointMotion at{model, motion.joints, motion.gauge_length_mm};
  const auto rates = at.rates({motion.tip_rate_mm, motion.axis_rate});
  ASSERT_TRUE(rates);
  const Vec3 axis_acceleration = -motion.axis_rate.squaredNorm() * motion.pose.axis;
  const auto found = at.accelerations({Vec3::Zero(), axis_acceleration}, motion.axis_rate, *rates);
  ASSERT_TRUE(found);

  const Columns expected = derivative<Columns>(rates_at, step);
  const Columns all = columns(found->linear_mm, found->first_rad, found->second_rad);
  EXPECT_LT((all - expected).head<3>().norm(), 1e-6 * (1.0 + expected.head<3>().norm()));
  EXPECT_LT((all - expected).tail<2>().norm(), 1e-6 * (1.0 + expected.tail<2>().norm()));
}

void expect_rates_are_differences(const Model& model, const Motion& motion, double step) {
  const auto rates = joint_rates(model, motion.joints, motion.gauge_length_mm, motion.tip_rate_mm,
                                 motion.axis_rate);
  ASSERT_TRUE(rates);

  const Columns found = columns(rates->linear_mm, rates->first_rad, rates->second_rad);
  const Columns expected =
      derivative<Columns>([&](double time) { return joints_at(model, motion, time); }, step);
  EXPECT_LT((found - expected).head<3>().norm(), 1e-6 * (1.0 + expected.head<3>().norm()));
  EXPECT_LT((found - expected).tail<2>().norm(), 1e-6 * (1.0 + expected.tail<2>().norm()));
}

class RatesOn : public ::testing::TestWithParam<sample::NamedChain> {
 protected:
  Model model{GetParam().chain};
  std::mt19937_64 random{42};
};

TEST_P(RatesOn, JacobianIsTheDerivativeOfForward) {
  for (int i = 0; i < 50; ++i) {
    const Motion motion = random_motion(model, random, 1.0);
    const Columns at =
        columns(motion.joints.linear_mm, motion.joints.first_rad, motion.joints.second_rad);

    const Jacobian found = JointMotion{model, motion.joints, motion.gauge_length_mm}.jacobian();

    for (Eigen::Index column = 0; column < 5; ++column) {
      const Rows expected = derivative<Rows>(
          [&](double step) {
            return pose_rows(model, at + step * Columns::Unit(column), motion.gauge_length_mm);
          },
          0.1);
      ASSERT_LT((found.col(column) - expected).norm(), 1e-9) << "column " << column;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, RatesOn, ::testing::ValuesIn(sample::all_chains()),
                         sample::name_of_chain);

class FiveAxisRatesOn : public RatesOn {};

TEST_P(FiveAxisRatesOn, BringBackTheToolsVelocity) {
  for (int i = 0; i < 200; ++i) {
    const Motion motion = random_motion(model, random, 1.2);

    const auto rates = joint_rates(model, motion.joints, motion.gauge_length_mm, motion.tip_rate_mm,
                                   motion.axis_rate);

    ASSERT_TRUE(rates);
    const Columns joint_rates = columns(rates->linear_mm, rates->first_rad, rates->second_rad);
    const Rows tool =
        JointMotion{model, motion.joints, motion.gauge_length_mm}.jacobian() * joint_rates;
    const double scale = 1.0 + joint_rates.norm();
    ASSERT_LT((tool.head<3>() - motion.tip_rate_mm).norm(), 1e-12 * scale);
    ASSERT_LT((tool.tail<3>() - motion.axis_rate).norm(), 1e-14 * scale);
  }
}

TEST_P(FiveAxisRatesOn, HaveNoValueAtTheEndsOfTheTriangle) {
  for (const double opening_rad : {0.0, pi}) {
    const Motion motion = random_motion(model, random, opening_rad);

    EXPECT_FALSE(joint_rates(model, motion.joints, motion.gauge_length_mm, motion.tip_rate_mm,
                             motion.axis_rate));
  }
}

INSTANTIATE_TEST_SUITE_P(, FiveAxisRatesOn, ::testing::ValuesIn(sample::five_axis_chains()),
                         sample::name_of_chain);

/// Sides so short that differences of the inverse have no six digits are left out.
std::vector<sample::NamedChain> chains_fit_for_differences() {
  auto chains = sample::five_axis_chains();
  std::erase_if(chains, [](const sample::NamedChain& each) {
    const Model model{each.chain};
    return std::sin(model.lambda_rad) * std::sin(model.mu_rad) < 0.02;
  });
  return chains;
}

class RatesAsDifferencesOn : public RatesOn {};

TEST_P(RatesAsDifferencesOn, EqualDifferencesOfTheInverse) {
  for (const double opening_rad : {0.3, 1.0, 1.6, 2.5, -0.3, -1.0, -1.6, -2.5}) {
    SCOPED_TRACE(opening_rad);
    for (int i = 0; i < 20 && !HasFailure(); ++i)
      expect_rates_are_differences(model, random_motion(model, random, opening_rad),
                                   0.1 * model.fixed.sin_lambda_sin_mu);
  }
}

// The reach boundary is met with the square of the opening, so the step shrinks likewise.
TEST_P(RatesAsDifferencesOn, EqualDifferencesOfTheInverseNextToSingularities) {
  for (const double opening_rad : {0.01, -0.01, pi - 0.01, 0.01 - pi}) {
    SCOPED_TRACE(opening_rad);
    for (int i = 0; i < 20 && !HasFailure(); ++i)
      expect_rates_are_differences(model, random_motion(model, random, opening_rad),
                                   1e-4 * model.fixed.sin_lambda_sin_mu);
  }
}

TEST_P(RatesAsDifferencesOn, HaveTheAccelerationsAsTheirOwnDifferences) {
  for (const double opening_rad : {0.3, 1.0, 1.6, 2.5, -0.3, -1.0, -1.6, -2.5}) {
    SCOPED_TRACE(opening_rad);
    for (int i = 0; i < 20 && !HasFailure(); ++i)
      expect_accelerations_are_differences(model, random_motion(model, random, opening_rad),
                                           0.1 * model.fixed.sin_lambda_sin_mu);
  }
}

TEST_P(RatesAsDifferencesOn, HaveTheAccelerationsAsTheirOwnDifferencesNextToSingularities) {
  for (const double opening_rad : {0.01, -0.01, pi - 0.01, 0.01 - pi}) {
    SCOPED_TRACE(opening_rad);
    for (int i = 0; i < 20 && !HasFailure(); ++i)
      expect_accelerations_are_differences(model, random_motion(model, random, opening_rad),
                                           1e-4 * model.fixed.sin_lambda_sin_mu);
  }
}

INSTANTIATE_TEST_SUITE_P(, RatesAsDifferencesOn, ::testing::ValuesIn(chains_fit_for_differences()),
                         sample::name_of_chain);

/// Tool axis of Cripps et al. 2017 eq. (2) and its speeds per unit of A and C.
struct CrippsAxis {
  double a, c;
  Vec3 axis() const { return {std::sin(c) * std::sin(a), std::cos(c) * std::sin(a), std::cos(a)}; }
  Vec3 per_a() const {
    return {std::sin(c) * std::cos(a), std::cos(c) * std::cos(a), -std::sin(a)};
  }
  Vec3 across() const { return {std::cos(c), -std::sin(c), 0.0}; }  ///< unit, horizontal
};

// Eq. (5): A follows the vertical part of the axis velocity, C the horizontal one by 1 / sin A.
TEST(JointRates, AreEquationFiveOfCrippsAndOthers) {
  const Model model{sample::trunnion_ac()};
  for (const double a : {1e-9, 1e-6, 1e-3, 0.4, 1.5, -0.4, -1e-6}) {
    SCOPED_TRACE(a);
    const CrippsAxis at{a, 0.8};
    const double vertical = 0.3, horizontal = -0.7;

    const auto rates = joint_rates(model, {.first_rad = at.c, .second_rad = a}, 0.0, Vec3::Zero(),
                                   vertical * at.per_a() + horizontal * at.across());

    ASSERT_TRUE(rates);
    EXPECT_NEAR(rates->second_rad, vertical, 1e-13);
    EXPECT_NEAR(rates->first_rad * std::sin(a), horizontal, 1e-13);
  }
}

// Eq. (6): the linear axes follow A and C round, and the feed turned into the machine's frame.
TEST(JointRates, AreEquationSixOfCrippsAndOthers) {
  const Model model{sample::trunnion_ac()};
  const double a = 0.6, c = -1.1, a_rate = 0.25, c_rate = -1.75;
  const Vec3 tip_mm{12, -34, 56}, tip_rate_mm{7, 8, -9};
  // R_x(-A) and R_z(-C) of the paper are right-handed turns by A and C; Rate is its derivative.
  Mat3 turn_a, turn_c, rate_a, rate_c;
  turn_a << 1, 0, 0, 0, std::cos(a), -std::sin(a), 0, std::sin(a), std::cos(a);
  turn_c << std::cos(c), -std::sin(c), 0, std::sin(c), std::cos(c), 0, 0, 0, 1;
  rate_a << 0, 0, 0, 0, -std::sin(a), -std::cos(a), 0, std::cos(a), -std::sin(a);
  rate_c << -std::sin(c), -std::cos(c), 0, std::cos(c), -std::sin(c), 0, 0, 0, 0;
  const CrippsAxis at{a, c};
  const Joints joints{turn_a * turn_c * tip_mm, c, a};

  const auto rates = joint_rates(model, joints, 0.0, tip_rate_mm,
                                 a_rate * at.per_a() + c_rate * std::sin(a) * at.across());

  const Vec3 expected = a_rate * rate_a * turn_c * tip_mm + c_rate * turn_a * rate_c * tip_mm +
                        turn_a * turn_c * tip_rate_mm;
  ASSERT_TRUE(rates);
  EXPECT_LT((rates->linear_mm - expected).norm(), 1e-12);
}

// A path from the pole along its own meridian leaves C still, however near the pole.
TEST(JointRates, LeaveTheFirstJointStillOnItsMeridian) {
  const Model model{sample::trunnion_ac()};
  const CrippsAxis at{1e-7, 0.0};

  const auto rates =
      joint_rates(model, {.first_rad = at.c, .second_rad = at.a}, 100.0, {1, 0, 0}, at.per_a());

  ASSERT_TRUE(rates);
  EXPECT_EQ(rates->first_rad, 0.0);
}

TEST(JointRates, FollowAConeWithOneRotaryJoint) {
  const Model model{sample::four_axis_a()};
  const double a = 0.4;

  const auto rates = joint_rates(model, {.first_rad = a}, 0.0, {0, 0, 0},
                                 Vec3{0, -std::cos(a), -std::sin(a)} * 2.0);

  ASSERT_TRUE(rates);
  EXPECT_NEAR(rates->first_rad, 2.0, 1e-15);
  EXPECT_EQ(rates->second_rad, 0.0);
}

TEST(JointRates, HaveNoValueWhereOneRotaryJointCannotFollow) {
  const Model model{sample::four_axis_a()};

  EXPECT_FALSE(joint_rates(model, {}, 0.0, {0, 0, 0}, {1, 0, 0}));
}

TEST(JointRates, MoveThreeAxesWithoutTurning) {
  const Model model{sample::three_axis()};

  const auto rates = joint_rates(model, {}, 50.0, {1, -2, 3}, {0, 0, 0});

  ASSERT_TRUE(rates);
  EXPECT_LT((rates->linear_mm - Vec3{1, -2, 3}).norm(), 1e-15);
  EXPECT_FALSE(joint_rates(model, {}, 50.0, {1, -2, 3}, {0.1, 0, 0}));
}

TEST(JointRates, HaveNoValueWhereTheQuillLiesDown) {
  const Model model{sample::quill_on_head()};

  EXPECT_FALSE(joint_rates(model, {.second_rad = pi / 2}, 50.0, {0, 0, 1}, {0, 0, 0}));
}

}  // namespace
}  // namespace pentapost::kinematics
