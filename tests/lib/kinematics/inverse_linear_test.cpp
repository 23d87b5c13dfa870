#include "lib/kinematics/hard_chains.hpp"
#include "pentapost/kinematics/forward.hpp"
#include "pentapost/kinematics/inverse.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pentapost::kinematics {
namespace {

void expect_near(const Vec3& found, const Vec3& expected, double tolerance) {
  EXPECT_LT((found - expected).norm(), tolerance)
      << found.transpose() << " instead of " << expected.transpose();
}

// The joints X and Y of the head, Z of the table: by hand, with B lying at 90 deg the tip is
// 275 mm to the left of the axis and level with it.
TEST(InverseLinear, UndoesTheSwingOfTheHead) {
  const auto found = inverse_linear(Model{sample::swivel_head()}, {-175, 0, 295}, 0.0, pi / 2, 80);

  ASSERT_TRUE(found);
  expect_near(*found, {0, 0, 0}, 1e-12);
}

TEST(InverseLinear, AddsTheGaugeLengthAlongTheToolAxis) {
  const Model model{sample::trunnion_ac()};

  const auto found = inverse_linear(model, {10, 20, 30}, 0.0, 0.0, 125.0);

  ASSERT_TRUE(found);
  expect_near(*found, {10, 20, 155}, 1e-13);
}

TEST(InverseLinear, GivesJointsInTheOrderOfTheirNames) {
  const Model model{
      sample::chain_of({}, {sample::linear("Z", {1, 0, 0}), sample::linear("U", {0, 1, 0}),
                            sample::linear("X", {0, 0, 1})})};
  ASSERT_EQ(model.linear_names, (std::array<std::string, 3>{"U", "X", "Z"}));

  const auto found = inverse_linear(model, {1, 2, 3}, 0.0, 0.0, 0.0);

  ASSERT_TRUE(found);
  expect_near(*found, {2, 3, 1}, 1e-15);
}

// Directions at 60 deg to each other: a right-angled solution would be wrong.
TEST(InverseLinear, SolvesForObliqueLinearJoints) {
  const Vec3 leaning{0.5, std::sqrt(0.75), 0.0};
  const Model model{sample::chain_of({}, {sample::x(), sample::linear("Y", leaning), sample::z()})};

  const auto found = inverse_linear(model, 3.0 * Vec3::UnitX() + 4.0 * leaning, 0.0, 0.0, 0.0);

  ASSERT_TRUE(found);
  expect_near(*found, {3, 4, 0}, 1e-14);
}

// A quill on a head at B = 90 deg runs along X, and nothing moves the tip up.
TEST(InverseLinear, HasNoSolutionWhereTheQuillLiesDown) {
  const Model model{sample::quill_on_head()};

  EXPECT_FALSE(inverse_linear(model, {0, 0, 0}, 0.0, pi / 2, 100.0));
  EXPECT_FALSE(inverse_linear(model, {0, 0, 0}, 1.0, -pi / 2, 100.0));
  EXPECT_TRUE(inverse_linear(model, {0, 0, 0}, 0.0, pi / 2 - 1e-5, 100.0));
}

// cos 60 deg: the quill has to go twice as far as the tip goes up.
TEST(InverseLinear, DrivesTheQuillFurtherWhereItLeans) {
  const Model model{sample::quill_on_head()};
  const double b_rad = 60 * rad_per_deg;

  const auto lower = inverse_linear(model, {0, 0, 0}, 0.0, b_rad, 100.0);
  const auto upper = inverse_linear(model, {0, 0, 1}, 0.0, b_rad, 100.0);

  ASSERT_TRUE(lower && upper);
  EXPECT_NEAR(upper->z() - lower->z(), 2.0, 1e-12);
}

}  // namespace
}  // namespace pentapost::kinematics
