#include "pentapost/plan/sequences.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace pentapost::plan {
namespace {

constexpr path::Move rapid = path::Move::rapid, feed = path::Move::feed;

Vec3 tilted(double tilt_deg) {
  return {std::sin(tilt_deg * rad_per_deg), 0.0, std::cos(tilt_deg * rad_per_deg)};
}

/// Two upright points, then one with another tilt behind an event.
std::vector<Sequence> with_between(const path::EventKind& event, path::Move move, double tilt_deg) {
  path::ToolPath path;
  path.add_point({0, 0, 0}, Vec3::UnitZ(), 1, rapid);
  path.add_point({1, 0, 0}, Vec3::UnitZ(), 2, feed);
  path.add_event(3, event);
  path.add_point({2, 0, 0}, tilted(tilt_deg), 4, move);
  return sequences(path);
}

/// Its straight line may lead through the part: the tool goes by way of its safe end.
TEST(Sequences, ARapidThatTurnsTheToolIntoAnOperationStartsOne) {
  const auto found = with_between(path::Operation{"SLOT 2"}, rapid, 1.5);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].range.end, 2U);
  EXPECT_EQ(found[1].range.begin, 2U);
  EXPECT_EQ(found[1].tool_number, 1);
}

TEST(Sequences, AnOperationWithTheSameToolAxisGoesOn) {
  EXPECT_EQ(with_between(path::Operation{"SLOT 2"}, rapid, 0.5).size(), 1U);
}

TEST(Sequences, ACutIntoAnOperationGoesOn) {
  EXPECT_EQ(with_between(path::Operation{"SLOT 2"}, feed, 30.0).size(), 1U);
}

TEST(Sequences, ARapidWithinAnOperationGoesOn) {
  EXPECT_EQ(with_between(path::Comment{"SLOT 2"}, rapid, 30.0).size(), 1U);
}

TEST(Sequences, AnotherToolStartsOneAndTheSameToolDoesNot) {
  EXPECT_EQ(with_between(path::ToolChange{.number = 2}, feed, 0.0).size(), 2U);
  EXPECT_EQ(with_between(path::ToolChange{.number = 1}, feed, 0.0).size(), 1U);
}

TEST(Sequences, TheWayHomeStartsOne) {
  EXPECT_EQ(with_between(path::GoHome{}, feed, 0.0).size(), 2U);
}

}  // namespace
}  // namespace pentapost::plan
