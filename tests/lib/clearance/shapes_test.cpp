#include "pentapost/clearance/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace pentapost::clearance {
namespace {

constexpr double hair_mm = 1e-3;  ///< what the check is to tell apart

Cylinder upright(const Vec3& centre_mm, double half_length_mm, double radius_mm) {
  return {.centre_mm = centre_mm, .half_length_mm = half_length_mm, .radius_mm = radius_mm};
}

Cylinder leaning(double lean_deg, const Vec3& centre_mm, double half_length_mm, double radius_mm) {
  const double lean_rad = lean_deg * rad_per_deg;
  return {.centre_mm = centre_mm,
          .axis = {std::sin(lean_rad), 0.0, std::cos(lean_rad)},
          .half_length_mm = half_length_mm,
          .radius_mm = radius_mm};
}

/// Table of radius 200 mm with its face in z = 0.
const Cylinder table = upright({0, 0, -25}, 25, 200);

void expect_distance(const Cylinder& tool, const Obstacle& obstacle, double distance_mm) {
  EXPECT_FALSE(is_within(tool, obstacle, distance_mm - hair_mm));
  EXPECT_TRUE(is_within(tool, obstacle, distance_mm + hair_mm));
  EXPECT_LE(distance_bound_mm(tool, obstacle), distance_mm + 1e-9);
}

TEST(Shapes, AnUprightCylinderStandsAboveTheTableByTheHeightOfItsEnd) {
  expect_distance(upright({30, 40, 65}, 50, 20), table, 15.0);
}

// The lowest place of the lower rim is the axis's end less r sin(lean).
TEST(Shapes, TheRimOfALeaningCylinderDipsByItsRadiusTimesTheSine) {
  const double end_mm = 80.0 - 50.0 * std::cos(30.0 * rad_per_deg);
  expect_distance(leaning(30, {0, 0, 80}, 50, 20), table, end_mm - 20.0 * 0.5);
}

TEST(Shapes, ALyingCylinderStandsAboveTheTableByItsRadius) {
  expect_distance(leaning(90, {0, 0, 33}, 50, 20), table, 13.0);
}

TEST(Shapes, BesideTheTableTheRimsAreApartByTheGapBetweenTheirAxes) {
  expect_distance(upright({180, 180, -25}, 10, 30), table, std::hypot(180, 180) - 230.0);
}

// The edge of the table at (200, 0, 0) and the side of a cylinder that leans over it by 45 deg in
// the plane y = 0: the distance of the edge from the axis, less the radius.
TEST(Shapes, ALeaningCylinderPassesTheEdgeOfTheTableByItsDistanceFromTheAxis) {
  const Cylinder tool = leaning(-45, {230, 0, 30}, 200, 10);
  // The axis runs through (230, 30) towards (-1, 1): its distance from (200, 0) is 60 / sqrt(2).
  expect_distance(tool, table, 60.0 / std::sqrt(2.0) - 10.0);
}

TEST(Shapes, TwoRimsMeetAcrossTheirCorner) {
  // 30 mm aside and 40 mm above.
  expect_distance(upright({250, 0, 50}, 10, 20), table, 50.0);
}

TEST(Shapes, TheCornerOfABoxIsAsFarAsPythagorasSays) {
  const Box box{.centre_mm = {0, 0, 0}, .half_size_mm = {10, 20, 30}};
  // The corner (10, 20, 30) is 5 mm below the cylinder's end and hypot(30, 40) from its axis.
  expect_distance(upright({40, 60, 85}, 50, 38), box, 13.0);
}

TEST(Shapes, AFaceOfATurnedBoxIsAsFarAsAlongItsNormal) {
  Box box{.centre_mm = {0, 0, 0}, .half_size_mm = {10, 10, 30}};
  box.directions = Eigen::AngleAxisd{pi / 4, Vec3::UnitZ()}.toRotationMatrix();
  expect_distance(upright({100, 0, 0}, 20, 15), box, 100.0 - 15.0 - std::sqrt(200.0));
}

TEST(Shapes, AnOverlapHasNoDistance) {
  EXPECT_TRUE(is_within(upright({0, 0, 49}, 50, 20), table, 0.0));
  EXPECT_EQ(distance_within_mm(upright({0, 0, 49}, 50, 20), table, 2.0), 0.0);
}

TEST(Shapes, ABodyInsideAnotherOverlapsIt) {
  EXPECT_TRUE(is_within(upright({0, 0, -25}, 1, 1), table, 0.0));
}

TEST(Shapes, AxesInOneLineAreNoHindrance) {
  expect_distance(upright({0, 0, 12}, 10, 200), table, 2.0);
}

TEST(Shapes, TheDistanceWithinAMarginIsRightToAThousandth) {
  EXPECT_NEAR(distance_within_mm(upright({30, 40, 51.25}, 50, 20), table, 2.0), 1.25, hair_mm);
}

TEST(Shapes, AMillionMillimetresFromTheOriginAreAsExact) {
  const Vec3 far_mm{1e6, -1e6, 1e6};
  Cylinder tool = leaning(30, {0, 0, 80}, 50, 20), far_table = table;
  tool.centre_mm += far_mm;
  far_table.centre_mm += far_mm;
  expect_distance(tool, far_table, 80.0 - 50.0 * std::cos(30.0 * rad_per_deg) - 10.0);
}

// Truth of its own: projections onto the two bodies in turn come down to the distance from above,
// and the plane between their ends bounds it from below.

Vec3 nearest_in(const Cylinder& body, const Vec3& point_mm) {
  const Vec3 way = point_mm - body.centre_mm;
  const double along_mm = way.dot(body.axis);
  Vec3 across = way - along_mm * body.axis;
  if (across.norm() > body.radius_mm) across *= body.radius_mm / across.norm();
  return body.centre_mm +
         std::clamp(along_mm, -body.half_length_mm, body.half_length_mm) * body.axis + across;
}
Vec3 nearest_in(const Box& body, const Vec3& point_mm) {
  const Vec3 way = body.directions.transpose() * (point_mm - body.centre_mm);
  return body.centre_mm +
         body.directions * way.cwiseMax(-body.half_size_mm).cwiseMin(body.half_size_mm);
}

double half_extent_mm(const Cylinder& body, const Vec3& direction) {
  return body.half_length_mm * std::abs(body.axis.dot(direction)) +
         body.radius_mm * body.axis.cross(direction).norm();
}
double half_extent_mm(const Box& body, const Vec3& direction) {
  double extent_mm = 0.0;
  for (Eigen::Index i = 0; i < 3; ++i)
    extent_mm += body.half_size_mm[i] * std::abs(body.directions.col(i).dot(direction));
  return extent_mm;
}

/// Ends of the range that the distance is known to lie in.
template <class Body>
Range<double> distance_by_projections_mm(const Cylinder& tool, const Body& body) {
  Range<double> distance_mm{0.0, 1e300};
  Vec3 on_tool = tool.centre_mm;
  for (int i = 0; i < 20'000 && distance_mm.upper - distance_mm.lower > 1e-6; ++i) {
    const Vec3 on_body = nearest_in(body, on_tool);
    on_tool = nearest_in(tool, on_body);
    const Vec3 way = on_body - on_tool;
    const double length = way.norm();
    distance_mm.upper = std::min(distance_mm.upper, length);
    if (length < 1e-9) break;
    const Vec3 normal = way / length;
    distance_mm.lower = std::max(distance_mm.lower, (body.centre_mm - tool.centre_mm).dot(normal) -
                                                        half_extent_mm(body, normal) -
                                                        half_extent_mm(tool, normal));
  }
  return distance_mm;
}

struct Random {
  std::mt19937_64 engine{42};
  double between(double lower, double upper) {
    return std::uniform_real_distribution{lower, upper}(engine);
  }
  Vec3 within(double reach_mm) {
    return {between(-reach_mm, reach_mm), between(-reach_mm, reach_mm),
            between(-reach_mm, reach_mm)};
  }
  Vec3 direction() {
    Vec3 direction = within(1.0);
    while (direction.norm() < 0.1) direction = within(1.0);
    return direction.normalized();
  }
  Cylinder cylinder(double reach_mm) {
    return {.centre_mm = within(reach_mm),
            .axis = direction(),
            .half_length_mm = between(2, 100),
            .radius_mm = between(2, 100)};
  }
  Box box() {
    return {.centre_mm = within(50),
            .directions = Eigen::AngleAxisd{between(0, 3), direction()}.toRotationMatrix(),
            .half_size_mm = {between(2, 100), between(2, 100), between(2, 100)}};
  }
};

template <class Body>
void expect_agreement(const Cylinder& tool, const Body& body) {
  const auto [lower_mm, upper_mm] = distance_by_projections_mm(tool, body);
  ASSERT_LE(distance_bound_mm(tool, body), upper_mm + 1e-9);
  ASSERT_TRUE(is_within(tool, body, upper_mm + hair_mm));
  if (lower_mm > hair_mm) {
    ASSERT_FALSE(is_within(tool, body, lower_mm - hair_mm));
  }
  ASSERT_LT(upper_mm - lower_mm, 0.5) << "the truth itself is not known well enough";
}

TEST(Shapes, AgreeWithProjectionsOnRandomBodies) {
  Random random;
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE(i);
    const Cylinder tool = random.cylinder(300);
    ASSERT_NO_FATAL_FAILURE(expect_agreement(tool, random.cylinder(50)));
    ASSERT_NO_FATAL_FAILURE(expect_agreement(tool, random.box()));
  }
}

// Where all is parallel or at right angles the algorithm of the distance has its hard cases.
TEST(Shapes, TellTouchingFromNotTouchingOnAGridOfSymmetricPlaces) {
  int apart = 0, near = 0;
  const Box box{.centre_mm = {0, 0, 0}, .half_size_mm = {20, 20, 20}};
  for (int x = -6; x <= 6; ++x)
    for (int y = -6; y <= 6; ++y)
      for (int z = -6; z <= 6; ++z)
        for (const double radius_mm : {5.0, 10.0, 20.0}) {
          const Cylinder tool = upright({x * 10.0, y * 10.0, z * 10.0}, 10, radius_mm);
          const double aside_mm = std::hypot(std::max(std::abs(x) * 10.0 - 20.0, 0.0),
                                             std::max(std::abs(y) * 10.0 - 20.0, 0.0));
          const double distance_mm = std::hypot(std::max(aside_mm - radius_mm, 0.0),
                                                std::max(std::abs(z) * 10.0 - 30.0, 0.0));
          ASSERT_TRUE(is_within(tool, box, distance_mm + hair_mm)) << x << y << z << radius_mm;
          ++near;
          if (distance_mm == 0.0) continue;
          ASSERT_FALSE(is_within(tool, box, distance_mm - hair_mm)) << x << y << z << radius_mm;
          ASSERT_FALSE(is_within(tool, box, 0.0)) << x << y << z << radius_mm;
          ++apart;
        }
  EXPECT_EQ(near, 6591);
  EXPECT_GT(apart, 5000);
}

}  // namespace
}  // namespace pentapost::clearance
