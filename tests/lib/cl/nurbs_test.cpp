#include "pentapost/cl/nurbs.hpp"

#include "lib/cl/read_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace pentapost::cl {
namespace {

// A quarter of a circle of radius 10 as a rational curve of degree 2.
const std::string quarter_circle =
    "UNITS/MM\nFEDRAT/100\nGOTO/10,0,0\nNURBS/3\nKNOT/0,0,0,1,1,1\n"
    "CNTRL/10,0,0,1\nCNTRL/10,10,0,0.70710678118654752\nCNTRL/0,10,0,1\nGOTO/-5,10,0\n";

TEST(ReadNurbs, DividesACircleWithinItsChordError) {
  const auto result = read(quarter_circle);
  EXPECT_EQ(diagnostic_of(result, Code::nurbs_linearised).cl_line, 4U);
  const auto& tips = result.path.tip_wp_mm;
  ASSERT_GT(tips.size(), 10U);
  for (std::size_t i = 0; i + 2 < tips.size(); ++i) {
    EXPECT_NEAR(tips[i].norm(), 10.0, 1e-12);
    // Sagitta of the chord: the largest distance between it and the circle.
    EXPECT_LE(10.0 - (0.5 * (tips[i] + tips[i + 1])).norm(), 0.001);
  }
  EXPECT_NEAR((tips[tips.size() - 2] - Vec3{0, 10, 0}).norm(), 0.0, 1e-12);
  EXPECT_EQ(result.path.cl_line[1], 4U);
  EXPECT_EQ(result.points, 2U);
}

TEST(ReadNurbs, RunsAStraightCubicInTwoChordsASpan) {
  const auto result = read(
      "UNITS/MM\nGOTO/0,0,0\nNURBS/\nKNOT/0,0,0,0,1,1,1,1\nCNTRL/0,0,0\nCNTRL/1,0,0\nCNTRL/2,0,0\n"
      "CNTRL/3,0,0\n");
  EXPECT_EQ(result.path.size(), 3U);
  EXPECT_NEAR(result.path.tip_wp_mm.back().x(), 3.0, 1e-15);
}

// x(u) = 3 u (1-u)^2 9 ... a cubic Bezier whose middle meets its chord.
TEST(ReadNurbs, IsNotFooledByAnSShape) {
  const auto result = read(
      "UNITS/MM\nGOTO/0,0,0\nNURBS/\nKNOT/0,0,0,0,1,1,1,1\nCNTRL/0,0,0\nCNTRL/1,9,0\nCNTRL/2,-9,0\n"
      "CNTRL/3,0,0\n");
  double highest = 0.0;
  for (const auto& tip : result.path.tip_wp_mm) highest = std::max(highest, tip.y());
  // y = 27 u (1-u) (1-2u) is largest at u = (3 - sqrt 3) / 6: 27 sqrt(3) / 18.
  EXPECT_NEAR(highest, 27.0 * std::sqrt(3.0) / 18.0, 0.001);
}

TEST(ReadNurbs, TurnsTheToolAxisOfFiveAxisCurves) {
  const auto result = read(
      "UNITS/MM\nGOTO/0,0,0,0,0,1\nNURBS/\nKNOT/0,0,1,1\nCNTRL/0,0,0,0,0,1\nCNTRL/10,0,0,1,0,0\n");
  ASSERT_GT(result.path.size(), 2U);
  EXPECT_NEAR((result.path.axis_wp.back() - Vec3{1, 0, 0}).norm(), 0.0, 1e-12);
  for (const auto& axis : result.path.axis_wp) EXPECT_NEAR(axis.norm(), 1.0, 1e-12);
}

TEST(ReadNurbs, AddsTheWayToItsStart) {
  const auto result =
      read("UNITS/MM\nGOTO/0,0,5\nNURBS/\nKNOT/0,0,1,1\nCNTRL/1,0,0\nCNTRL/10,0,0\n");
  EXPECT_EQ(result.path.tip_wp_mm[1], Vec3(1, 0, 0));
}

TEST(ReadNurbs, RefusesBlocksThatGiveNoCurve) {
  const std::string two = "CNTRL/0,0,0\nCNTRL/1,0,0\n";
  for (const std::string block :
       {"NURBS/\n", "NURBS/\nKNOT/0,0,1,1\n", "NURBS/\nKNOT/0,1\nCNTRL/0,0,0\nCNTRL/1,0,0\n",
        "NURBS/\nKNOT/1,1,0,0\nCNTRL/0,0,0\nCNTRL/1,0,0\n",
        "NURBS/\nKNOT/0,0,0,0\nCNTRL/0,0,0\nCNTRL/1,0,0\n",
        "NURBS/\nKNOT/0,0,1,1\nCNTRL/0,0,0,1\nCNTRL/1,0,0,-1\n",
        "NURBS/\nKNOT/0,0,1,1\nCNTRL/0,0\nCNTRL/1,0\n",
        "NURBS/\nKNOT/0,0,1,X.\nCNTRL/0,0,0\nCNTRL/1,0,0\n",
        "NURBS/\nKNOT/0,0,1,1E999\nCNTRL/0,0,0\nCNTRL/1,0,0\n",
        "NURBS/\nKNOT/0,0,1,1\nCNTRL/0,0,0,0,0,1\nCNTRL/1,0,0,0,0,-1\n"}) {
    const auto result = read("UNITS/MM\nGOTO/0,0,0\n" + block + "GOTO/5,0,0\n");
    EXPECT_EQ(diagnostic_of(result, Code::bad_nurbs).severity, Severity::error) << block;
    EXPECT_EQ(diagnostic_of(result, Code::bad_nurbs).cl_line, 3U) << block;
  }
}

TEST(ReadNurbs, RefusesCurvesOfTooManyPoints) {
  const auto result = read(
      "UNITS/MM\nGOTO/0,0,0\nNURBS/\nKNOT/0,0,0,1,1,1\nCNTRL/0,0,0\n"
      "CNTRL/5E8,9E8,0\nCNTRL/9E8,0,0\n");
  EXPECT_TRUE(has(result, Code::bad_nurbs));
}

TEST(ReadNurbs, IgnoresCreosBecauseItsPointsFollow) {
  const auto result = read(
      "UNITS/MM\nMOVNRB/ON,4,8,0,4,10\nMOVNRB/1,0,0,1,1\nMOVNRB/NEXT\nGOTO/1,0,0\nMOVNRB/OFF\n");
  EXPECT_EQ(result.path.size(), 1U);
  EXPECT_FALSE(has(result, Code::unknown_statement));
}

}  // namespace
}  // namespace pentapost::cl
