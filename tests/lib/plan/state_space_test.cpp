#include "pentapost/plan/state_space.hpp"

#include <gtest/gtest.h>

namespace pentapost::plan {
namespace {

constexpr double turn_rad = 2.0 * pi;

/// C of both branches runs from 0 to `turns` turns in steps of a tenth.
Candidates winding(int turns) {
  Candidates candidates;
  const auto count = static_cast<std::uint32_t>(10 * turns + 1);
  candidates.range = {0, count};
  candidates.branches = 1;
  for (std::uint32_t point = 0; point < count; ++point)
    candidates.first_rad[0].push_back(0.1 * turn_rad * point);
  candidates.second_rad.assign(count, 0.3);
  candidates.pole.assign(count, 0);
  return candidates;
}

kinematics::Model trunnion() {
  const auto z = UnitVector::normalised(Vec3::UnitZ());
  std::vector<machine::Joint> table{
      {"C", machine::RotaryJoint{z, Vec3::Zero(), std::nullopt}},
      {"A",
       machine::RotaryJoint{UnitVector::normalised(Vec3::UnitX()), Vec3::Zero(), std::nullopt}}};
  std::vector<machine::Joint> head{
      {"X", machine::LinearJoint{UnitVector::normalised(Vec3::UnitX()), std::nullopt}},
      {"Y", machine::LinearJoint{UnitVector::normalised(Vec3::UnitY()), std::nullopt}},
      {"Z", machine::LinearJoint{z, std::nullopt}}};
  return kinematics::Model{machine::Chain::make(std::move(table), std::move(head), z).value()};
}

JointRanges first_range(double lower_deg, double upper_deg) {
  JointRanges ranges;
  ranges.rotary_rad[0] = Range<double>{lower_deg * rad_per_deg, upper_deg * rad_per_deg};
  return ranges;
}

TEST(StateSpace, AnEndlessAxisNeedsOneStateABranch) {
  EXPECT_EQ(state_space(trunnion(), {}, winding(500), {}).states.size(), 1U);
}

TEST(StateSpace, APathOfAnyLengthNeedsFewStates) {
  const auto space = state_space(trunnion(), first_range(-360, 360), winding(500), {});
  EXPECT_LE(space.states.size(), 4U);
}

/// Every value that the range allows belongs to one state, wherever the path has got to.
TEST(StateSpace, EveryTurnWithinTheRangeIsAStateAtEveryPoint) {
  const auto range = first_range(-400, 400);
  const auto candidates = winding(50);
  const auto space = state_space(trunnion(), range, candidates, {});
  for (std::uint32_t point = 0; point < candidates.range.end; ++point) {
    const double value_rad = candidates.first_of(point, 0);
    int wanted = 0, found = 0;
    for (int turns = -60; turns <= 60; ++turns) {
      if (!in_range(range.rotary_rad[0], value_rad + turns * turn_rad)) continue;
      ++wanted;
      for (const State& state : space.states) found += space.first_turns(state, value_rad) == turns;
    }
    ASSERT_GE(wanted, 2);
    EXPECT_EQ(found, wanted) << point;
  }
}

TEST(StateSpace, AVeryWideRangeIsHarmless) {
  const auto space = state_space(trunnion(), first_range(-1e15, 1e15), winding(5), {});
  EXPECT_GE(space.states.size(), 1U);
  EXPECT_LE(space.states.size(), StateSpace::largest_state_count);
}

}  // namespace
}  // namespace pentapost::plan
