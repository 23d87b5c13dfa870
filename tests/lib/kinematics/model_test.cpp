#include "pentapost/kinematics/model.hpp"

#include "lib/kinematics/hard_chains.hpp"

#include <gtest/gtest.h>

namespace pentapost::kinematics {
namespace {

TEST(Model, NamesTheJointNearestTheWorkpieceFirst) {
  EXPECT_EQ(Model{sample::trunnion_ac()}.rotary_names, (std::array<std::string, 2>{"C", "A"}));
  EXPECT_EQ(Model{sample::trunnion_ba()}.rotary_names, (std::array<std::string, 2>{"B", "A"}));
  EXPECT_EQ(Model{sample::nutating_head()}.rotary_names, (std::array<std::string, 2>{"C", "B"}));
  EXPECT_EQ(Model{sample::four_axis_a()}.rotary_names, (std::array<std::string, 2>{"A", ""}));
}

TEST(Model, NamesLinearJointsFromAToZ) {
  const std::array<std::string, 3> expected{"X", "Y", "Z"};

  EXPECT_EQ(Model{sample::trunnion_ac()}.linear_names, expected);  // its chain says Y X Z
  EXPECT_EQ(Model{sample::nutating_head()}.linear_names, expected);
}

TEST(Model, NegatesDirectionsOnTheTableSide) {
  const Model model{sample::nutating_head()};

  EXPECT_EQ(model.a, Vec3::UnitZ());  // C [0, 0, -1] on the table
  EXPECT_LT((model.b - Vec3{0, 1, 1}.normalized()).norm(), 1e-15);
  EXPECT_EQ(Vec3{model.linear_columns[1].col(1)}, Vec3::UnitY());  // Y [0, -1, 0] on the table
  EXPECT_EQ(model.b_point_mm, (Vec3{0, 272, 172}));
}

TEST(Model, KeepsLinearJointsInTheirPlaces) {
  const Model model{sample::quill_on_head()};

  EXPECT_EQ(model.has_linear, (std::array<bool, 3>{false, true, true}));
  EXPECT_EQ(Vec3{model.linear_columns[1].col(0)}, Vec3::UnitX());
  EXPECT_EQ(Vec3{model.linear_columns[1].col(2)}, Vec3::Zero());
  EXPECT_EQ(Vec3{model.linear_columns[2].col(2)}, Vec3::UnitZ());
}

TEST(Model, SaysWhetherTheHeadTurns) {
  EXPECT_FALSE(Model{sample::trunnion_ac()}.head_turns);
  EXPECT_TRUE(Model{sample::swivel_head()}.head_turns);
}

TEST(Model, DrawsTheTriangleOfTheNutatingTable) {
  const Model model{sample::nutating_table()};

  EXPECT_NEAR(model.lambda_rad, pi / 4, 1e-15);
  EXPECT_NEAR(model.mu_rad, pi / 4, 1e-15);
  EXPECT_NEAR(model.beta_zero_rad, 0.0, 1e-15);
}

// A trunnion has both angles right; its sign makes the upright tool gamma = 0, not 180 deg.
TEST(Model, DrawsTheTriangleOfATrunnionWithTheToolUpright) {
  const Model model{sample::trunnion_ac()};  // a = (0, 0, -1)

  EXPECT_TRUE(model.a_flipped);
  EXPECT_NEAR(model.lambda_rad, pi / 2, 1e-15);
  EXPECT_NEAR(model.mu_rad, pi / 2, 1e-15);
  EXPECT_NEAR(model.beta_zero_rad, 0.0, 1e-15);
}

// The Pocket NC: the first axis lies along y; A = -90 or 90 deg brings the tool there.
TEST(Model, DrawsTheTriangleOfATrunnionWhosePoleLiesDown) {
  const Model model{sample::trunnion_ba()};

  EXPECT_NEAR(std::abs(model.beta_zero_rad), pi / 2, 1e-15);
}

class TriangleOn : public ::testing::TestWithParam<sample::NamedChain> {};

TEST_P(TriangleOn, HasSidesOfAtMostARightAngle) {
  const Model model{GetParam().chain};

  EXPECT_LE(model.lambda_rad, pi / 2 + 2e-15);
  EXPECT_LE(model.mu_rad, pi / 2 + 2e-15);
}

// With the second joint at beta_zero the tool axis is as near to the (drawn) first axis as it gets.
TEST_P(TriangleOn, StartsWhereTheToolAxisIsNearestTheFirstAxis) {
  const Model model{GetParam().chain};
  const Vec3 a_drawn = model.a_flipped ? Vec3{-model.a} : model.a;
  const auto gamma_rad = [&](double second_rad) {
    return angle_between_rad(a_drawn, Eigen::AngleAxisd{second_rad, model.b} * model.t);
  };

  EXPECT_NEAR(gamma_rad(model.beta_zero_rad), std::abs(model.lambda_rad - model.mu_rad), 1e-15);
  EXPECT_NEAR(gamma_rad(model.beta_zero_rad + pi), model.lambda_rad + model.mu_rad, 1e-15);
}

INSTANTIATE_TEST_SUITE_P(, TriangleOn, ::testing::ValuesIn(sample::five_axis_chains()),
                         sample::name_of_chain);

}  // namespace
}  // namespace pentapost::kinematics
