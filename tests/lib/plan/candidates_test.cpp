#include "pentapost/plan/candidates.hpp"

#include "sample/chains.hpp"

#include <gtest/gtest.h>

namespace pentapost::plan {
namespace {

/// lib/README.md section 4: with p = b - a (a.b) the first axis stands at
/// atan2(-p.o', (a x p).o') or half a turn from it where the path leaves the pole towards o'.
TEST(Pole, TheFirstAxisIsThatOfTheClosedForm) {
  std::mt19937_64 random{3};
  int poles = 0;
  for (const auto& sample : sample::chains()) {
    const kinematics::Model model{sample.chain};
    const PoleZone zone = pole_zone(model, 0.0, 1e-4);
    for (const std::uint8_t pole : {std::uint8_t{1}, std::uint8_t{2}}) {
      if (!(pole == 1 ? zone.at_zero : zone.at_pi)) continue;
      ++poles;
      const Vec3 axis = pole_axis(model, pole);
      const Vec3 onward = sample::random_axis_at(random, axis, pi / 2.0);
      const Vec3 towards = (axis + 0.2 * onward).normalized();
      const Vec3 p = model.b - model.a * model.a.dot(model.b);
      const double expected_rad = std::atan2(-p.dot(onward), model.a.cross(p).dot(onward));
      for (const int branch : {0, 1}) {
        const double found_rad = first_at_pole_rad(model, pole, towards, branch);
        EXPECT_LE(std::abs(std::sin(found_rad - expected_rad)), 1e-6) << sample.name;
      }
      EXPECT_NEAR(std::abs(wrapped_rad(first_at_pole_rad(model, pole, towards, 0) -
                                       first_at_pole_rad(model, pole, towards, 1))),
                  pi, 1e-6)
          << sample.name;
    }
  }
  EXPECT_GE(poles, 20);
}

/// Great circles that miss the pole by little: the unwrapped first axis is that of dense samples.
TEST(Candidates, FollowTheFirstAxisPastThePole) {
  std::mt19937_64 random{11};
  const kinematics::Model model{sample::trunnion_ac()};
  for (const double miss_rad : {0.3, 0.01, 1e-3}) {
    const Vec3 along = sample::random_axis_at(random, model.a, pi / 2.0);
    const Vec3 across = model.a.cross(along);
    const auto on_circle = [&](double angle_rad) -> Vec3 {
      const Vec3 top = std::cos(miss_rad) * model.a + std::sin(miss_rad) * across;
      return std::cos(angle_rad) * top + std::sin(angle_rad) * along;
    };
    path::ToolPath path;
    path.add_point({0, 0, 0}, on_circle(-0.7), 1, path::Move::feed);
    path.add_point({1, 0, 0}, on_circle(0.9), 2, path::Move::feed);
    const auto found = find_candidates(model, path, {0, 2}, pole_zone(model, 0.0, 0.0), 0.0);
    ASSERT_TRUE(found) << found.error().message;

    // Azimuth of the axis as seen from the pole; C follows it, unwrapped, on both branches.
    double expected_rad = 0.0;
    Vec3 before = on_circle(-0.7);
    constexpr int count = 1'000'000;
    for (int i = 1; i <= count; ++i) {
      const Vec3 here = on_circle(-0.7 + 1.6 * i / count);
      expected_rad += std::atan2(model.a.dot(before.cross(here)),
                                 before.dot(here) - model.a.dot(before) * model.a.dot(here));
      before = here;
    }
    for (const int branch : {0, 1})
      EXPECT_NEAR(found->first_of(1, branch) - found->first_of(0, branch), expected_rad, 1e-6)
          << miss_rad;
  }
}

TEST(Candidates, AHalfTurnByFeedHasNoWay) {
  const kinematics::Model model{sample::trunnion_ac()};
  path::ToolPath path;
  path.add_point({0, 0, 0}, Vec3{1, 0, 0.001}.normalized(), 4, path::Move::feed);
  path.add_point({1, 0, 0}, Vec3{-1, 0, -0.001}.normalized(), 5, path::Move::feed);
  const auto found = find_candidates(model, path, {0, 2}, pole_zone(model, 0.0, 0.0), 0.0);

  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, Code::half_turn);
  EXPECT_EQ(found.error().cl_line, 5U);
}

}  // namespace
}  // namespace pentapost::plan
