#include "pentapost/verify/block_deviation.hpp"

#include "pentapost/kinematics/forward.hpp"
#include "sample/chains.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace pentapost::verify {
namespace {

using kinematics::Joints;
using kinematics::Model;
using path::Segment;

constexpr Deviation nothing_proven{0.0, 0.0};

Joints rotary(double first_deg, double second_deg, const Vec3& linear_mm = Vec3::Zero()) {
  return {.linear_mm = linear_mm,
          .first_rad = first_deg * rad_per_deg,
          .second_rad = second_deg * rad_per_deg};
}

/// Tool axis of hermle-c600u: Rz(-C) Rx(-A) z (Cripps et al. 2017 eq. (1)).
Vec3 hermle_axis(double c_deg, double a_deg) {
  const double c = c_deg * rad_per_deg, a = a_deg * rad_per_deg;
  return {std::sin(a) * std::sin(c), std::sin(a) * std::cos(c), std::cos(a)};
}

Deviation limits(double tip_mm, double axis_deg) {
  return {tip_mm, chord_of_angle(axis_deg * rad_per_deg)};
}

double axis_deg(const Deviation& deviation) {
  return angle_of_chord(deviation.axis_chord) * deg_per_rad;
}

Deviation deviation_of(const BlockCurve& curve, const Segment& move, const Deviation& limit,
                       double from_fraction = 0.0, double to_fraction = 1.0) {
  return largest_deviation(curve, curve.at(0.0), curve.at(1.0),
                           {.move = move,
                            .from_fraction = from_fraction,
                            .to_fraction = to_fraction,
                            .tip_resolution_mm = 0.0},
                           nothing_proven, limit);
}

class OnHermle : public ::testing::Test {
 protected:
  Model model_{sample::trunnion_ac()};
  ChainShape shape_{model_};
};

TEST_F(OnHermle, ATiltAtRestingCStaysOnTheGreatCircle) {
  const BlockCurve curve =
      BlockCurve::tip_line(shape_, {0, 0, 0}, {10, 0, 0}, rotary(30, 0), rotary(30, 10));
  const Segment move{{0, 0, 0}, hermle_axis(30, 0), {10, 0, 0}, hermle_axis(30, 10)};

  const Deviation found = deviation_of(curve, move, limits(0.01, 0.05));

  EXPECT_LT(found.tip_mm, 1e-13);
  EXPECT_LT(axis_deg(found), 1e-12);
}

// The small circle of tilt gamma against the great circle between its ends: half way, Napier's rule
// gives tan(gamma_great) = tan(gamma) cos(sweep / 2).
TEST_F(OnHermle, ASweepOfCLeavesTheGreatCircleAsNapiersRuleSays) {
  for (const double tilt_deg : {5.0, 20.0, 45.0, 80.0})
    for (const double sweep_deg : {2.0, 10.0, 30.0}) {
      SCOPED_TRACE(testing::Message() << tilt_deg << ' ' << sweep_deg);
      const BlockCurve curve = BlockCurve::tip_line(
          shape_, {0, 0, 0}, {10, 0, 0}, rotary(0, tilt_deg), rotary(sweep_deg, tilt_deg));
      const Segment move{
          {0, 0, 0}, hermle_axis(0, tilt_deg), {10, 0, 0}, hermle_axis(sweep_deg, tilt_deg)};
      const double expected_deg =
          tilt_deg - deg_per_rad * std::atan(std::tan(tilt_deg * rad_per_deg) *
                                             std::cos(0.5 * sweep_deg * rad_per_deg));

      const Deviation found = deviation_of(curve, move, limits(0.01, expected_deg * 1.1));

      EXPECT_GE(axis_deg(found), expected_deg * (1 - 1e-9));
      EXPECT_LE(axis_deg(found), expected_deg * 1.0015);
    }
}

TEST_F(OnHermle, AWholeTurnOfCDoesNotPassForStandingStill) {
  const BlockCurve curve =
      BlockCurve::tip_line(shape_, {0, 0, 0}, {10, 0, 0}, rotary(0, 10), rotary(360, 10));
  const Segment move{{0, 0, 0}, hermle_axis(0, 10), {10, 0, 0}, hermle_axis(0, 10)};

  EXPECT_GT(axis_deg(deviation_of(curve, move, limits(0.01, 0.05))), 0.05);
}

TEST_F(OnHermle, CTurnsFreelyAtThePole) {
  const BlockCurve curve =
      BlockCurve::tip_line(shape_, {0, 0, 0}, {10, 0, 0}, rotary(0, 0), rotary(72000, 0));
  const Segment move{{0, 0, 0}, Vec3::UnitZ(), {10, 0, 0}, Vec3::UnitZ()};

  EXPECT_LT(axis_deg(deviation_of(curve, move, limits(0.01, 0.05))), 1e-9);
}

TEST_F(OnHermle, ThousandsOfTurnsNextToThePoleAreDecided) {
  const double tilt_deg = 0.001;
  const BlockCurve curve = BlockCurve::tip_line(shape_, {0, 0, 0}, {10, 0, 0}, rotary(0, tilt_deg),
                                                rotary(3.6e6, tilt_deg));
  const Segment move{{0, 0, 0}, hermle_axis(0, tilt_deg), {10, 0, 0}, hermle_axis(0, tilt_deg)};

  EXPECT_LE(axis_deg(deviation_of(curve, move, limits(0.01, 0.05))), 0.05);
  EXPECT_GT(axis_deg(deviation_of(curve, move, limits(0.01, 0.0019))), 0.0019);
}

// A point that rests at radius r on the turning table: the linear axes run along the chord.
TEST_F(OnHermle, WithoutTcpARestingTipLeavesByTheSagitta) {
  const double radius_mm = 120.0, sweep_rad = 8.0 * rad_per_deg;
  // table frame = Rz(-C) joints, so joints = Rz(C) tip
  const Vec3 to{radius_mm * std::cos(sweep_rad), radius_mm * std::sin(sweep_rad), 0.0};
  const BlockCurve curve = BlockCurve::joint_line(shape_, rotary(0, 0, {radius_mm, 0, 0}),
                                                  rotary(8, 0, to), 0.0, Vec3::Zero());
  const Segment move{{radius_mm, 0, 0}, Vec3::UnitZ(), {radius_mm, 0, 0}, Vec3::UnitZ()};
  const double expected_mm = radius_mm * (1.0 - std::cos(0.5 * sweep_rad));  // 0.2923 mm

  const Deviation found = deviation_of(curve, move, limits(0.3, 0.05));

  EXPECT_GE(found.tip_mm, expected_mm * (1 - 1e-9));
  EXPECT_LE(found.tip_mm, expected_mm * 1.0015);
}

TEST_F(OnHermle, WithoutTcpARestingToolCutsAnArcIntoTheTurningTable) {
  const double radius_mm = 75.0;
  const BlockCurve curve = BlockCurve::joint_line(
      shape_, rotary(0, 0, {radius_mm, 0, 0}), rotary(6, 0, {radius_mm, 0, 0}), 0.0, Vec3::Zero());
  const double sweep_rad = 6.0 * rad_per_deg;
  const Vec3 end{radius_mm * std::cos(sweep_rad), -radius_mm * std::sin(sweep_rad), 0.0};
  const Segment move{{radius_mm, 0, 0}, Vec3::UnitZ(), end, Vec3::UnitZ()};
  const double expected_mm = radius_mm * (1.0 - std::cos(0.5 * sweep_rad));  // 0.1028 mm

  const Deviation found = deviation_of(curve, move, limits(0.11, 0.05));

  EXPECT_GE(found.tip_mm, expected_mm * (1 - 1e-9));
  EXPECT_LE(found.tip_mm, expected_mm * 1.0015);
}

TEST_F(OnHermle, AChordOfACircleLeavesItByTheSagitta) {
  const path::Arc arc{.centre_wp_mm = {0, 0, 0}, .normal_wp = Vec3::UnitZ(), .sweep_rad = 2 * pi};
  const Segment move{{50, 0, 0}, Vec3::UnitZ(), {50, 0, 0}, Vec3::UnitZ(), &arc};
  const double angle_rad = 2 * pi / 40;
  const Vec3 from{50, 0, 0}, to{50 * std::cos(angle_rad), 50 * std::sin(angle_rad), 0};
  const BlockCurve curve = BlockCurve::tip_line(shape_, from, to, rotary(0, 0), rotary(0, 0));
  const double expected_mm = 50 * (1 - std::cos(angle_rad / 2));  // 0.1541 mm

  const Deviation found = deviation_of(curve, move, limits(0.2, 0.05), 0.0, 1.0 / 40);

  EXPECT_GE(found.tip_mm, expected_mm * (1 - 1e-9));
  EXPECT_LE(found.tip_mm, expected_mm + 0.001 * 0.2);
}

TEST_F(OnHermle, ABlockThatStandsWhereTheMoveStandsHasItsEndDeviationsOnly) {
  const BlockCurve curve =
      BlockCurve::tip_line(shape_, {1, 2, 3.004}, {1, 2, 3.004}, rotary(0, 20), rotary(0, 20));
  const Segment move{{1, 2, 3}, hermle_axis(0, 20), {1, 2, 3}, hermle_axis(0, 20)};

  const Deviation found = deviation_of(curve, move, limits(0.01, 0.05));

  EXPECT_NEAR(found.tip_mm, 0.004, 1e-12);
  EXPECT_LT(axis_deg(found), 1e-12);
}

TEST_F(OnHermle, TheTipIsHeldAgainstThePartThatTheBlockCovers) {
  const BlockCurve curve =
      BlockCurve::tip_line(shape_, {0, 0, 0}, {10, 0, 0}, rotary(0, 0), rotary(0, 0));
  const Segment move{{0, 0, 0}, Vec3::UnitZ(), {10, 0, 0}, Vec3::UnitZ()};

  EXPECT_NEAR(deviation_of(curve, move, limits(9, 1), 0.0, 0.5).tip_mm, 5.0, 1e-9);
}

TEST_F(OnHermle, WhatIsNotFiniteIsNotANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Segment move{{0, 0, 0}, Vec3::UnitZ(), {10, 0, 0}, Vec3::UnitZ()};
  for (const Vec3& end : {Vec3{nan, 0, 0}, Vec3{std::numeric_limits<double>::infinity(), 0, 0}}) {
    const BlockCurve curve =
        BlockCurve::tip_line(shape_, {0, 0, 0}, end, rotary(0, 0), rotary(0, 0));
    EXPECT_TRUE(std::isnan(deviation_of(curve, move, limits(0.01, 0.05)).tip_mm));
  }
}

TEST_F(OnHermle, WhatIsProvenElsewhereIsALowerBoundOfTheAnswer) {
  const BlockCurve curve =
      BlockCurve::tip_line(shape_, {0, 0, 0}, {10, 0, 0}, rotary(0, 20), rotary(5, 20));
  const Segment move{{0, 0, 0}, hermle_axis(0, 20), {10, 0, 0}, hermle_axis(5, 20)};
  const Deviation limit = limits(0.01, 0.5), proven = limits(0.003, 0.4);

  const Deviation found =
      largest_deviation(curve, curve.at(0), curve.at(1), {.move = move}, proven, limit);

  EXPECT_EQ(found.tip_mm, proven.tip_mm);
  EXPECT_EQ(found.axis_chord, proven.axis_chord);
}

TEST_F(OnHermle, ALimitJustAboveAndJustBelowTheTruthIsDecidedRightly) {
  const BlockCurve curve =
      BlockCurve::tip_line(shape_, {0, 0, 0}, {10, 0, 0}, rotary(0, 20), rotary(5, 20));
  const Segment move{{0, 0, 0}, hermle_axis(0, 20), {10, 0, 0}, hermle_axis(5, 20)};
  const double truth_deg =
      20 - deg_per_rad *
               std::atan(std::tan(20 * rad_per_deg) * std::cos(2.5 * rad_per_deg));  // 0.01753 deg

  const double above_deg = truth_deg * (1 + 1e-6), below_deg = truth_deg * (1 - 1e-6);
  EXPECT_LE(axis_deg(deviation_of(curve, move, limits(0.01, above_deg))), above_deg);
  EXPECT_GT(axis_deg(deviation_of(curve, move, limits(0.01, below_deg))), below_deg);
}

/// The definition, at many places: slow, and without any of the bounds.
class Sampler {
 public:
  Sampler(const Segment& move, double from_fraction, double to_fraction, double resolution_mm,
          bool by_projection)
      : move_{move},
        from_{from_fraction},
        to_{to_fraction},
        draw_{move.length_mm() > 0 ? resolution_mm / move.length_mm() : 1e9},
        by_projection_{by_projection} {}

  void take(double s, const Vec3& tip_mm, const Vec3& axis) {
    const double even = from_ + s * (to_ - from_);
    const double nearest = std::clamp(move_.projected_fraction(tip_mm, even), from_, to_);
    double counted = even;
    if (by_projection_ && std::abs(nearest - even) > draw_)
      counted = nearest - std::copysign(draw_, nearest - even);
    largest_.tip_mm = std::max(largest_.tip_mm, (tip_mm - move_.tip_mm(nearest)).norm());
    largest_.axis_chord =
        std::max(largest_.axis_chord, chord_of_angle(angle_between_rad(axis, move_.axis(counted))));
  }
  const Deviation& largest() const { return largest_; }

 private:
  const Segment& move_;
  double from_, to_, draw_;
  bool by_projection_;
  Deviation largest_;
};

constexpr int places = 20'000;

/// Distance from an arc by narrowing down around the place of equal turns, which on a helix is not
/// the nearest one.
double distance_mm(const Segment& arc, const Vec3& point_mm, double near_fraction) {
  const double middle = arc.nearest_fraction(point_mm, near_fraction);
  double lower = std::max(0.0, middle - 0.01), upper = std::min(1.0, middle + 0.01);
  const auto at = [&](double fraction) { return (arc.tip_mm(fraction) - point_mm).norm(); };
  while (upper - lower > 1e-9) {
    const double third = (upper - lower) / 3;
    if (at(lower + third) < at(upper - third))
      upper -= third;
    else
      lower += third;
  }
  return std::min(at(lower), at(upper));
}

void expect_bound(const Deviation& sampled,
                  const std::function<Deviation(const Deviation&)>& find) {
  const Deviation limit{1.3 * sampled.tip_mm + 1e-12, 1.3 * sampled.axis_chord + 1e-14};
  const Deviation found = find(limit);
  EXPECT_GE(found.tip_mm, sampled.tip_mm - 1e-12);
  EXPECT_LE(found.tip_mm, sampled.tip_mm * 1.002 + 1e-12);
  EXPECT_GE(found.axis_chord, sampled.axis_chord - 1e-14);
  EXPECT_LE(found.axis_chord, sampled.axis_chord * 1.002 + 2e-14);
}

struct RandomBlock {
  Joints from, to;
  double turn_deg;
};

RandomBlock random_block(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit{-1.0, 1.0};
  const double turns_deg[] = {0.0, 0.01, 1.0, 10.0, 60.0};
  const double ways_mm[] = {0.0, 0.001, 1.0, 30.0};
  const double turn_deg = turns_deg[random() % 5], way_mm = ways_mm[random() % 4];
  RandomBlock block{.from = rotary(180 * unit(random), 90 * unit(random),
                                   {200 * unit(random), 200 * unit(random), 200 * unit(random)}),
                    .to = {},
                    .turn_deg = turn_deg};
  block.to = {
      .linear_mm = block.from.linear_mm + way_mm * Vec3{unit(random), unit(random), unit(random)},
      .first_rad = block.from.first_rad + turn_deg * rad_per_deg * unit(random),
      .second_rad = block.from.second_rad + turn_deg * rad_per_deg * unit(random)};
  return block;
}

Vec3 noise(std::mt19937_64& random, double size) {
  std::uniform_real_distribution<double> unit{-size, size};
  return {unit(random), unit(random), unit(random)};
}

Joints between(const Joints& from, const Joints& to, double s) {
  return {.linear_mm = from.linear_mm + s * (to.linear_mm - from.linear_mm),
          .first_rad = from.first_rad + s * (to.first_rad - from.first_rad),
          .second_rad = from.second_rad + s * (to.second_rad - from.second_rad)};
}

Joints of_chain(const Model& model, Joints joints) {
  if (model.rotary_count < 1) joints.first_rad = 0;
  if (model.rotary_count < 2) joints.second_rad = 0;
  return joints;
}

class DeviationOn : public ::testing::TestWithParam<sample::NamedChain> {};

TEST_P(DeviationOn, BoundsTcpBlocksAsDenseSamplingDoes) {
  const Model model{GetParam().chain};
  const ChainShape shape{model};
  std::mt19937_64 random{42};
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    const RandomBlock block = random_block(random);
    const Joints from = of_chain(model, block.from), to = of_chain(model, block.to);
    const BlockCurve curve = BlockCurve::tip_line(shape, from.linear_mm, to.linear_mm, from, to);
    const auto axis_at = [&](double s) {
      const Joints joints = between(from, to, s);
      return kinematics::forward_axis(model, joints.first_rad, joints.second_rad);
    };
    const Segment move{
        from.linear_mm + noise(random, 1e-3), (axis_at(0) + noise(random, 1e-5)).normalized(),
        to.linear_mm + noise(random, 1e-3), (axis_at(1) + noise(random, 1e-5)).normalized()};
    Sampler sampler{move, 0, 1, 0, false};
    for (int k = 0; k <= places; ++k) {
      const double s = static_cast<double>(k) / places;
      sampler.take(s, from.linear_mm + s * (to.linear_mm - from.linear_mm), axis_at(s));
    }
    expect_bound(sampler.largest(), [&](const Deviation& limit) {
      return largest_deviation(curve, curve.at(0), curve.at(1), {.move = move}, nothing_proven,
                               limit);
    });
    const Deviation quick = quick_bound(curve, curve.at(0), curve.at(1), move.tip_from_mm(),
                                        move.axis_from(), move.tip_to_mm(), move.axis_to(), 0.0);
    EXPECT_GE(quick.tip_mm, sampler.largest().tip_mm - 1e-12);
    EXPECT_GE(quick.axis_chord, sampler.largest().axis_chord - 1e-14);
  }
}

TEST_P(DeviationOn, BoundsBlocksOfJointValuesAsDenseSamplingDoes) {
  const Model model{GetParam().chain};
  const ChainShape shape{model};
  const double gauge_mm = 150.0, resolution_mm = 0.0005 * std::sqrt(3.0);
  const Vec3 origin{10, -20, 30};
  std::mt19937_64 random{43};
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    const RandomBlock block = random_block(random);
    const Joints from = of_chain(model, block.from), to = of_chain(model, block.to);
    const BlockCurve curve = BlockCurve::joint_line(shape, from, to, gauge_mm, origin);
    const auto pose_at = [&](double s) {
      return kinematics::forward(model, between(from, to, s), gauge_mm);
    };
    const Segment move{pose_at(0).tip_mm - origin + noise(random, 1e-3),
                       (pose_at(0).axis + noise(random, 1e-5)).normalized(),
                       pose_at(1).tip_mm - origin + noise(random, 1e-3),
                       (pose_at(1).axis + noise(random, 1e-5)).normalized()};
    Sampler sampler{move, 0, 1, resolution_mm, true};
    for (int k = 0; k <= places; ++k) {
      const double s = static_cast<double>(k) / places;
      sampler.take(s, pose_at(s).tip_mm - origin, pose_at(s).axis);
    }
    expect_bound(sampler.largest(), [&](const Deviation& limit) {
      return largest_deviation(curve, curve.at(0), curve.at(1),
                               {.move = move, .tip_resolution_mm = resolution_mm}, nothing_proven,
                               limit);
    });
    const Deviation quick =
        quick_bound(curve, curve.at(0), curve.at(1), move.tip_from_mm(), move.axis_from(),
                    move.tip_to_mm(), move.axis_to(), resolution_mm);
    EXPECT_GE(quick.tip_mm, sampler.largest().tip_mm - 1e-12);
    EXPECT_GE(quick.axis_chord, sampler.largest().axis_chord - 1e-14);
  }
}

INSTANTIATE_TEST_SUITE_P(, DeviationOn, ::testing::ValuesIn(sample::chains()),
                         [](const auto& param_info) { return param_info.param.name; });

path::Arc random_arc(std::mt19937_64& random, double sweep_rad) {
  return {.centre_wp_mm = noise(random, 50.0),
          .normal_wp = noise(random, 1.0).normalized(),
          .sweep_rad = sweep_rad};
}

Segment run_arc(const path::Arc& arc, double radius_mm, double rise_mm) {
  const Vec3 arm = radius_mm * arc.normal_wp.unitOrthogonal();
  const Vec3 end = Eigen::AngleAxisd{arc.sweep_rad, arc.normal_wp} * arm;
  return {arc.centre_wp_mm + arm, Vec3::UnitZ(), arc.centre_wp_mm + end + rise_mm * arc.normal_wp,
          Vec3::UnitZ(), &arc};
}

TEST_F(OnHermle, PrintedArcsAreBoundedAsDenseSamplingDoes) {
  std::mt19937_64 random{44};
  std::uniform_real_distribution<double> unit{0.0, 1.0};
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const path::Arc arc = random_arc(random, 0.1 + 12 * unit(random));
    const Segment move = run_arc(arc, 0.5 + 80 * unit(random), 5 * unit(random));
    path::Arc rounded = arc;
    rounded.centre_wp_mm += noise(random, 1e-3);
    const Segment printed{move.tip_from_mm() + noise(random, 1e-3), Vec3::UnitZ(),
                          move.tip_to_mm() + noise(random, 1e-3), Vec3::UnitZ(), &rounded};
    const BlockCurve curve = BlockCurve::arc(shape_, printed, rotary(0, 0));
    double sampled_mm = 0.0, of_equal_turns_mm = 0.0;
    for (int k = 0; k <= 2'000; ++k) {
      const double s = k / 2'000.0;
      const Vec3 tip = printed.tip_mm(s);
      sampled_mm = std::max(sampled_mm, distance_mm(move, tip, s));
      of_equal_turns_mm =
          std::max(of_equal_turns_mm, (tip - move.tip_mm(move.nearest_fraction(tip, s))).norm());
    }
    const Deviation found =
        deviation_of(curve, move, {1.3 * of_equal_turns_mm, chord_of_angle(1e-3)});
    EXPECT_GE(found.tip_mm, sampled_mm - 1e-9);
    EXPECT_LE(found.tip_mm, of_equal_turns_mm * 1.002);
  }
}

TEST_F(OnHermle, ChordsOfArcsAreBoundedAsDenseSamplingDoes) {
  std::mt19937_64 random{45};
  std::uniform_real_distribution<double> unit{0.0, 1.0};
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const path::Arc arc = random_arc(random, 0.1 + 6 * unit(random));
    const Segment move = run_arc(arc, 0.5 + 80 * unit(random), 0.0);
    const double from = 0.9 * unit(random), to = from + 0.02 + 0.08 * unit(random);
    const Vec3 tip_from = move.tip_mm(from) + noise(random, 1e-3);
    const Vec3 tip_to = move.tip_mm(to) + noise(random, 1e-3);
    const BlockCurve curve =
        BlockCurve::tip_line(shape_, tip_from, tip_to, rotary(0, 0), rotary(0, 0));
    Sampler sampler{move, from, to, 0, false};
    for (int k = 0; k <= places; ++k) {
      const double s = static_cast<double>(k) / places;
      sampler.take(s, tip_from + s * (tip_to - tip_from), Vec3::UnitZ());
    }
    expect_bound(sampler.largest(), [&](const Deviation& limit) {
      return deviation_of(curve, move, limit, from, to);
    });
  }
}

TEST(Chord, KeepsSmallAngles) {
  EXPECT_NEAR(chord_of_angle(1e-12), 1e-12, 1e-27);
  EXPECT_NEAR(angle_of_chord(1e-12), 1e-12, 1e-27);
  EXPECT_NEAR(angle_of_chord(chord_of_angle(3.0)), 3.0, 1e-14);
  EXPECT_NEAR(angle_of_chord(2.5), pi, 1e-15);
}

}  // namespace
}  // namespace pentapost::verify
