#include "pentapost/cl/arcs.hpp"

#include "lib/cl/read_text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace pentapost::cl {
namespace {

/// A quarter from (10,0) to (0,10) about the origin, right-handed about +z: 90 deg.
const std::string quarter = "UNITS/MM\nFEDRAT/100,MMPM\nGOTO/10,-5,0\nGOTO/10,0,0\n";

path::Arc only_arc(const ReadResult& result) {
  const auto arcs = events_of<path::Arc>(result.path);
  EXPECT_EQ(arcs.size(), 1U);
  return arcs.empty() ? path::Arc{} : arcs[0];
}

double sweep_deg(const ReadResult& result) { return only_arc(result).sweep_rad * deg_per_rad; }

TEST(ReadArc, IsRightHandedInCreoAndSolidWorksCam) {
  for (const char* dialect : {"creo-ncl", "solidworks-cam-apt"}) {
    const auto up = read_as(dialect, quarter + "CIRCLE / 0,0,0, 0,0,1, 10\nGOTO/0,10,0\n");
    EXPECT_NEAR(sweep_deg(up), 90.0, 1e-9) << dialect;
    EXPECT_EQ(only_arc(up).normal_wp, Vec3(0, 0, 1));
    const auto down = read_as(dialect, quarter + "CIRCLE / 0,0,0, 0,0,-1, 10\nGOTO/0,10,0\n");
    EXPECT_NEAR(sweep_deg(down), 270.0, 1e-9) << dialect;
  }
}

TEST(ReadArc, IsLeftHandedInNxAndMakino) {
  for (const char* dialect : {"nx-clsf", "makino-aptcl"}) {
    const auto result =
        read_as(dialect, quarter + "CIRCLE/0,0,0,0,0,-1,10,0.06,0.5,30,0\nGOTO/0,10,0\n");
    EXPECT_NEAR(sweep_deg(result), 90.0, 1e-9) << dialect;
    EXPECT_EQ(only_arc(result).normal_wp, Vec3(0, 0, 1)) << dialect;
  }
}

TEST(ReadArc, FollowsTheWordInClt) {
  const auto left = read(quarter + "CIRCLE/0,0,0,0,0,1,10,CLOCKWISE\nGOTO/0,10,0\n");
  EXPECT_EQ(left.dialect, "solidworks-cam-clt");
  EXPECT_NEAR(sweep_deg(left), 270.0, 1e-9);
  EXPECT_NEAR(sweep_deg(read(quarter + "CIRCLE/0,0,0,0,0,1,10,COUNTERCLOCKWISE\nGOTO/0,10,0\n")),
              90.0, 1e-9);
}

TEST(ReadArc, TakesTheTangentSenseWithAWarningWhereThereIsNoRule) {
  for (const char* vector : {"0,0,1", "0,0,-1"}) {
    const auto result =
        read(quarter + "CIRCLE/0,0,0," + vector + ",10\nGOTO/0,10,0\nGOTO/-5,10,0\n");
    EXPECT_NEAR(sweep_deg(result), 90.0, 1e-9) << vector;
    EXPECT_EQ(diagnostic_of(result, Code::arc_sense_assumed).cl_line, 5U);
  }
}

TEST(ReadArc, TakesTheTangentSenseOfALongArc) {
  const auto result =
      read("GOTO/10,5,0\nGOTO/10,0,0\nCIRCLE/0,0,0,0,0,1,10\nGOTO/0,10,0\nGOTO/5,10,0\n");
  EXPECT_NEAR(sweep_deg(result), 270.0, 1e-9);
}

TEST(ReadArc, TakesTheShorterWayWhereNeighboursDoNotTell) {
  EXPECT_NEAR(sweep_deg(read("GOTO/10,0,0\nCIRCLE/0,0,0,0,0,-1,10\nGOTO/0,10,0\n")), 90.0, 1e-9);
}

TEST(ReadArc, ReadsCatiasTangentForm) {
  const auto result =
      read_as("catia-apt",
              "UNITS/MM\nGOTO/10,0,3\nINDIRV/0,1,0\n"
              "TLON,GOFWD/ (CIRCLE/ 0.0, 0.0, 3.0,$\n 10.0),ON,(LINE/ 0,0,3,$\n 0,10,3)\n"
              "GOTO/-5,10,3\n");
  ASSERT_EQ(result.path.size(), 3U);
  EXPECT_EQ(result.path.tip_wp_mm[1], Vec3(0, 10, 3));
  EXPECT_EQ(result.path.cl_line[1], 4U);
  EXPECT_NEAR(sweep_deg(result), 90.0, 1e-9);
  EXPECT_EQ(result.points, 2U);
}

TEST(ReadArc, RunsCatiasArcTheOtherWayForTheOtherTangent) {
  const auto result = read_as("catia-apt",
                              "UNITS/MM\nGOTO/10,0,0\nINDIRV/0,-1,0\n"
                              "TLON,GOFWD/(CIRCLE/0,0,0,10),ON,2,INTOF,(LINE/0,0,0,0,10,0)\n");
  EXPECT_NEAR(sweep_deg(result), 270.0, 1e-9);
}

TEST(ReadArc, ReadsCatiasCylinderForm) {
  const auto result = read_as(
      "catia-apt",
      "UNITS/MM\nGOTO/10,0,0\nPSIS/(PLANE/(POINT/10,0,0),PERPTO,(VECTOR/0,0,1))\nINDIRV/0,0,1\n"
      "TLON,GOFWD/(CYLNDR/0,0,0,0,1,0,10),ON,(PLANE/PERPTO,(PLANE/(POINT/0,0,0),PERPTO,"
      "(VECTOR/0,1,0)),(POINT/0,0,0),(POINT/0,0,10))\n");
  EXPECT_EQ(result.path.tip_wp_mm.back(), Vec3(0, 0, 10));
  EXPECT_NEAR(sweep_deg(result), 90.0, 1e-9);
}

TEST(ReadArc, ReadsFusionsMovarc) {
  const auto result =
      read_as("fusion-apt", quarter + "MOVARC/0,0,0,0,0,1,10,ANGLE,90.\nGOTO/0,10,0\n");
  EXPECT_NEAR(sweep_deg(result), 90.0, 1e-9);
  EXPECT_FALSE(has(result, Code::bad_arc));
}

TEST(ReadArc, TakesWholeTurnsFromTheAngle) {
  const auto result =
      read_as("fusion-apt", quarter + "MOVARC/0,0,0,0,0,1,10,ANGLE,450.\nGOTO/0,10,-2\n");
  EXPECT_NEAR(sweep_deg(result), 450.0, 1e-9);
}

// Older writers leave the vector of clockwise arcs as it is: the angle tells.
TEST(ReadArc, LetsTheAngleDecideTheSense) {
  const auto result =
      read_as("fusion-apt", quarter + "MOVARC/0,0,0,0,0,-1,10,ANGLE,90\nGOTO/0,10,0\n");
  EXPECT_NEAR(sweep_deg(result), 90.0, 1e-9);
  EXPECT_EQ(only_arc(result).normal_wp, Vec3(0, 0, 1));
}

TEST(ReadArc, IsAWholeCircleWhereTheEndIsTheStart) {
  EXPECT_NEAR(sweep_deg(read_as("nx-clsf", quarter + "CIRCLE/0,0,0,0,0,1,10\nGOTO/10,0,0\n")),
              360.0, 1e-9);
  EXPECT_NEAR(sweep_deg(read_as("creo-ncl", quarter + "CIRCLE/0,0,0,0,0,1,10\nGOTO/10,0,-1\n")),
              360.0, 1e-9);
}

TEST(ReadArc, CountsTimesAsTheMostTurns) {
  const auto result =
      read_as("nx-clsf", quarter + "CIRCLE/0,0,0,0,0,-1,10,.06,.5,30,0,TIMES,3\nGOTO/0,10,-6\n");
  EXPECT_NEAR(sweep_deg(result), 2 * 360.0 + 90.0, 1e-9);
}

TEST(ReadArc, RefusesAbsurdTimes) {
  for (const char* times : {"1E9", "0", "-1", "1.5"}) {
    const auto result = read_as("nx-clsf", quarter + "CIRCLE/0,0,0,0,0,-1,10,.06,.5,30,0,TIMES," +
                                               times + "\nGOTO/0,10,-6\n");
    EXPECT_EQ(diagnostic_of(result, Code::damaged_motion).severity, Severity::error) << times;
  }
}

// The end lies one digit behind the start: nearly a whole turn by the rule, nothing in truth.
TEST(ReadArc, IsStraightWhereItIsShorterThanTheDigits) {
  const auto result =
      read_as("nx-clsf",
              "UNITS/MM\nGOTO/10.0000,-5.0000,0.0000\nGOTO/10.0000,0.0000,0.0000\n"
              "CIRCLE/0.0000,0.0000,0.0000,0,0,-1,10.0000\nGOTO/10.0000,-0.0001,0.0000\n");
  EXPECT_TRUE(events_of<path::Arc>(result.path).empty());
  EXPECT_EQ(result.path.size(), 3U);
  EXPECT_FALSE(result.diagnostics.has_errors());
}

TEST(ReadArc, KeepsAHelixAboutAnyVector) {
  const auto result =
      read_as("creo-ncl", "UNITS/MM\nGOTO/0,10,0\nCIRCLE/0,0,0,1,0,0,10\nGOTO/5,0,10\n");
  EXPECT_NEAR(sweep_deg(result), 90.0, 1e-9);
  EXPECT_EQ(only_arc(result).normal_wp, Vec3(1, 0, 0));
}

TEST(ReadArc, WarnsOfRadiiThatDisagreeALittleAndRefusesMore) {
  const auto little = read_as("creo-ncl", quarter + "CIRCLE/0,0,0,0,0,1,10.2\nGOTO/0,10,0\n");
  EXPECT_EQ(diagnostic_of(little, Code::bad_arc).severity, Severity::warning);
  EXPECT_EQ(events_of<path::Arc>(little.path).size(), 1U);
  const auto much = read_as("creo-ncl", quarter + "CIRCLE/0,0,0,0,0,1,10\nGOTO/0,15,0\n");
  EXPECT_EQ(diagnostic_of(much, Code::bad_arc).severity, Severity::error);
}

TEST(ReadArc, NeedsAStartAndAnEnd) {
  EXPECT_TRUE(has(read_as("creo-ncl", "CIRCLE/0,0,0,0,0,1,10\nGOTO/0,10,0\n"), Code::bad_arc));
  EXPECT_TRUE(has(read_as("creo-ncl", quarter + "CIRCLE/0,0,0,0,0,1,10\nFINI\n"), Code::bad_arc));
}

TEST(ReadArc, RunsAtFeedEvenBehindRapid) {
  const auto result = read_as("creo-ncl", quarter + "RAPID\nCIRCLE/0,0,0,0,0,1,10\nGOTO/0,10,0\n");
  EXPECT_EQ(result.path.move.back(), path::Move::feed);
  EXPECT_TRUE(has(result, Code::bad_arc));
}

TEST(ReadArc, ConvertsInches) {
  const auto result = read_as("nx-clsf",
                              "TOOL PATH/A,TOOL,B\nFEDRAT/IPM,10\nGOTO/1,0,0\n"
                              "CIRCLE/0,0,0,0,0,-1,1\nGOTO/0,1,0\n");
  EXPECT_NEAR(sweep_deg(result), 90.0, 1e-9);
  EXPECT_DOUBLE_EQ(result.path.tip_wp_mm[0].x(), 25.4);
}

TEST(Reversed, LeavesTheEndsWhereTheyAre) {
  const path::Arc arc{Vec3::Zero(), Vec3::UnitZ(), pi / 2};
  EXPECT_NEAR(reversed(arc).sweep_rad, 1.5 * pi, 1e-15);
  EXPECT_EQ(reversed(arc).normal_wp, Vec3(0, 0, -1));
  EXPECT_NEAR(reversed({Vec3::Zero(), Vec3::UnitZ(), 2.0 * pi}).sweep_rad, 2.0 * pi, 1e-15);
  EXPECT_NEAR(reversed({Vec3::Zero(), Vec3::UnitZ(), 2.5 * pi}).sweep_rad, 3.5 * pi, 1e-14);
}

}  // namespace
}  // namespace pentapost::cl
