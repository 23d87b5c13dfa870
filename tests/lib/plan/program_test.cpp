#include "pentapost/plan/program.hpp"

#include "lib/plan/program_case.hpp"

#include <gtest/gtest.h>

namespace pentapost::plan {
namespace {

using sample::ProgramCase;

/// What the planning answers, and the CL line that it names; "" and 0: a program.
struct Answer {
  std::string code;
  std::uint32_t cl_line = 0;
  bool operator==(const Answer&) const = default;
};
void PrintTo(const Answer& answer, std::ostream* out) {
  *out << answer.code << " at CL line " << answer.cl_line;
}
Answer answer_of(const ProgramCase& job) {
  const auto program = job.planned();
  if (program) return {};
  return {std::string{row_of(program.error().code).name}, program.error().cl_line.value_or(0)};
}

TEST(Program, RefusesCoordinatesThatNoMachineHas) {
  ProgramCase job{sample::trunnion_ac()};
  job.rapid({1e6, 0, 0});
  EXPECT_EQ(answer_of(job), Answer{});
  job.rapid({0, -1.001e6, 0});
  EXPECT_EQ(answer_of(job), (Answer{"out_of_domain", 2}));
}

/// Rounding three words to 0.001 mm moves the tip by up to 0.0005 sqrt(3) = 0.000866 mm.
TEST(Program, RefusesTolerancesFinerThanTheDigitsPrinted) {
  ProgramCase job{sample::trunnion_ac()};
  job.rapid({0, 0, 0});
  job.settings.tip_tolerance_mm = 0.00087;
  EXPECT_EQ(answer_of(job), Answer{});
  job.settings.tip_tolerance_mm = 0.00086;
  EXPECT_EQ(answer_of(job).code, "tolerance_below_digits");

  job.settings.tip_tolerance_mm = 0.01;
  job.settings.axis_tolerance_rad = 0.001 * rad_per_deg;
  EXPECT_EQ(answer_of(job), Answer{});
  job.settings.axis_tolerance_rad = 0.0009 * rad_per_deg;
  EXPECT_EQ(answer_of(job).code, "tolerance_below_digits");
}

TEST(Program, WithoutRotaryAxesTheTipIsWhereTheLinearAxesAre) {
  ProgramCase straight{sample::three_axis(), Output::tcp};
  straight.rapid({0, 0, 0});
  const auto program = straight.planned();
  ASSERT_TRUE(program) << program.error().message;
  EXPECT_EQ(program->motion.output, Output::axes);

  ProgramCase mirrored{
      sample::chain_of({}, {sample::linear("X", -Vec3::UnitX()), sample::y(), sample::z()}),
      Output::tcp};
  mirrored.rapid({0, 0, 0});
  EXPECT_EQ(answer_of(mirrored).code, "unsupported_output");
}

TEST(Program, SaysWhereThePathLeavesTheReach) {
  ProgramCase job{sample::nutating_table()};
  job.feed_rate(500.0);
  job.rapid({0, 0, 0}, {0, 0.6, 0.8});
  job.point({1, 0, 0}, {0, 0.8, -0.6});
  EXPECT_EQ(answer_of(job), (Answer{"out_of_reach", 3}));
}

TEST(Program, SaysWhichCutHasNoFeed) {
  ProgramCase job{sample::trunnion_ac()};
  job.rapid({0, 0, 0});
  job.point({1, 0, 0});
  EXPECT_EQ(answer_of(job), (Answer{"no_feed", 2}));
}

/// Turns about a circle of a kilometre, divided as finely as the digits allow: on a radius R a
/// chord of length sqrt(8 R tip_mm) leaves the circle by tip_mm, so a turn is over 70,000 blocks.
ProgramCase rounds(int count, double turns) {
  ProgramCase job{sample::three_axis(), Output::axes};
  job.settings.tip_tolerance_mm = 0.001;
  job.feed_rate(500.0);
  job.rapid({1e6, 0, 0});
  for (int i = 0; i < count; ++i) {
    job.event(path::Arc{.sweep_rad = 2.0 * pi * turns});
    job.point({1e6, 0, 0});
  }
  return job;
}

TEST(Program, AMoveOfMoreThanAMillionBlocksIsTooLarge) {
  EXPECT_EQ(answer_of(rounds(1, 2.0)), Answer{});
  EXPECT_EQ(answer_of(rounds(1, 1e5)), (Answer{"too_large", 4}));
}

/// Every move is within its million; the first one that brings the sum over ten millions is named.
TEST(Program, OfMoreThanTenMillionInsertedBlocksIsTooLarge) {
#if defined(__SANITIZE_ADDRESS__) || !defined(NDEBUG)
  GTEST_SKIP() << "ten million blocks: with optimisation and without sanitizers only";
#endif
  const auto one = rounds(1, 4.0).planned();
  ASSERT_TRUE(one) << one.error().message;
  const std::uint64_t inserted = one->inserted_points;
  ASSERT_GT(inserted, 280'000U);
  ASSERT_LT(inserted, 1'000'000U);
  const auto fitting = static_cast<std::uint32_t>(10'000'000 / inserted);
  EXPECT_EQ(answer_of(rounds(60, 4.0)), (Answer{"too_large", 2 + 2 * (fitting + 1)}));
}

}  // namespace
}  // namespace pentapost::plan
