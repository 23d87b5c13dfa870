#include "proof_case.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <utility>

namespace pentapost::verify {
namespace {

using path::Move;
using sample::hermle_axis;
using sample::right_program;

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

}  // namespace
}  // namespace pentapost::verify
