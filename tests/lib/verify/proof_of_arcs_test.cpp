#include "proof_case.hpp"

#include <gtest/gtest.h>

namespace pentapost::verify {
namespace {

using path::Move;

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

}  // namespace
}  // namespace pentapost::verify
