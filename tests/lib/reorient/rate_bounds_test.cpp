#include "lib/reorient/rate_case.hpp"
#include "pentapost/reorient/axis_rates.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace pentapost {
namespace {

using analysis::PerAxis;
using reorient::AxisRates;
using reorient::Clamping;
using reorient::MotionGroup;
using reorient::RateBounds;
using reorient::SpeedShares;
using reorient::Spread;
using reorient::ToolMotion;

constexpr int random_machines = 24, regions_per_machine = 150, samples_per_region = 40;
constexpr double rounding = 1e-9;

/// A spread about a clamping and a motion.
struct Region {
  Mat3 to_table;
  Clamping clamping;
  ToolMotion motion;
  Spread spread;
  int branch;
};

double spread_size(sample::RateRandom& random, double most) {
  return random.chance(0.15) ? 0.0 : random.size(1e-6 * most, most);
}

Region random_region(sample::RateRandom& random, const kinematics::Model& model) {
  constexpr double largest_rad = 30.0 * rad_per_deg;
  Region region;
  region.to_table = random.turn();
  region.clamping = reorient::clamping_of(model, region.to_table, random.place_mm());
  region.motion = random.motion(random.direction_at(region.clamping.pole, random.gamma_rad(model)));
  region.branch = random.whole(0, 1);
  Spread& spread = region.spread;
  spread.pole_rad = spread_size(random, largest_rad);
  spread.turn_rad = spread.pole_rad + spread_size(random, largest_rad);
  spread.origin_mm = spread_size(random, 100.0);
  spread.axis_rad = spread_size(random, largest_rad);
  spread.turn_rad_s = spread_size(random, 2.0);
  spread.tip_mm = spread_size(random, 100.0);
  spread.tip_mm_s = spread_size(random, 100.0);
  // The middle of a group of motions need not turn across its own axis.
  if (random.chance(0.3))
    region.motion.turn_rad_s += random.within(region.spread.turn_rad_s) * region.motion.axis;
  return region;
}

Clamping clamping_within(sample::RateRandom& random, const Region& region) {
  const Clamping& middle = region.clamping;
  const Spread& spread = region.spread;
  const double tilt_rad = random.within(spread.pole_rad);
  const Vec3 about = random.direction_at(middle.pole, 0.5 * pi);
  const double turn_rad =
      (random.chance(0.5) ? 1.0 : -1.0) * random.within(spread.turn_rad - tilt_rad);
  const Mat3 turn = (Eigen::AngleAxisd{tilt_rad, about} * Eigen::AngleAxisd{turn_rad, middle.pole})
                        .toRotationMatrix();
  return {middle.to_table * turn.transpose(), turn * middle.pole,
          middle.origin_from_a_mm + random.vector_within(spread.origin_mm)};
}

/// @return nullopt where the dice gave none.
std::optional<ToolMotion> motion_within(sample::RateRandom& random, const Region& region) {
  const ToolMotion& middle = region.motion;
  const Spread& spread = region.spread;
  ToolMotion motion;
  // Along the turn, as in a piece of a path, or any way.
  const bool along = random.chance(0.5) && middle.turn_rad_s.norm() > 0.0;
  const Vec3 about =
      along ? Vec3{middle.turn_rad_s.normalized()} : random.direction_at(middle.axis, 0.5 * pi);
  motion.axis =
      Eigen::AngleAxisd{random.within(spread.axis_rad) * (random.chance(0.5) ? 1 : -1), about} *
      middle.axis;
  const auto across = [&](const Vec3& vector) {
    return Vec3{vector - vector.dot(motion.axis) * motion.axis};
  };
  motion.turn_rad_s = across(middle.turn_rad_s);
  const double left = spread.turn_rad_s - (motion.turn_rad_s - middle.turn_rad_s).norm();
  if (left > 0.0) motion.turn_rad_s += across(random.vector_within(left));
  if ((motion.turn_rad_s - middle.turn_rad_s).norm() > spread.turn_rad_s + 1e-14)
    return std::nullopt;
  motion.tip_mm = middle.tip_mm + random.vector_within(spread.tip_mm);
  motion.tip_mm_s = middle.tip_mm_s + random.vector_within(spread.tip_mm_s);
  return motion;
}

/// Calls `check(machine, rates, region, clamping, motion)` for samples of random regions.
template <class Begin, class Check>
void for_samples(std::uint64_t seed, const Begin& begin, const Check& check) {
  sample::RateRandom random{seed};
  for (const auto& machine : sample::rate_machines(random_machines)) {
    const AxisRates rates{machine.model, random.real(0.0, 250.0)};
    for (int i = 0; i < regions_per_machine; ++i) {
      const Region region = random_region(random, machine.model);
      const auto state = begin(rates, region);
      for (int k = 0; k < samples_per_region; ++k) {
        const Clamping clamping = clamping_within(random, region);
        if (const auto motion = motion_within(random, region))
          check(machine, rates, region, state, clamping, *motion);
        if (testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

/// Next to a singularity the rounding of the pole and the tool axis counts.
double rounding_share(const kinematics::Model& model, const ToolMotion& motion,
                      const Clamping& clamping) {
  const auto at = kinematics::inverse_rotary(model, clamping.to_table * motion.axis);
  const double sine = std::sin(at.opening_rad);
  return 1e-9 + 1e-14 / std::max(1e-20, model.fixed.sin_lambda_sin_mu * sine * sine);
}

/// A tool axis at rest has rates where the machine cannot hold it, too.
bool is_within_reach(const kinematics::Model& model, const ToolMotion& motion,
                     const Clamping& clamping) {
  return kinematics::inverse_rotary(model, clamping.to_table * motion.axis).count > 0;
}

std::string text_of(const Region& region) {
  const Spread& spread = region.spread;
  std::ostringstream text;
  text << "gamma " << angle_between_rad(region.clamping.pole, region.motion.axis) << " pole "
       << spread.pole_rad << " turn " << spread.turn_rad << " origin " << spread.origin_mm
       << " axis " << spread.axis_rad << " turn_rad_s " << spread.turn_rad_s << " tip "
       << spread.tip_mm << " tip_mm_s " << spread.tip_mm_s << " branch " << region.branch;
  return text.str();
}

TEST(RateBounds, HoldForAllWithinTheSpread) {
  int checked = 0;
  for_samples(
      11,
      [](const AxisRates& rates, const Region& region) {
        return rates.bounds(region.motion, region.clamping, region.branch, region.spread);
      },
      [&](const auto& machine, const AxisRates& rates, const Region& region,
          const RateBounds& bounds, const Clamping& clamping, const ToolMotion& motion) {
        const auto found = rates.at(motion, clamping, region.branch);
        if (!found || !is_within_reach(machine.model, motion, clamping)) return;
        ASSERT_TRUE(bounds.may_be_reached) << machine.name << " " << text_of(region);
        const double share = rounding_share(machine.model, motion, clamping);
        const double rotary = motion.turn_rad_s.norm() / machine.model.fixed.sin_lambda_sin_mu;
        const auto scale_of = [&](std::size_t axis) {
          return axis < 3 ? motion.tip_mm_s.norm() + 1000.0 * rotary : rotary;
        };
        for (std::size_t axis = 0; axis < analysis::axis_count; ++axis) {
          const double rate = (*found)[axis];
          const double slack = share * (rate + 1e-2 * scale_of(axis)) + 1e-12;
          ASSERT_LE(bounds.lower[axis], rate + slack)
              << machine.name << " axis " << axis << " " << text_of(region);
          ASSERT_GE(bounds.upper[axis], rate - slack)
              << machine.name << " axis " << axis << " " << text_of(region);
        }
        ++checked;
      });
  EXPECT_GT(checked, 100'000);
}

/// Bounds that were infinite everywhere would hold as well.
TEST(RateBounds, CloseOnTheRatesAsTheSpreadShrinks) {
  sample::RateRandom random{12};
  for (const auto& machine : sample::rate_machines(random_machines)) {
    if (machine.model.fixed.linear_place < 0) continue;
    const AxisRates rates{machine.model, 100.0};
    // The smaller the triangle, the more a change of its corners counts.
    const double product = machine.model.fixed.sin_lambda_sin_mu;
    for (int i = 0; i < 50; ++i) {
      Region region = random_region(random, machine.model);
      const double least = std::abs(machine.model.lambda_rad - machine.model.mu_rad);
      const double most = machine.model.lambda_rad + machine.model.mu_rad;
      region.motion =
          random.motion(random.direction_at(region.clamping.pole, 0.5 * (least + most)));
      region.spread = {.pole_rad = 1e-7,
                       .turn_rad = 1e-7,
                       .origin_mm = 1e-5,
                       .axis_rad = 1e-7,
                       .turn_rad_s = 1e-7,
                       .tip_mm = 1e-5,
                       .tip_mm_s = 1e-5};
      const auto found = rates.at(region.motion, region.clamping, region.branch);
      ASSERT_TRUE(found);
      const auto bounds =
          rates.bounds(region.motion, region.clamping, region.branch, region.spread);
      const double speed = region.motion.turn_rad_s.norm();
      for (std::size_t axis = 0; axis < analysis::axis_count; ++axis) {
        const double scale = axis < 3 ? 300.0 * speed + region.motion.tip_mm_s.norm() : speed;
        ASSERT_LT(bounds.upper[axis] - bounds.lower[axis],
                  1e-3 * (scale + 1.0) / (product * product))
            << machine.name << " axis " << axis;
      }
    }
  }
}

TEST(RateBounds, OfGroupsNeverLeaveOutAHigherRatio) {
  sample::RateRandom limits{13};
  int checked = 0;
  struct State {
    MotionGroup group;
    Spread about;
    SpeedShares shares;
  };
  for_samples(
      14,
      [&](const AxisRates&, const Region& region) {
        State state;
        Spread of_motion = region.spread;
        of_motion.pole_rad = of_motion.turn_rad = of_motion.origin_mm = 0.0;
        state.group.centre = region.motion;
        state.group.spread = of_motion;
        state.group.largest_turn_rad_s = region.motion.turn_rad_s.norm() + region.spread.turn_rad_s;
        state.group.largest_tip_mm_s = region.motion.tip_mm_s.norm() + region.spread.tip_mm_s;
        state.group.axis_sine = std::sin(region.spread.axis_rad);
        state.group.axis_cosine = std::cos(region.spread.axis_rad);
        state.about.pole_rad = region.spread.pole_rad;
        state.about.turn_rad = region.spread.turn_rad;
        state.about.origin_mm = region.spread.origin_mm;
        const bool has_linear = limits.chance(0.5);
        for (std::size_t axis = 0; axis < analysis::axis_count; ++axis)
          if (axis >= analysis::first_axis ? limits.chance(0.8) : has_linear)
            state.shares.time_per_way_s[axis] =
                axis >= analysis::first_axis ? limits.size(0.1, 10.0) : limits.size(1e-3, 0.1);
        state.shares.has_linear = has_linear;
        return state;
      },
      [&](const auto& machine, const AxisRates& rates, const Region& region, const State& state,
          const Clamping& clamping, const ToolMotion& motion) {
        const auto ratio = rates.ratio(motion, clamping, region.branch, state.shares);
        if (!ratio || *ratio == 0.0 || !is_within_reach(machine.model, motion, clamping)) return;
        ASSERT_TRUE(rates.may_exceed((1.0 - rounding) * *ratio, state.group, region.clamping,
                                     region.branch, state.about, state.shares))
            << machine.name << " ratio " << *ratio << " " << text_of(region);
        ++checked;
      });
  EXPECT_GT(checked, 100'000);
}

TEST(RateBounds, OfLinearValuesHoldForAllWithinTheSpread) {
  int checked = 0;
  for_samples(
      15,
      [](const AxisRates& rates, const Region& region) {
        return std::pair{
            rates.linear_mm(region.motion, region.clamping, region.branch),
            rates.linear_change_mm(region.motion, region.clamping, region.branch, region.spread)};
      },
      [&](const auto& machine, const AxisRates& rates, const Region& region, const auto& state,
          const Clamping& clamping, const ToolMotion& motion) {
        const auto found = rates.linear_mm(motion, clamping, region.branch);
        if (!found || !state.first) return;
        for (Eigen::Index axis = 0; axis < 3; ++axis)
          ASSERT_LE(std::abs((*found)[axis] - (*state.first)[axis]), state.second[axis] + 1e-7)
              << machine.name << " axis " << axis << " " << text_of(region);
        ++checked;
      });
  EXPECT_GT(checked, 50'000);
}

/// Where no sample is within reach a bound may say so; where one is, it must not.
TEST(RateBounds, SayThatNothingIsWithinReach) {
  const kinematics::Model model{sample::nutating_table()};
  const AxisRates rates{model, 0.0};
  const Clamping flat = reorient::clamping_of(model, Mat3::Identity(), Vec3::Zero());
  const Vec3 aside = flat.pole.cross(Vec3::UnitX()).norm() > 0.1 ? Vec3::UnitX() : Vec3::UnitY();
  const Vec3 across = (aside - aside.dot(flat.pole) * flat.pole).normalized();
  ToolMotion motion;
  motion.turn_rad_s = 0.1 * flat.pole.cross(across);
  Spread spread;
  spread.pole_rad = spread.axis_rad = 1.0 * rad_per_deg;
  // The table reaches tool axes up to 90 deg from its pole.
  for (const double beyond_deg : {1.0, 3.0}) {
    const double gamma_rad = (90.0 + beyond_deg) * rad_per_deg;
    motion.axis = std::cos(gamma_rad) * flat.pole + std::sin(gamma_rad) * across;
    // Without a posture in its middle a group tells nothing: that is allowed.
    EXPECT_TRUE(rates.bounds(motion, flat, 0, spread).upper[3] > 1e300 ||
                !rates.bounds(motion, flat, 0, spread).may_be_reached);
  }
}

}  // namespace
}  // namespace pentapost
