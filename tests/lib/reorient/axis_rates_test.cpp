#include "pentapost/reorient/axis_rates.hpp"

#include "lib/reorient/rate_case.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace pentapost {
namespace {

using analysis::PerAxis;
using reorient::AxisRates;
using reorient::Clamping;
using reorient::ToolMotion;

constexpr int random_machines = 40, motions_per_machine = 400;

/// One posture of a machine, as the rates see it and as the kinematics see it.
struct Posture {
  Mat3 to_table;
  Vec3 origin_mm;
  Clamping clamping;
  ToolMotion motion;
  int branch;
  double opening_sine;  ///< 0 where it is out of reach
};

Posture random_posture(sample::RateRandom& random, const kinematics::Model& model) {
  Posture found;
  found.to_table = random.turn();
  found.origin_mm = random.place_mm();
  found.clamping = reorient::clamping_of(model, found.to_table, found.origin_mm);
  found.motion = random.motion(random.direction_at(found.clamping.pole, random.gamma_rad(model)));
  found.branch = random.whole(0, 1);
  const auto solutions = kinematics::inverse_rotary(model, found.to_table * found.motion.axis);
  found.opening_sine = solutions.count < 2 ? 0.0 : std::sin(solutions.opening_rad);
  return found;
}

/// Calls `check(machine, gauge_length_mm, rates, posture)` for postures off the singularities.
template <class Check>
void for_postures(std::uint64_t seed, const Check& check) {
  sample::RateRandom random{seed};
  for (const auto& machine : sample::rate_machines(random_machines)) {
    const double gauge_length_mm = random.real(0.0, 250.0);
    const AxisRates rates{machine.model, gauge_length_mm};
    for (int i = 0; i < motions_per_machine; ++i)
      if (const Posture posture = random_posture(random, machine.model);
          posture.opening_sine > 1e-3)
        check(machine, gauge_length_mm, rates, posture);
  }
}

TEST(AxisRates, OfRotaryAxesAreThoseOfTheJoints) {
  int checked = 0;
  for_postures(
      1, [&](const auto& machine, double gauge_mm, const AxisRates& rates, const Posture& at) {
        const auto expected = sample::rates_by_joints(machine.model, gauge_mm, at.motion,
                                                      at.to_table, at.origin_mm, at.branch);
        if (!expected) return;
        const auto found = rates.at(at.motion, at.clamping, at.branch);
        ASSERT_TRUE(found) << machine.name;
        // Next to a singularity the rounding of the pole and the tool axis counts as much.
        const double product = machine.model.fixed.sin_lambda_sin_mu;
        const double share = 1e-9 + 1e-14 / (product * at.opening_sine * at.opening_sine);
        const double scale = at.motion.turn_rad_s.norm() / (product * at.opening_sine);
        for (const std::size_t i : {analysis::first_axis, analysis::second_axis})
          ASSERT_NEAR((*found)[i], (*expected)[i], share * ((*expected)[i] + 1e-2 * scale))
              << machine.name << " axis " << i << " sin B " << at.opening_sine;
        ++checked;
      });
  EXPECT_GT(checked, 10'000);
}

TEST(AxisRates, OfLinearAxesAreThoseOfTheJoints) {
  int checked = 0;
  for_postures(
      2, [&](const auto& machine, double gauge_mm, const AxisRates& rates, const Posture& at) {
        if (machine.model.fixed.linear_place < 0) return;
        const auto expected = sample::rates_by_joints(machine.model, gauge_mm, at.motion,
                                                      at.to_table, at.origin_mm, at.branch);
        if (!expected) return;
        const auto found = rates.at(at.motion, at.clamping, at.branch);
        ASSERT_TRUE(found) << machine.name;
        const double scale = (*expected)[0] + (*expected)[1] + (*expected)[2];
        for (std::size_t i = 0; i < 3; ++i)
          ASSERT_NEAR((*found)[i], (*expected)[i], 1e-9 * scale)
              << machine.name << " axis " << i << " sin B " << at.opening_sine;
        ++checked;
      });
  EXPECT_GT(checked, 5'000);
}

TEST(AxisRates, LinearValuesAreThoseOfTheJoints) {
  int checked = 0;
  for_postures(3, [&](const auto& machine, double gauge_mm, const AxisRates& rates,
                      const Posture& at) {
    const auto found = rates.linear_mm(at.motion, at.clamping, at.branch);
    if (machine.model.fixed.linear_place < 0) {
      ASSERT_FALSE(found) << machine.name;
      return;
    }
    const auto solutions = kinematics::inverse_rotary(machine.model, at.to_table * at.motion.axis);
    const auto& joints = solutions.branch[static_cast<std::size_t>(at.branch)];
    const auto expected =
        kinematics::inverse_linear(machine.model, at.to_table * at.motion.tip_mm + at.origin_mm,
                                   joints.first_rad, joints.second_rad, gauge_mm);
    ASSERT_TRUE(expected && found) << machine.name;
    // The rounding of the tool axis counts next to a singularity.
    const double near = machine.model.fixed.sin_lambda_sin_mu * at.opening_sine * at.opening_sine;
    ASSERT_LT((*found - *expected).norm(), 1e-8 + 1e-11 / near) << machine.name;
    ++checked;
  });
  EXPECT_GT(checked, 5'000);
}

TEST(AxisRates, OpeningIsThatOfTheJoints) {
  for_postures(4, [&](const auto& machine, double, const AxisRates& rates, const Posture& at) {
    const auto expected = kinematics::inverse_rotary(machine.model, at.to_table * at.motion.axis);
    const auto found = rates.opening_rad(angle_between_rad(at.clamping.pole, at.motion.axis));
    ASSERT_TRUE(found) << machine.name;
    ASSERT_NEAR(*found, expected.opening_rad, 1e-9) << machine.name;
  });
}

TEST(AxisRates, HasNoOpeningOutOfReach) {
  for (const auto& machine : sample::rate_machines(random_machines)) {
    const double least = std::abs(machine.model.lambda_rad - machine.model.mu_rad);
    const double most = machine.model.lambda_rad + machine.model.mu_rad;
    const AxisRates rates{machine.model, 0.0};
    if (least > 1e-3) {
      EXPECT_FALSE(rates.opening_rad(least - 1e-3)) << machine.name;
    }
    if (most < pi - 1e-3) {
      EXPECT_FALSE(rates.opening_rad(most + 1e-3)) << machine.name;
    }
  }
}

TEST(AxisRates, RatioIsTheLargestRateOverItsLimit) {
  sample::RateRandom random{5};
  for (const auto& machine : sample::rate_machines(random_machines)) {
    const AxisRates rates{machine.model, 80.0};
    for (int i = 0; i < 50; ++i) {
      const Posture at = random_posture(random, machine.model);
      reorient::SpeedShares shares;
      for (std::size_t axis = 0; axis < analysis::axis_count; ++axis)
        if (random.chance(0.6)) shares.time_per_way_s[axis] = random.size(1e-3, 10.0);
      for (std::size_t axis = 0; axis < analysis::first_axis; ++axis)
        shares.has_linear = shares.has_linear || shares.time_per_way_s[axis] > 0.0;
      const auto each = rates.at(at.motion, at.clamping, at.branch);
      const auto ratio = rates.ratio(at.motion, at.clamping, at.branch, shares);
      ASSERT_EQ(each.has_value(), ratio.has_value()) << machine.name;
      if (!each) continue;
      double largest = 0.0;
      for (std::size_t axis = 0; axis < analysis::axis_count; ++axis)
        largest = std::max(largest, (*each)[axis] * shares.time_per_way_s[axis]);
      ASSERT_NEAR(*ratio, largest, 1e-10 * largest) << machine.name;
    }
  }
}

/// A/C trunnion of Cripps et al. 2017 eq. (5): C needs the rate across the tilt over sin A.
TEST(AxisRates, AreThoseOfTheClosedFormOfATrunnion) {
  const kinematics::Model model{sample::trunnion_ac()};
  const AxisRates rates{model, 0.0};
  const double tilt_rad = 0.2;
  ToolMotion motion;
  motion.axis = {0.0, std::sin(tilt_rad), std::cos(tilt_rad)};
  motion.turn_rad_s = motion.axis.cross(Vec3{0.3, 0.0, 0.0});
  const Clamping flat = reorient::clamping_of(model, Mat3::Identity(), Vec3::Zero());
  for (const int branch : {0, 1}) {
    const auto found = rates.at(motion, flat, branch);
    ASSERT_TRUE(found);
    EXPECT_NEAR((*found)[analysis::first_axis], 0.3 / std::sin(tilt_rad), 1e-14);
    EXPECT_NEAR((*found)[analysis::second_axis], 0.0, 1e-14);
  }
}

TEST(AxisRates, HaveNoneAtThePoleButForAToolAxisAtRest) {
  const kinematics::Model model{sample::trunnion_ac()};
  const AxisRates rates{model, 0.0};
  const Clamping flat = reorient::clamping_of(model, Mat3::Identity(), Vec3::Zero());
  ToolMotion motion;
  motion.turn_rad_s = {0.1, 0.0, 0.0};
  EXPECT_FALSE(rates.at(motion, flat, 0));
  motion.turn_rad_s = Vec3::Zero();
  motion.tip_mm_s = {3.0, 4.0, 0.0};
  const auto at_rest = rates.at(motion, flat, 0);
  ASSERT_TRUE(at_rest);
  EXPECT_EQ((*at_rest)[analysis::first_axis], 0.0);
  EXPECT_NEAR((*at_rest)[0], 5.0, 1e-12);
}

/// Half a turn about an endless C with the CL origin on its axis changes nothing.
TEST(AxisRates, OfTwinSetupsAreTheSame) {
  sample::RateRandom random{6};
  const kinematics::Model model{sample::trunnion_ac_offset()};
  const AxisRates rates{model, 100.0};
  for (int i = 0; i < 500; ++i) {
    const double x_rad = random.real(-1.0, 1.0), z_rad = random.real(-pi, pi);
    const Vec3 origin_mm{0.0, 0.0, random.real(-200.0, 200.0)};
    const Clamping one = reorient::clamping_of(model, path::setup_turn(x_rad, z_rad), origin_mm);
    const Clamping twin =
        reorient::clamping_of(model, path::setup_turn(-x_rad, z_rad + pi), origin_mm);
    const ToolMotion motion = random.motion(random.direction());
    const auto found = rates.at(motion, one, 0), other = rates.at(motion, twin, 0);
    ASSERT_TRUE(found && other);
    for (std::size_t axis = 0; axis < analysis::axis_count; ++axis)
      ASSERT_NEAR((*found)[axis], (*other)[axis], 1e-9 * (1.0 + (*found)[axis]));
  }
}

}  // namespace
}  // namespace pentapost
