#include "proof_case.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pentapost::verify {
namespace {

using path::Move;

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
