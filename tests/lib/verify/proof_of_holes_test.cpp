#include "proof_case.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace pentapost::verify {
namespace {

using path::Move;

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

/// A hole at Z0, clearance 3, then one on a boss 30 mm higher, joint values at A0 C0.
sample::Program with_a_boss() {
  sample::Program program{sample::trunnion_ac(), "XYZAC"};
  program.output = Output::axes;
  program.cl.add_event(1, path::FeedRate{200.0});
  program.point({0, 0, 50}, Vec3::UnitZ(), Move::rapid);
  program.cl.add_event(2, path::CycleStart{.depth_mm = 10, .clearance_mm = 3});
  program.point({0, 0, 0}, Vec3::UnitZ(), Move::hole);
  program.point({20, 0, 30}, Vec3::UnitZ(), Move::hole);
  program.point({40, 0, 0}, Vec3::UnitZ(), Move::hole);
  program.line("LEN1");
  program.block("G0 X0 Y0 Z50 A0 C0", 0);
  program.block("DRILL X0 Y0 Z-10 R3 W3 F200", 1);
  program.off("G0 Z33", 2);
  program.block("DRILL X20 Y0 Z20 R33 W33 F200", 2);
  program.block("DRILL X40 Y0 Z-10 R3 W3 F200", 3);
  program.line("END");
  return program;
}

TEST(ProofOfHoles, PassesAToolThatRisesBeforeItMovesAcross) {
  EXPECT_EQ(with_a_boss().failure(), "");
}

/// The control moves across at Z3, through the boss, and rises to R33 only then.
TEST(ProofOfHoles, FailsWhereTheWayAcrossIsBelowTheNextClearance) {
  sample::Program program = with_a_boss();
  program.lines.erase(program.lines.begin() + 3);
  program.motion.blocks.erase(program.motion.blocks.begin() + 2);
  EXPECT_FAILURE(program, "the way to the hole runs 30 mm below the level of its clearance");
}

TEST(ProofOfHoles, FailsWhereTheToolRisesTooLittle) {
  sample::Program program = with_a_boss();
  program.change("G0 Z33", "G0 Z32.9");
  EXPECT_FAILURE(program, "the way to the hole runs 0.1 mm below the level of its clearance");
}

TEST(ProofOfHoles, FailsWhereTheToolRisesAcross) {
  sample::Program program = with_a_boss();
  program.change("G0 Z33", "G0 X20 Z33");
  EXPECT_FAILURE(program, "before this hole the tool leaves the tool axis by 20 mm");
}

/// Between the holes lies the boss: the tool must not come down before it moves across.
TEST(ProofOfHoles, FailsWhereTheToolComesDownBeforeItMovesAcross) {
  sample::Program program = with_a_boss();
  program.lines.insert(program.lines.begin() + 5, "G0 Z3");
  path::Block down;
  down.point = 3;
  down.kind = path::Block::Kind::rapid;
  down.on_path = false;
  program.motion.blocks.insert(program.motion.blocks.begin() + 4, down);
  EXPECT_FAILURE(program, "before this hole the tool");
}

/// A control whose own cycle goes across lower than the point before.
TEST(ProofOfHoles, FailsWhereTheWayAcrossIsBelowThePointBefore) {
  sample::Program program = with_a_boss();
  program.change("DRILL X40 Y0 Z-10 R3 W3 F200", "DRILL X40 Y0 Z-10 R3 W3 F200 V3");
  EXPECT_FAILURE(program, "the way to the hole runs 30 mm below the level of the point before");
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

}  // namespace
}  // namespace pentapost::verify
