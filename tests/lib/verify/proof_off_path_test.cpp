#include "proof_case.hpp"

#include <gtest/gtest.h>

namespace pentapost::verify {
namespace {

using path::Move;
using sample::hermle_axis;
using sample::right_program;

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

}  // namespace
}  // namespace pentapost::verify
