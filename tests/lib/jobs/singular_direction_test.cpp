// Where a reorientation puts the singular direction: Cripps et al. 2017, section 3.2, for any
// machine.
#include "lib/jobs/setup_oracle.hpp"
#include "machines/bundled.hpp"
#include "pentapost/jobs/analyse.hpp"
#include "pentapost/jobs/reorient.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace pentapost {
namespace {

/// Direction of the rotary axis nearest the workpiece, read from the definition.
std::optional<Vec3> first_axis_of(const machine::Chain& chain) {
  for (const auto& joints : {chain.table(), chain.head()})
    for (const machine::Joint& joint : joints)
      if (const auto* rotary = std::get_if<machine::RotaryJoint>(&joint.kind))
        return rotary->direction.vec();
  return std::nullopt;
}

/// S = R_z(-theta_z) R_x(-theta_x) p in the paper's passive matrices.
Vec3 singular_direction(const Vec3& p, double theta_x_rad, double theta_z_rad) {
  const double cx = std::cos(-theta_x_rad), sx = std::sin(-theta_x_rad);
  const double cz = std::cos(-theta_z_rad), sz = std::sin(-theta_z_rad);
  const Vec3 tilted{p.x(), cx * p.y() + sx * p.z(), -sx * p.y() + cx * p.z()};
  return {cz * tilted.x() + sz * tilted.y(), -sz * tilted.x() + cz * tilted.y(), tilted.z()};
}

/// Tool axes on a great circle that passes `pole` at `distance_rad`.
jobs::PointPath fan_past(const Vec3& pole, double distance_rad, const Vec3& any) {
  const Vec3 aside = pole.cross(any).normalized();
  const Vec3 nearest = Eigen::AngleAxisd{distance_rad, aside} * pole;
  jobs::PointPath path{.feed_mm_min = 600.0, .tip_mm = {}, .axis = {}};
  for (int i = -3; i <= 3; ++i) {
    path.tip_mm.push_back({2.0 * i, 0.3 * i, 1.0});
    // About the normal of the circle, which the nearest axis and `aside` lie in.
    path.axis.push_back(Eigen::AngleAxisd{0.02 * i, nearest.cross(aside)} * nearest);
  }
  return path;
}

TEST(SingularDirection, IsWhereTheAnalysisOfTheReorientedPathFindsIt) {
  std::mt19937_64 random{20};
  std::uniform_real_distribution<double> angle{-40.0, 40.0}, turn{-180.0, 180.0}, unit{-1.0, 1.0};
  int machines = 0;
  for (const auto& [definition] : sample::bundled_machines()) {
    if (definition.chain.rotary_count() != 2) continue;
    const Vec3 p = *first_axis_of(definition.chain);
    int found = 0;
    for (int i = 0; i < 40; ++i) {
      const jobs::Setup setup{.theta_x_deg = angle(random), .theta_z_deg = turn(random)};
      const Vec3 s =
          singular_direction(p, setup.theta_x_deg * rad_per_deg, setup.theta_z_deg * rad_per_deg);
      const double distance_deg = 0.5 + 3.0 * std::abs(unit(random));
      const Vec3 any{unit(random), unit(random), unit(random)};
      for (const double sign : {1.0, -1.0}) {
        const auto report =
            jobs::analyse({.job = {.machine = definition,
                                   .path = fan_past(sign * s, distance_deg * rad_per_deg, any),
                                   .setup = setup}});
        if (!report) continue;  // that end of the axis is out of reach or range
        // Of several singular axes the analysis names the nearest; this pole is one of them where
        // the machine has it.
        for (const auto& each : report->singular_directions)
          EXPECT_LT(each.direction.cross(s).norm(), 1e-9) << definition.name;
        const bool has_pole =
            std::any_of(report->singular_directions.begin(), report->singular_directions.end(),
                        [&](const auto& each) {
                          return each.half_angle_deg == 0.0 && each.direction.dot(sign * s) > 0.0;
                        });
        if (!has_pole) continue;
        ++found;
        ASSERT_TRUE(report->closest_approach_deg) << definition.name;
        EXPECT_NEAR(*report->closest_approach_deg, distance_deg, 1e-6) << definition.name;
      }
    }
    EXPECT_GT(found, 5) << definition.name;
    ++machines;
  }
  EXPECT_GE(machines, 14);
}

TEST(SingularDirection, OfTheReportIsTheSame) {
  jobs::ReorientJob job{.job = {.machine = sample::bundled_machine("pocket-nc-v2"),
                                .path = fan_past({0.2, 0.3, 0.93}, 0.4, {1.0, 0.0, 0.0})}};
  job.max_tilt_deg = 20.0;
  job.candidates = {{12.0, 34.0}};
  const auto report = jobs::reorient(job);
  ASSERT_TRUE(report) << report.error().message;
  const jobs::SetupReport& candidate = report->candidates.front();
  ASSERT_TRUE(candidate.possible);
  const Vec3 s = singular_direction(Vec3::UnitY(), 12.0 * rad_per_deg, 34.0 * rad_per_deg);
  ASSERT_FALSE(candidate.singular_directions.empty());
  for (const auto& each : candidate.singular_directions)
    EXPECT_LT(each.direction.cross(s).norm(), 1e-12);
}

TEST(SingularDirection, OfTwinsIsOneSetup) {
  jobs::ReorientJob job{.job = {.machine = sample::bundled_machine("hermle-c600u"),
                                .path = fan_past(Vec3::UnitZ(), 0.03, {1.0, 0.5, 0.0})}};
  job.candidates = {{-17.0, 25.0}, {17.0, 205.0}};
  const auto report = jobs::reorient(job);
  ASSERT_TRUE(report) << report.error().message;
  const auto &one = report->candidates[0], &other = report->candidates[1];
  EXPECT_NEAR(*one.peak_ratio, *other.peak_ratio, 1e-9);
  EXPECT_NEAR(one.rotary_travel_deg, other.rotary_travel_deg, 1e-6);
  ASSERT_TRUE(one.twin);
  EXPECT_DOUBLE_EQ(one.twin->theta_x_deg, 17.0);
  EXPECT_DOUBLE_EQ(one.twin->theta_z_deg, -155.0);
}

}  // namespace
}  // namespace pentapost
