#include "pentapost/plan/move_curve.hpp"

#include "pentapost/kinematics/forward.hpp"
#include "pentapost/kinematics/inverse.hpp"
#include "sample/chains.hpp"

#include <gtest/gtest.h>

namespace pentapost::plan {
namespace {

/// The trunnion's tool axis at C = 0: (0, sin A, cos A).
Vec3 tilted(double a_rad) { return {0.0, std::sin(a_rad), std::cos(a_rad)}; }

class Inside : public ::testing::Test {
 protected:
  std::optional<RotaryPair> at(const MovePart& part, double fraction, const Vec3& from,
                               const Vec3& to, double slack_rad = 0.0) const {
    const path::Segment segment{{0, 0, 0}, from, {1, 0, 0}, to};
    return rotary_inside(model_, segment, part, fraction, part.from, part.to, slack_rad);
  }
  const kinematics::Model model_{sample::trunnion_ac()};
};

TEST_F(Inside, APartAtRestIsWhereItStarts) {
  const MovePart part{.kind = MovePart::Kind::still, .from = {1.5, 0.3}, .to = {1.5, 0.3}};
  EXPECT_EQ(at(part, 0.7, tilted(0.3), tilted(0.3)), (RotaryPair{1.5, 0.3}));
}

/// From 0.2 to 0.6 of the move the first axis turns from 1 to 3.
TEST_F(Inside, AnEvenPartTurnsTheFirstAxisByItsShare) {
  const MovePart part{.kind = MovePart::Kind::even,
                      .fraction_from = 0.2,
                      .fraction_to = 0.6,
                      .from = {1.0, 0.0},
                      .to = {3.0, 0.0}};
  const auto found = at(part, 0.3, tilted(0.0), tilted(0.0));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->first_rad, 1.5, 1e-15);
  EXPECT_EQ(found->second_rad, 0.0);
}

/// Along the meridian of C = 0 the tilt runs evenly; the fraction is that of the whole move, and C
/// stays in the turn of its ends.
TEST_F(Inside, ABranchFollowsTheGreatCircleInTheTurnOfItsEnds) {
  const int positive =
      kinematics::inverse_rotary(model_, tilted(0.3)).branch[0].second_rad > 0.0 ? 0 : 1;
  for (const double turns : {-3.0, 0.0, 5.0}) {
    const double c_rad = 2.0 * pi * turns;
    const MovePart part{.kind = MovePart::Kind::branch,
                        .branch = positive,
                        .fraction_from = 0.5,
                        .from = {c_rad, 0.5},
                        .to = {c_rad, 0.8}};
    const auto found = at(part, 0.75, tilted(0.2), tilted(0.8));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->first_rad, c_rad, 1e-12);
    EXPECT_NEAR(found->second_rad, 0.2 + 0.75 * 0.6, 1e-12);
  }
}

TEST_F(Inside, AtThePoleTheFirstAxisIsBetweenItsNeighbours) {
  const MovePart part{.kind = MovePart::Kind::branch, .from = {1.0, -0.2}, .to = {1.4, 0.2}};
  const auto found = at(part, 0.5, Vec3::UnitZ(), Vec3::UnitZ());
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->first_rad, 1.2, 1e-15);
  EXPECT_NEAR(found->second_rad, 0.0, 1e-15);
}

/// The nutating table reaches no axis below the horizon; a little beyond is forgiven by the slack.
TEST_F(Inside, OutOfReachIsNothing) {
  const kinematics::Model nutating{sample::nutating_table()};
  const Vec3 level = tilted(pi / 2.0), below = tilted(pi / 2.0 + 1e-4);
  const path::Segment segment{{0, 0, 0}, level, {1, 0, 0}, below};
  const MovePart part{.kind = MovePart::Kind::branch, .from = {0.0, pi}, .to = {0.0, pi}};
  EXPECT_FALSE(rotary_inside(nutating, segment, part, 0.5, part.from, part.to, 0.0));
  EXPECT_TRUE(rotary_inside(nutating, segment, part, 0.5, part.from, part.to, 1e-4));
}

/// On every kind of machine, all along random great circles, the pair gives the axis of the circle.
TEST(RotaryInside, GivesTheAxisOfTheGreatCircleOnEveryChain) {
  std::mt19937_64 random{17};
  for (const auto& sample : sample::chains()) {
    const kinematics::Model model{sample.chain};
    if (model.rotary_count != 2) continue;
    std::uniform_real_distribution<double> angle_rad{-3.0, 3.0}, share{0.0, 1.0};
    for (int i = 0; i < 50; ++i) {
      const Vec3 from = kinematics::forward_axis(model, angle_rad(random), angle_rad(random));
      const Vec3 to = sample::random_axis_at(random, from, 0.2);
      const path::Segment segment{{0, 0, 0}, from, {1, 0, 0}, to};
      const double fraction = share(random);
      MovePart part;
      part.kind = MovePart::Kind::branch;
      part.branch = i % 2;
      const auto pair = rotary_inside(model, segment, part, fraction, {9.0, 0.0}, {9.2, 0.0}, 0.0);
      if (!pair) continue;
      const Vec3 expected =
          (std::sin(0.2 * (1.0 - fraction)) * from + std::sin(0.2 * fraction) * to) / std::sin(0.2);
      EXPECT_LE(
          (kinematics::forward_axis(model, pair->first_rad, pair->second_rad) - expected).norm(),
          1e-12)
          << sample.name << ' ' << i;
      EXPECT_LE(std::abs(pair->first_rad - 9.1), pi + 1e-12) << sample.name << ' ' << i;
    }
  }
}

/// The cheap single branch of plain paths is that of the whole inverse, to the last bit.
TEST(InverseRotaryInside, IsTheBranchOfTheWholeInverse) {
  std::mt19937_64 random{23};
  int compared = 0;
  for (const auto& sample : sample::chains()) {
    const kinematics::Model model{sample.chain};
    if (model.rotary_count != 2) continue;
    for (int i = 0; i < 2000; ++i) {
      const Vec3 axis = sample::random_axis(random);
      const auto whole = kinematics::inverse_rotary(model, axis);
      if (whole.count == 0 || whole.first_is_free) continue;
      for (const int branch : {0, 1}) {
        const auto inside = kinematics::inverse_rotary_inside(model, axis, branch);
        ASSERT_EQ(inside.first_rad, whole.branch[static_cast<std::size_t>(branch)].first_rad)
            << sample.name << ' ' << i;
        ASSERT_EQ(inside.opening_rad, whole.opening_rad) << sample.name << ' ' << i;
        ASSERT_NEAR(inside.sin_gamma, std::sin(whole.gamma_rad), 1e-14) << sample.name << ' ' << i;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 50'000);
}

/// Where it cannot answer its opening or sin_gamma says so.
TEST(InverseRotaryInside, TellsThePoleAndWhatIsBeyondTheReach) {
  std::mt19937_64 random{29};
  int beyond = 0;
  for (const auto& sample : sample::chains()) {
    const kinematics::Model model{sample.chain};
    if (model.rotary_count != 2) continue;
    EXPECT_LE(kinematics::inverse_rotary_inside(model, model.a, 0).sin_gamma, 1e-15);
    for (int i = 0; i < 500; ++i) {
      const Vec3 axis = sample::random_axis(random);
      if (kinematics::inverse_rotary(model, axis).count != 0) continue;
      const double opening_rad = kinematics::inverse_rotary_inside(model, axis, 0).opening_rad;
      EXPECT_TRUE(opening_rad == 0.0 || opening_rad == pi) << sample.name << ' ' << opening_rad;
      ++beyond;
    }
  }
  EXPECT_GT(beyond, 1000);
}

}  // namespace
}  // namespace pentapost::plan
