#include "lib/analysis/closest.hpp"
#include "lib/analysis/cut.hpp"
#include "pentapost/analysis/stretch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace pentapost::analysis {
namespace {

using kinematics::SingularityKind;
using sample::closest;
using sample::Cut;
using sample::tilted;

/// Past the highest tilt of a 45 deg nutating table, where K = 0: the tool axis all but horizontal.
TEST(Zones, ANutatingTableHasOneAtTheBoundaryOfItsReach) {
  Cut cut{"dmu-50-evolution"};
  cut.limit("B", 150.0);
  cut.limit("C", 150.0);
  // dB / d(tilt) = sin(tilt) / (sin 45 deg sin 45 deg sin B); at 89.5 deg of tilt sin B = 0.186.
  for (int i = 0; i <= 39; ++i) cut.to(tilted(70.0 + 0.5 * i, 20.0));
  const PathAnalysis analysis = cut.analysed();
  ASSERT_TRUE(closest(analysis));
  EXPECT_EQ(closest(analysis)->kind, SingularityKind::reach_boundary);
  EXPECT_NEAR(closest(analysis)->distance_rad * deg_per_rad, 0.5, 1e-6);
  ASSERT_EQ(analysis.zones.size(), 1U);
  const Zone& zone = analysis.zones[0];
  EXPECT_EQ(zone.closest->kind, SingularityKind::reach_boundary);
  EXPECT_EQ(zone.axis, second_axis);
  const double k = std::cos(89.5 * rad_per_deg);
  const double sine_b = std::sqrt(1.0 - (2.0 * k - 1.0) * (2.0 * k - 1.0));
  const double tilt_deg_s = 0.5 * 2000.0 / 60.0;
  EXPECT_NEAR(zone.peak_speed * deg_per_rad,
              tilt_deg_s * std::sin(89.5 * rad_per_deg) / (0.5 * sine_b), 1e-3);
  EXPECT_NEAR(zone.to.s_mm, 39.0, 1e-9);
  EXPECT_TRUE(analysis.over_demands.empty());
}

TEST(Zones, AHeadHasOneAtItsPole) {
  Cut cut{"generic-ca-head"};
  cut.limit("A", 60.0);
  cut.limit("C", 60.0);
  for (int i = -10; i <= 10; ++i) cut.to({0.02 * i, 0.01, 1.0});
  const PathAnalysis analysis = cut.analysed();
  ASSERT_EQ(analysis.zones.size(), 1U);
  EXPECT_EQ(analysis.zones[0].closest->kind, SingularityKind::pole);
  EXPECT_EQ(analysis.zones[0].axis, first_axis);
  EXPECT_NEAR(closest(analysis)->distance_rad, std::atan(0.01), 1e-9);
  // The great circle from point to point turns fastest half way: dC/dx = 0.02 / 0.01 per mm.
  EXPECT_NEAR(analysis.peaks[first_axis].speed, 0.02 / 0.01 * 2000.0 / 60.0, 0.05);
}

TEST(Zones, AThreeAxisMachineHasNone) {
  Cut cut{"generic-3axis"};
  for (int i = 0; i < 5; ++i) cut.to(Vec3::UnitZ());
  const PathAnalysis analysis = cut.analysed();
  EXPECT_TRUE(analysis.singularities.empty());
  EXPECT_TRUE(analysis.zones.empty());
  EXPECT_FALSE(closest(analysis));
  EXPECT_NEAR(analysis.peaks[0].speed, 2000.0 / 60.0, 1e-9);
  EXPECT_NEAR(analysis.length_mm, 4.0, 1e-12);
}

/// On an orthogonal table C rests on the way straight through the pole.
TEST(Zones, ExactlyThroughThePoleTheRatesAreFiniteAndCRests) {
  Cut cut{"hermle-c600u"};
  for (int i = -5; i <= 5; ++i) cut.to({0.0, 0.01 * i, 1.0});
  const PathAnalysis analysis = cut.analysed();
  ASSERT_TRUE(closest(analysis));
  EXPECT_NEAR(closest(analysis)->distance_rad, 0.0, 1e-12);
  EXPECT_LT(analysis.peaks[first_axis].speed, 1e-6);
  // dA/dx = 0.01 per mm at the pole.
  EXPECT_NEAR(analysis.peaks[second_axis].speed, 0.01 * 2000.0 / 60.0, 1e-4);
  EXPECT_TRUE(analysis.zones.empty());
}

/// The same between two points: the pole lies inside a move.
TEST(Zones, ThroughThePoleBetweenTwoPointsToo) {
  Cut cut{"hermle-c600u"};
  for (int i = -5; i <= 4; ++i) cut.to({0.0, 0.01 * (i + 0.5), 1.0});
  const PathAnalysis analysis = cut.analysed();
  EXPECT_NEAR(closest(analysis)->distance_rad, 0.0, 1e-9);
  EXPECT_LT(analysis.peaks[first_axis].speed, 1e-6);
  EXPECT_TRUE(analysis.zones.empty());
}

/// Seven digits lead past the pole by 1e-7 rad: that is the pole, and C need not race round it.
TEST(Zones, ByTheDigitsOfTheClDataThePoleIsNotMissed) {
  Cut cut{"hermle-c600u"};
  for (int i = -5; i <= 4; ++i) cut.to({1e-7, 0.01 * (i + 0.5), 1.0});
  cut.path.axis_rounding_rad = 1e-6;
  const PathAnalysis analysis = cut.analysed();
  // At the points beside it C is 2e-5 rad off, 0.5 mm from it.
  EXPECT_LT(analysis.peaks[first_axis].speed, 2e-5 / 0.5 * 2000.0 / 60.0 * 1.1);
  EXPECT_NEAR(closest(analysis)->distance_rad, 0.0, 1e-12);
  EXPECT_TRUE(analysis.zones.empty());
  EXPECT_NEAR(analysis.predicted_time_s, analysis.programmed_time_s, 1e-9);
}

/// A tilt of 1 deg a mm far from the pole needs 33 deg/s of A whatever the amplification.
TEST(Zones, APlainlyTooFastTiltIsNone) {
  Cut cut{"hermle-c600u"};
  cut.limit("A", 20.0);
  for (int i = 0; i <= 10; ++i) cut.to(tilted(40.0 + i, 90.0));
  const PathAnalysis analysis = cut.analysed();
  EXPECT_TRUE(analysis.zones.empty());
  ASSERT_EQ(analysis.over_demands.size(), 1U);
  const Zone& over = analysis.over_demands[0];
  EXPECT_EQ(over.axis, second_axis);
  EXPECT_NEAR(over.peak_ratio, 2000.0 / 60.0 / 20.0, 1e-6);
  EXPECT_NEAR(over.from.s_mm, 0.0, 1e-9);
  EXPECT_NEAR(over.to.s_mm, 10.0, 1e-9);
  // 10 deg at 20 deg/s
  EXPECT_NEAR(analysis.predicted_time_s, 0.5, 1e-6);
  EXPECT_NEAR(over.time_lost_s, 0.5 - 0.3, 1e-6);
}

/// 1 deg a mm at 2000 mm/min: as fast as A may turn, but for the last digits.
TEST(Zones, ADemandThatIsTheLimitIsNotOverIt) {
  for (const double tilt_deg : {30.0, 40.0, 50.0}) {
    Cut cut{"hermle-c600u"};
    cut.limit("A", 2000.0 / 60.0);
    for (int i = 0; i <= 10; ++i) cut.to(tilted(tilt_deg + i, 90.0));
    const PathAnalysis analysis = cut.analysed();
    EXPECT_NEAR(analysis.peaks[second_axis].ratio, 1.0, 1e-12);
    EXPECT_TRUE(analysis.over_demands.empty());
  }
}

/// Straight through the pole the first axis rests: the tilt is as fast there as anywhere.
TEST(Zones, APlainlyTooFastTiltThroughThePoleIsNoneEither) {
  Cut cut{"hermle-c600u"};
  cut.limit("A", 20.0);
  for (int i = -5; i <= 5; ++i) cut.to({0.0, 0.02 * i, 1.0});
  const PathAnalysis analysis = cut.analysed();
  EXPECT_TRUE(analysis.zones.empty());
  ASSERT_FALSE(analysis.over_demands.empty());
  EXPECT_EQ(analysis.over_demands[0].axis, second_axis);
  EXPECT_NEAR(analysis.peaks[second_axis].speed, 0.02 * 2000.0 / 60.0, 1e-3);
}

/// Past the pole at 0.57 deg A is plainly over all along, and C by the singularity: each is
/// reported with the axis that it is about, though the other one is over by more there.
TEST(Zones, AZoneAndAnOverDemandAtOnePlaceNameTheirOwnAxes) {
  Cut cut{"hermle-c600u"};
  cut.limit("A", 20.0);
  for (int i = -5; i <= 5; ++i) cut.to({0.01, 0.02 * i, 1.0});
  const PathAnalysis analysis = cut.analysed();
  ASSERT_EQ(analysis.zones.size(), 1U);
  EXPECT_EQ(analysis.zones[0].axis, first_axis);
  // At the nearest place: 0.02 / 0.01 rad a mm, 2000 mm/min, 150 deg/s.
  EXPECT_NEAR(analysis.zones[0].peak_ratio, 2.0 * deg_per_rad * 2000.0 / 60.0 / 150.0, 0.01);
  ASSERT_FALSE(analysis.over_demands.empty());
  for (const Zone& over : analysis.over_demands) {
    EXPECT_EQ(over.axis, second_axis);
    EXPECT_LE(over.peak_ratio, 0.02 * deg_per_rad * 2000.0 / 60.0 / 20.0 + 1e-3);
  }
}

/// The other way round: A needs 6 times its limit, C 4 times.
TEST(Zones, AZoneNamesTheAxisThatTheSingularityAmplifies) {
  Cut cut{"hermle-c600u"};
  cut.limit("A", 20.0 / 6.0);
  cut.limit("C", 600.0);
  for (int i = -5; i <= 5; ++i) cut.to({0.01, 0.02 * i, 1.0});
  const PathAnalysis analysis = cut.analysed();
  ASSERT_EQ(analysis.zones.size(), 1U);
  EXPECT_EQ(analysis.zones[0].axis, first_axis);
  EXPECT_NEAR(analysis.zones[0].peak_ratio, 2.0 * deg_per_rad * 2000.0 / 60.0 / 600.0, 0.01);
  // The feed is what all axes hold: A most slowly, at 0.02 rad a mm.
  EXPECT_LT(analysis.zones[0].lowest_feed_mm_min, 2000.0 / 6.0);
}

/// 3+2 machining with a horizontal tool on a 45 deg nutating table: B rests where the reach ends.
TEST(Zones, AToolThatRestsOnTheEndOfTheReachIsCuttingLikeAnyOther) {
  Cut cut{"dmu-50-evolution"};
  cut.limit("B", 150.0);
  cut.limit("C", 150.0);
  for (int i = 0; i <= 10; ++i) cut.to({0.0, 1.0, 0.0});
  const PathAnalysis analysis = cut.analysed();
  EXPECT_NEAR(analysis.programmed_time_s, 0.3, 1e-12);
  EXPECT_NEAR(analysis.predicted_time_s, 0.3, 1e-12);
  ASSERT_TRUE(closest(analysis));
  EXPECT_EQ(closest(analysis)->kind, SingularityKind::reach_boundary);
  EXPECT_NEAR(closest(analysis)->distance_rad, 0.0, 1e-12);
  EXPECT_EQ(analysis.peaks[first_axis].speed, 0.0);
  EXPECT_EQ(analysis.peaks[second_axis].speed, 0.0);
  // The table lies flat on its side and the tip goes along one of the linear axes.
  double fastest_mm_s = 0.0;
  for (std::size_t i = 0; i < first_axis; ++i)
    fastest_mm_s = std::max(fastest_mm_s, analysis.peaks[i].speed);
  EXPECT_NEAR(fastest_mm_s, 2000.0 / 60.0, 1e-9);
  EXPECT_TRUE(analysis.zones.empty());
}

/// All horizontal tool axes lie on that end: C alone turns, as far as the tool does.
TEST(Zones, AToolThatTurnsAlongTheEndOfTheReachTurnsTheFirstAxisAlone) {
  Cut cut{"dmu-50-evolution"};
  for (int i = 0; i <= 10; ++i) cut.to({std::cos(0.02 * i), std::sin(0.02 * i), 0.0});
  const PathAnalysis analysis = cut.analysed();
  EXPECT_NEAR(analysis.predicted_time_s, 0.3, 1e-12);
  EXPECT_NEAR(analysis.peaks[first_axis].speed, 0.02 * 2000.0 / 60.0, 1e-6);
  EXPECT_NEAR(analysis.peaks[second_axis].speed, 0.0, 1e-6);
}

/// So close to that end all bounds are far too large, but C runs evenly and B hardly moves.
TEST(Zones, AMoveBesideTheEndOfTheReachTakesFewPlaces) {
  for (const double miss : {1e-9, 1e-8, 1e-7}) {
    Cut cut{"dmu-50-evolution"};
    cut.to({1.0, 0.0, miss});
    cut.to({0.5, std::sqrt(0.75), miss});
    const PathAnalysis analysis = cut.analysed({.most_samples = 100'000});
    EXPECT_LT(analysis.samples.size(), 1000U) << miss;
    EXPECT_NEAR(analysis.peaks[first_axis].speed, pi / 3.0 * 2000.0 / 60.0, 1e-2) << miss;
  }
}

/// An axis that differs in its last digits from move to move, and a machine that cannot follow it.
TEST(Zones, AMoveThatTheRotaryAxesFollowOnlyWithinTheSlackIsCuttingLikeAnyOther) {
  for (const char* machine : {"generic-3axis", "generic-4axis-a"}) {
    Cut cut{machine};
    for (int i = 0; i <= 10; ++i) cut.to({1e-5 * (i % 2), 0.0, 1.0});
    const PathAnalysis analysis = cut.analysed();
    EXPECT_NEAR(analysis.predicted_time_s, 0.3, 1e-12) << machine;
    EXPECT_NEAR(analysis.peaks[0].speed, 2000.0 / 60.0, 1e-9) << machine;
  }
}

/// At a pole the second axis is not amplified, where the reach ends both are.
TEST(Amplification, IsThatOfEachAxis) {
  const kinematics::Model swivel{sample::bundled_machine("hermle-c600u").chain};
  EXPECT_NEAR(amplification(swivel, first_axis, std::sin(0.01), tilted(0.01 * deg_per_rad, 30.0)),
              1.0 / std::sin(0.01), 1e-9);
  EXPECT_NEAR(amplification(swivel, second_axis, std::sin(0.01), tilted(0.01 * deg_per_rad, 30.0)),
              1.0, 1e-12);
  // Of a triangle with two sides of 45 deg: K = (1 + cos B) / 2, and the angle at the tool.
  const kinematics::Model nutating{sample::bundled_machine("dmu-50-evolution").chain};
  for (const double tilt_deg : {1.0, 30.0, 60.0, 89.9}) {
    const double cosine_b = 2.0 * std::cos(tilt_deg * rad_per_deg) - 1.0;
    const double sine_b = std::sqrt(1.0 - cosine_b * cosine_b);
    const double tool_angle_sine = std::sqrt(0.5) * sine_b / std::sin(tilt_deg * rad_per_deg);
    EXPECT_NEAR(
        amplification(nutating, second_axis, sine_b, tilted(tilt_deg, 70.0)) * tool_angle_sine, 1.0,
        1e-9);
  }
}

/// A tilt of 1e-9 rad is the rounding of unit vectors, and no distance to divide by.
TEST(ClStretchNearThePole, HasNoRatesWithinTheRoundingOfTheAxes) {
  const kinematics::Model model{sample::bundled_machine("hermle-c600u").chain};
  for (const double tilt : {1e-9, 1e-6}) {
    const path::Segment move{Vec3::Zero(), Vec3{std::sin(0.1), 0.0, std::cos(0.1)}, Vec3::UnitX(),
                             Vec3{std::sin(tilt), 0.0, std::cos(tilt)}};
    const double first_rad = 0.5 * pi;
    std::optional<kinematics::JointMotion> end;
    const ClStretch stretch{model,
                            move,
                            ClStretch::Follows::branch,
                            0,
                            {.first_from_rad = first_rad,
                             .first_to_rad = first_rad,
                             .second_from_rad = 0.1,
                             .second_to_rad = tilt},
                            0.0,
                            Vec3::Zero(),
                            0.0,
                            end};
    EXPECT_TRUE(stretch.at(0.5));
    EXPECT_EQ(stretch.at(1.0).has_value(), tilt > 1e-8) << tilt;
  }
}

TEST(Times, AreGivenByToolAndOperation) {
  Cut cut{"hermle-c600u"};
  cut.path.add_event(1, path::Operation{"ROUGH"});
  cut.to(Vec3::UnitZ());
  cut.to(Vec3::UnitZ());
  cut.path.add_event(3, path::Operation{"FINISH"});
  cut.to(Vec3::UnitZ());
  cut.path.add_event(4, path::ToolChange{.number = 7});
  cut.to(Vec3::UnitZ());
  cut.to(Vec3::UnitZ());
  const auto operations = cut.analysed().operations;
  ASSERT_EQ(operations.size(), 3U);
  EXPECT_EQ(operations[0].operation, "ROUGH");
  EXPECT_EQ(operations[1].operation, "FINISH");
  EXPECT_EQ(operations[1].tool_number, 1);
  EXPECT_EQ(operations[2].tool_number, 7);
  for (const OperationTime& each : operations) {
    EXPECT_NEAR(each.length_mm, 1.0, 1e-12);
    EXPECT_NEAR(each.programmed_time_s, 0.03, 1e-12);
    EXPECT_NEAR(each.predicted_time_s, 0.03, 1e-9);
  }
}

TEST(Zones, AShareOfTheLimitWidensThem) {
  Cut cut{"hermle-c600u"};
  for (int i = -25; i <= 25; ++i) cut.to({0.01 * i, 0.02, 1.0});
  const auto width = [&](double share) {
    const PathAnalysis analysis = cut.analysed({.share = share});
    return analysis.zones.empty() ? 0.0 : analysis.zones[0].to.s_mm - analysis.zones[0].from.s_mm;
  };
  EXPECT_GT(width(0.2), width(0.4));
  EXPECT_GT(width(0.4), 0.0);
}

}  // namespace
}  // namespace pentapost::analysis
