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
