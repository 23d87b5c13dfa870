#include "pentapost/verify/proof.hpp"

#include "sample_program.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pentapost::verify {
namespace {

using path::Move;
using ::testing::Test;

/// Tool axis of hermle-c600u: Rz(-C) Rx(-A) z (Cripps et al. 2017 eq. (1)).
Vec3 hermle_axis(double c_deg, double a_deg) {
  const double c = c_deg * rad_per_deg, a = a_deg * rad_per_deg;
  return {std::sin(a) * std::sin(c), std::sin(a) * std::cos(c), std::cos(a)};
}

#define EXPECT_FAILURE(program, part) \
  EXPECT_NE((program).failure().find(part), std::string::npos) << (program).failure()

/// Three cuts with TCP, a rapid to their start, tool 2, spindle clockwise, feed 500.
sample::Program right_program() {
  sample::Program program{sample::trunnion_ac(), "XYZAC"};
  program.cl.add_event(1, path::ToolChange{.number = 2});
  program.cl.add_event(2, path::Spindle{path::Spindle::State::clockwise, 3000.0});
  program.point({0, 0, 50}, hermle_axis(10, 20), Move::rapid);
  program.cl.add_event(15, path::FeedRate{500.0});
  program.point({0, 0, 0}, hermle_axis(10, 20));
  program.point({10, 0, 0}, hermle_axis(11, 21));
  program.point({20, 5, 1}, hermle_axis(12, 23));
  program.line("T2");
  program.line("S3000");
  program.off("G0 A20 C10", 0);
  program.line("TCP1");
  program.block("G0 X0 Y0 Z50 A20 C10", 0);
  program.block("G1 X0 Y0 Z0 A20 C10 F500", 1);
  program.block("G1 X5 Y0 Z0 A20.5 C10.5", 2, 0.5);
  program.block("G1 X10 Y0 Z0 A21 C11", 2);
  program.block("G1 X20 Y5 Z1 A23 C12", 3);
  program.line("TCP0");
  program.line("RETRACT");
  program.line("S0");
  program.line("END");
  return program;
}

TEST(Proof, PassesARightProgram) {
  sample::Program program = right_program();

  const auto proof = program.prove();

  ASSERT_TRUE(proof) << proof.error().message;
  EXPECT_EQ(proof->blocks_read, 6U);
  EXPECT_LT(proof->tip_deviation_mm, 1e-5);
  EXPECT_LT(proof->axis_deviation_rad, 0.01 * rad_per_deg);
  EXPECT_GT(proof->axis_deviation_rad, 0.0);
}

TEST(Proof, GivesTheSpansAsPrinted) {
  sample::Program program = right_program();

  const auto proof = program.prove();

  ASSERT_TRUE(proof) << proof.error().message;
  EXPECT_EQ(proof->spans[0].min, 0.0);
  EXPECT_EQ(proof->spans[0].max, 20.0);
  EXPECT_EQ(proof->spans[2].max, 50.0);
  EXPECT_EQ(proof->spans[3].min, 20.0);
  EXPECT_EQ(proof->spans[3].max, 23.0);
  EXPECT_EQ(proof->spans[4].min, 10.0);
  EXPECT_EQ(proof->spans[4].max, 12.0);
}

TEST(Proof, NamesThePlaceOfAFailure) {
  sample::Program program = right_program();
  program.change("X10 Y0", "X10 Y0.02");

  const auto proof = program.prove();

  ASSERT_FALSE(proof);
  EXPECT_EQ(proof.error().code, Code::proof_failed);
  EXPECT_EQ(proof.error().cl_line, 30U);
  EXPECT_EQ(proof.error().message,
            "NC text line 8, motion block 5 (CL line 30): the tool tip leaves the CL path by 0.02 "
            "mm, the tolerance is 0.01 mm");
}

TEST(Proof, FailsWhereOneDigitOfAnyWordIsWrong) {
  for (const auto& [found, wrong] : {std::pair{"X5 ", "X6 "},
                                     {"X10 ", "X10.1 "},
                                     {"Z1 ", "Z2 "},
                                     {"A20.5", "A20.9"},
                                     {"C11", "C12"},
                                     {"A23", "A22"},
                                     {"Y5 ", "Y-5 "}}) {
    sample::Program program = right_program();
    program.change(found, wrong);
    EXPECT_FALSE(program.prove()) << found;
  }
}

TEST(Proof, FailsWhereABlockIsMissing) {
  for (std::size_t line : {4U, 5U, 6U, 7U, 8U}) {
    sample::Program program = right_program();
    program.lines.erase(program.lines.begin() + static_cast<std::ptrdiff_t>(line));
    EXPECT_FALSE(program.prove()) << line;
  }
}

TEST(Proof, FailsWhereABlockIsMissingInTheWitnessToo) {
  for (std::size_t block : {1U, 2U, 4U, 5U}) {
    sample::Program program = right_program();
    const auto offset = static_cast<std::ptrdiff_t>(block);
    program.motion.blocks.erase(program.motion.blocks.begin() + offset);
    program.lines.erase(program.lines.begin() + (block == 0 ? 2 : 3 + offset));
    EXPECT_FALSE(program.prove()) << block;
  }
}

TEST(Proof, FailsWhereTwoBlocksAreExchanged) {
  sample::Program program = right_program();
  std::swap(program.lines[6], program.lines[7]);
  EXPECT_FALSE(program.prove());
}

TEST(Proof, FailsWhereABlockIsAdded) {
  sample::Program program = right_program();
  program.lines.insert(program.lines.end() - 4, "G1 X20 Y5 Z1");
  EXPECT_FAILURE(program, "a motion block more than the 6");
}

TEST(Proof, FailsWithAnotherTool) {
  sample::Program program = right_program();
  program.change("T2", "T3");
  EXPECT_FAILURE(program, "the tool is 3, expected is tool 2");
}

TEST(Proof, FailsWithTheSpindleTheOtherWayOrStandingOrSlow) {
  for (const char* wrong : {"S-3000", "S0", "S300"}) {
    sample::Program program = right_program();
    program.change("S3000", wrong);
    EXPECT_FAILURE(program, "the spindle");
  }
}

TEST(Proof, FailsWithoutTcp) {
  sample::Program program = right_program();
  program.change("TCP1", "TCP0");
  EXPECT_FAILURE(program, "neither TCP is on");
}

TEST(Proof, FailsWhereTheProgramDoesNotEnd) {
  sample::Program program = right_program();
  program.lines.pop_back();
  EXPECT_FAILURE(program, "does not end");
}

// The pose at the end is right, but the block sweeps a whole turn on its way.
TEST(Proof, FailsWhereCTurnsOnceMoreWithinACut) {
  sample::Program program = right_program();
  program.change("A23 C12", "A23 C372");
  EXPECT_FAILURE(program, "the tool axis leaves the CL axis");
}

TEST(Proof, FailsWhereACutIsARapidMove) {
  sample::Program program = right_program();
  program.change("G1 X20", "G0 X20");
  EXPECT_FAILURE(program, "a rapid move where the CL data cuts");
}

TEST(Proof, FailsAboveTheProgrammedFeedAndWithoutOne) {
  sample::Program faster = right_program();
  faster.change("F500", "F500.001");
  EXPECT_FAILURE(faster, "the feed is 500.001 mm/min, programmed are 500 mm/min");
  sample::Program without = right_program();
  without.change(" F500", "");
  EXPECT_FAILURE(without, "without a feed");
}

TEST(Proof, PassesALowerFeed) {
  sample::Program program = right_program();
  program.change("F500", "F20");
  EXPECT_EQ(program.failure(), "");
}

TEST(Proof, HoldsInverseTimeAgainstTheLengthOfThePart) {
  sample::Program program = right_program();
  program.change("G1 X5 Y0 Z0 A20.5 C10.5", "G93 X5 Y0 Z0 A20.5 C10.5 F100");  // 5 mm at 500 mm/min
  program.change("G1 X10 Y0 Z0 A21 C11", "G1 X10 Y0 Z0 A21 C11 F500");
  EXPECT_EQ(program.failure(), "");
  program.change("F100", "F100.01");
  EXPECT_FAILURE(program, "the feed is 500.05 mm/min");
}

TEST(Proof, FailsWhereTheWorkOffsetIsShiftedOnTheWay) {
  sample::Program program = right_program();
  program.change("Y5 Z1", "Y5 Z1 D0.5");
  EXPECT_FAILURE(program, "datum shift");
}

// The words are right, but the witness leaves a move out, or puts it elsewhere.
TEST(Proof, FailsWhereTheWitnessLies) {
  for (int lie = 0; lie < 7; ++lie) {
    sample::Program program = right_program();
    auto& blocks = program.motion.blocks;
    if (lie == 0) blocks[3].fraction = 0.6;
    if (lie == 1) blocks[4].fraction = 0.5;
    if (lie == 2) blocks[5].on_path = false;
    if (lie == 3) blocks[2].point = 0;
    if (lie == 4) blocks[5].point = 4;
    if (lie == 5) blocks[4].fraction = std::numeric_limits<double>::quiet_NaN();
    if (lie == 6) blocks[1].on_path = blocks[2].on_path = false;
    EXPECT_NE(program.failure(), "") << lie;
  }
}

TEST(Proof, FailsOnNumbersThatAreNotFinite) {
  for (const char* wrong : {"Xnan ", "Xinf ", "X1e300 "}) {
    sample::Program program = right_program();
    program.change("X20 ", wrong);
    EXPECT_NE(program.failure(), "") << wrong;
  }
  sample::Program program = right_program();
  program.cl.tip_wp_mm[3].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(program.failure(), "");
}

TEST(Proof, AcceptsADeviationEqualToTheTolerance) {
  sample::Program program = right_program();
  program.change("X20 Y5 Z1", "X20 Y5 Z1.01");
  EXPECT_EQ(program.failure(), "");
  program.change("Z1.01", "Z1.01001");
  EXPECT_NE(program.failure(), "");
}

TEST(Proof, ProvesOnlyTheEndOfARapidMove) {
  sample::Program program = right_program();
  program.point({0, 0, 80}, hermle_axis(12, 23), Move::rapid);
  program.lines.insert(program.lines.end() - 4, "G0 X0 Y0 Z80");
  program.motion.blocks.push_back({.point = 4, .kind = path::Block::Kind::rapid});
  EXPECT_EQ(program.failure(), "");
  program.change("Z80", "Z80.02");
  EXPECT_FAILURE(program, "leaves the CL path by 0.02");
}

TEST(Proof, MayEnterThePathByACutFromItsFirstPoint) {
  sample::Program program = right_program();
  program.motion.blocks[1].on_path = false;
  EXPECT_EQ(program.failure(), "");
  program.change("Z50", "Z51");
  EXPECT_NE(program.failure(), "");
}

// Off the path

/// Cut, retract along the tilted axis, other turn of C, plunge, cut.
sample::Program with_retract() {
  sample::Program program{sample::trunnion_ac(), "XYZAC"};
  program.cl.add_event(1, path::FeedRate{500.0});
  program.point({0, 0, 0}, hermle_axis(0, 30), Move::rapid);
  program.point({10, 0, 0}, hermle_axis(0, 30));
  program.point({20, 0, 0}, hermle_axis(0, 30));
  program.line("TCP1");
  program.block("G0 X0 Y0 Z0 A30 C0", 0);
  program.block("G1 X10 F500", 1);
  program.off("G1 X10 Y50 Z86.603", 1);  // 100 mm along (0, sin 30, cos 30)
  program.off("G0 A-30 C180", 1);
  program.off("G1 X10 Y0 Z0", 1);
  program.block("G1 X20 A-30 C180", 2);
  program.line("END");
  return program;
}

sample::Program with_length_register() {
  sample::Program program = with_retract();
  program.cl.events.insert(program.cl.events.begin(),
                           {.before_point = 0,
                            .cl_line = 1,
                            .what = path::ToolChange{.number = 5, .length_register = 15}});
  program.lines.insert(program.lines.begin(), {"T5", "H15"});
  return program;
}

TEST(ProofOfTheLengthRegister, PassesTheOneOfTheTool) {
  EXPECT_EQ(with_length_register().failure(), "");
}

TEST(ProofOfTheLengthRegister, FailsOnThatOfAnotherToolInARapidToo) {
  sample::Program program = with_length_register();
  program.change("H15", "H5");
  EXPECT_FAILURE(program, "block 1 (CL line 10): the length register is 5, expected is 15");
}

TEST(ProofOfTheLengthRegister, FailsWhereItChangesOffThePath) {
  sample::Program program = with_length_register();
  program.change("G0 A-30 C180", "H5\nG0 A-30 C180");
  program.change("G1 X10 Y0 Z0", "H15\nG1 X10 Y0 Z0");
  EXPECT_FAILURE(program, "the length register changes from 15 to 5");
}

TEST(ProofOffThePath, PassesARetractAndItsPlunge) { EXPECT_EQ(with_retract().failure(), ""); }

TEST(ProofOffThePath, FailsWhereTheCutGoesOnElsewhere) {
  sample::Program program = with_retract();
  program.change("G1 X10 Y0 Z0", "G1 X10.001 Y0 Z0");
  EXPECT_FAILURE(program, "mm from the place where it was left");
}

TEST(ProofOffThePath, FailsWhereTheRetractGoesSideways) {
  sample::Program program = with_retract();
  program.change("X10 Y50 Z86.603", "X60 Y50 Z86.603");
  EXPECT_FAILURE(program, "leaves the tool axis by");
}

TEST(ProofOffThePath, FailsWhereTheRetractGoesIntoTheMaterial) {
  sample::Program program = with_retract();
  program.change("Y50 Z86.603", "Y-50 Z-86.603");
  EXPECT_FAILURE(program, "retracts into the material");
}

TEST(ProofOffThePath, FailsWhereRotaryAxesTurnInTheCut) {
  sample::Program program = with_retract();
  program.change("G1 X10 Y50 Z86.603", "G1 X10 Y0 Z0");
  EXPECT_FAILURE(program, "turns rotary axes where the tool is in the cut");
}

TEST(ProofOffThePath, FailsWhereARapidRetractGoesSidewaysBeforeACut) {
  sample::Program program = with_retract();
  program.change("G1 X10 Y50 Z86.603", "G0 X60 Y50 Z86.603");
  EXPECT_NE(program.failure(), "");
}

TEST(ProofOffThePath, FailsWhereTheWayGoesBelowTheCut) {
  sample::Program program = with_retract();
  program.change("G0 A-30 C180", "G0 A-30 C180 X10 Y-50 Z-86.603");
  EXPECT_NE(program.failure(), "");
}

TEST(ProofOffThePath, LetsCTurnInTheCutAtThePole) {
  sample::Program program{sample::trunnion_ac(), "XYZAC"};
  program.cl.add_event(1, path::FeedRate{500.0});
  program.point({0, 0, 0}, Vec3::UnitZ(), Move::rapid);
  program.point({10, 0, 0}, Vec3::UnitZ());
  program.point({20, 0, 0}, Vec3::UnitZ());
  program.line("TCP1");
  program.block("G0 X0 Y0 Z0 A0 C0", 0);
  program.block("G1 X10 F500", 1);
  program.off("G1 C180", 1);
  program.block("G1 X20", 2);
  program.line("END");
  EXPECT_EQ(program.failure(), "");
}

TEST(ProofOffThePath, FailsWhereTheCutGoesOnAfterASafeRetractFromAnUnknownPlace) {
  sample::Program program = right_program();
  program.lines.insert(program.lines.begin() + 8, "RETRACT");
  program.change("G1 X20 Y5 Z1", "G1 X20 Y5");
  EXPECT_NE(program.failure(), "");
}

TEST(ProofOffThePath, FailsWhereAMachineMoveComesBetweenTwoCuts) {
  sample::Program program = right_program();
  program.lines.insert(program.lines.begin() + 8, "G0 Z0 M1");
  EXPECT_NE(program.failure(), "");
}

// Arcs and holes

/// A three quarter circle, counterclockwise from (10, 0) to (0, -10), then a full circle.
sample::Program with_arcs() {
  sample::Program program{sample::trunnion_ac(), "XYZAC"};
  program.cl.add_event(1, path::FeedRate{500.0});
  program.point({10, 0, 5}, Vec3::UnitZ(), Move::rapid);
  program.cl.add_event(2, path::Arc{.centre_wp_mm = {0, 0, 5}, .sweep_rad = 1.5 * pi});
  program.point({0, -10, 5}, Vec3::UnitZ());
  program.cl.add_event(
      3, path::Arc{.centre_wp_mm = {0, -5, 5}, .normal_wp = -Vec3::UnitZ(), .sweep_rad = 2 * pi});
  program.point({0, -10, 5}, Vec3::UnitZ());
  program.line("TCP1");
  program.block("G0 X10 Y0 Z5 A0 C0", 0);
  program.block("G3 X0 Y-10 I0 J0 F500", 1);
  program.block("G2 X0 Y-10 I0 J-5 N1", 2);
  program.line("END");
  return program;
}

TEST(ProofOfArcs, PassesRightArcs) {
  const auto proof = with_arcs().prove();
  ASSERT_TRUE(proof) << proof.error().message;
  EXPECT_LT(proof->tip_deviation_mm, 2e-5);
}

TEST(ProofOfArcs, FailsInTheWrongSense) {
  sample::Program program = with_arcs();
  program.change("G3", "G2");
  EXPECT_FAILURE(program, "wrong sense");
  sample::Program circle = with_arcs();
  circle.change("G2", "G3");
  EXPECT_FAILURE(circle, "wrong sense");
}

TEST(ProofOfArcs, FailsWithAnotherCentreOrNumberOfTurns) {
  sample::Program centre = with_arcs();
  centre.change("I0 J0", "I0.1 J-0.1");
  EXPECT_FAILURE(centre, "the tool tip leaves the CL path");
  sample::Program turns = with_arcs();
  turns.change("J-5 N1", "J-5 N2");
  EXPECT_FAILURE(turns, "the arc turns by 720 deg, expected are 360 deg");
}

TEST(ProofOfArcs, FailsWhereCMovesWithinTheArc) {
  sample::Program program = with_arcs();
  program.change("G3 X0 Y-10", "G3 X0 Y-10 C5");
  EXPECT_FAILURE(program, "a rotary axis moves within an arc");
}

TEST(ProofOfArcs, FailsWhereALineReplacesTheArc) {
  sample::Program program = with_arcs();
  program.change("G3 X0 Y-10 I0 J0", "G1 X0 Y-10");
  EXPECT_FAILURE(program, "the tool tip leaves the CL path");
}

/// Two deep holes of a native cycle, TCP off at A0 C0.
sample::Program with_holes() {
  sample::Program program{sample::trunnion_ac(), "XYZAC"};
  program.cl.add_event(1, path::FeedRate{200.0});
  program.point({0, 0, 50}, Vec3::UnitZ(), Move::rapid);
  program.cl.add_event(2, path::CycleStart{.kind = path::CycleStart::Kind::deep,
                                           .depth_mm = 20,
                                           .clearance_mm = 2,
                                           .retract_mm = 10.0,
                                           .peck_mm = 5.0,
                                           .dwell_s = 0.5});
  program.point({10, 0, 0}, Vec3::UnitZ(), Move::hole);
  program.point({20, 0, 0}, Vec3::UnitZ(), Move::hole);
  program.cl.add_event(4, path::CycleEnd{});
  program.point({30, 0, 10}, Vec3::UnitZ());
  program.line("LEN1");
  program.block("G0 X0 Y0 Z50 A0 C0", 0);
  program.block("DRILL X10 Y0 Z-20 R2 W10 Q5 P0.5 K1 F200", 1);
  program.block("DRILL X20 Y0 Z-20 R2 W10 Q5 P0.5 K1", 2);
  program.block("G1 X30", 3);
  program.line("END");
  return program;
}

TEST(ProofOfHoles, PassesRightHolesAndGoesOnFromTheRetractLevel) {
  EXPECT_EQ(with_holes().failure(), "");
}

TEST(ProofOfHoles, FailsOnEveryWrongNumber) {
  for (const auto& [found, wrong] : {std::pair{"Z-20", "Z-20.1"},
                                     {"R2", "R-2"},
                                     {"W10", "W2"},
                                     {"Q5", "Q20"},
                                     {"P0.5", "P0"},
                                     {"K1", "K2"},
                                     {"X10", "X11"},
                                     {"F200", "F201"},
                                     {"LEN1", "LEN0"},
                                     {"DRILL X20", "G0 X20"}}) {
    sample::Program program = with_holes();
    program.change(found, wrong);
    EXPECT_NE(program.failure(), "") << found;
  }
}

TEST(ProofOfHoles, FailsWhileTcpIsOn) {
  sample::Program program = with_holes();
  program.change("LEN1", "TCP1");
  EXPECT_FAILURE(program, "a drilling cycle while TCP is on");
}

TEST(ProofOfHoles, FailsWhereTheFirstHoleIsLeftOut) {
  sample::Program program = with_holes();
  program.cl.move[0] = Move::hole;
  EXPECT_NE(program.failure(), "");
}

// Joint values

/// A linear cut on a C table with a head that turns: gauge length in the words.
sample::Program on_fork_head() {
  sample::Program program{sample::gantry_head_ca(), "XYZAC"};
  program.output = Output::axes;
  program.origin_mm = {100, 0, 0};
  program.gauge_length_mm = {{7, 150.0}};
  program.cl.add_event(1, path::ToolChange{.number = 7});
  program.cl.add_event(1, path::FeedRate{500.0});
  // A about +X by 30 deg turns the tool axis to (0, -sin 30, cos 30); the spindle reference is 350
  // mm from tip to pivot (200 + 150), and with all joints at zero the pivot is 200 above it.
  const Vec3 axis{0, -0.5, std::sqrt(0.75)};
  program.point({0, 0, 0}, axis, Move::rapid);
  program.point({10, 0, 0}, axis);
  program.line("T7");
  program.block("G0 X100 Y-175 Z103.109 A30 C0", 0);  // 350 (0, -0.5, 0.866025) - (0, 0, 200)
  program.block("G1 X110 F500", 1);
  program.line("END");
  return program;
}

TEST(ProofOfJointValues, PassesTheGaugeLengthOfTheToolInUse) {
  EXPECT_EQ(on_fork_head().failure(), "");
}

TEST(ProofOfJointValues, FailsWithTheGaugeLengthOfAnotherToolOrNone) {
  sample::Program longer = on_fork_head();
  longer.gauge_length_mm[7] = 150.02;
  EXPECT_FAILURE(longer, "leaves the CL path by 0.0");
  sample::Program none = on_fork_head();
  none.gauge_length_mm.clear();
  EXPECT_FAILURE(none, "no gauge length for tool 7");
}

TEST(ProofOfJointValues, FailsWhereTheControlAddsTheLengthOnceMore) {
  sample::Program program = on_fork_head();
  program.lines.insert(program.lines.begin(), "LEN1");
  EXPECT_FAILURE(program, "the tool tip leaves the CL path");
}

TEST(ProofOfJointValues, FailsWithTcp) {
  sample::Program program = on_fork_head();
  program.lines.insert(program.lines.begin(), "TCP1");
  EXPECT_FAILURE(program, "no set of joint values");
}

TEST(ProofOfJointValues, FailsWithAnotherOrigin) {
  sample::Program program = on_fork_head();
  program.origin_mm.y() = 0.02;
  EXPECT_FAILURE(program, "the tool tip leaves the CL path");
}

// On a table that turns by 8 deg under a resting tip the chord leaves by 120 (1 - cos 4 deg).
TEST(ProofOfJointValues, FindsTheSagittaOfABlockThatIsNotDivided) {
  sample::Program program{sample::trunnion_ac(), "XYZAC"};
  program.output = Output::axes;
  program.point({120, 0, 0}, Vec3::UnitZ(), Move::rapid);
  program.point({120, 0, 0}, Vec3::UnitZ());
  program.line("LEN1");
  program.block("G0 X120 Y0 Z0 A0 C0", 0);
  program.block("G1 X118.832 Y16.701 C8 F100", 1);
  program.line("END");
  program.tip_mm = 0.2925;
  EXPECT_EQ(program.failure(), "");
  program.tip_mm = 0.2915;
  EXPECT_FAILURE(program, "the tool tip leaves the CL path by 0.29");
}

}  // namespace
}  // namespace pentapost::verify
