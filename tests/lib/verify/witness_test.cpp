#include "pentapost/verify/witness.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <utility>

namespace pentapost::verify {
namespace {

path::Block block(std::uint32_t point, double fraction) {
  path::Block made;
  made.point = point;
  made.fraction = fraction;
  return made;
}

/// Whether the blocks cover a path of `points` points.
bool covers(std::size_t points, std::initializer_list<std::pair<std::uint32_t, double>> blocks) {
  Coverage coverage{points};
  for (const auto& [point, fraction] : blocks)
    if (!coverage.advance(block(point, fraction))) return false;
  return coverage.finish().has_value();
}

TEST(Coverage, TakesAPathPointByPointAndInParts) {
  EXPECT_TRUE(covers(3, {{0, 1}, {1, 1}, {2, 1}}));
  EXPECT_TRUE(covers(3, {{0, 1}, {1, 0.25}, {1, 0.5}, {1, 1}, {2, 1}}));
}

TEST(Coverage, MayBeginWithTheMoveFromTheFirstPoint) { EXPECT_TRUE(covers(2, {{1, 1}})); }

TEST(Coverage, GivesThePartThatABlockCovers) {
  Coverage coverage{2};
  ASSERT_TRUE(coverage.advance(block(0, 1)));
  ASSERT_TRUE(coverage.advance(block(1, 0.25)));
  const auto covered = coverage.advance(block(1, 0.75));
  ASSERT_TRUE(covered);
  EXPECT_EQ(covered->point, 1U);
  EXPECT_EQ(covered->from_fraction, 0.25);
  EXPECT_EQ(covered->to_fraction, 0.75);
}

TEST(Coverage, RefusesGapsRepeatsAndWaysBack) {
  EXPECT_FALSE(covers(3, {{0, 1}, {2, 1}}));
  EXPECT_FALSE(covers(3, {{0, 1}, {1, 0.5}, {2, 1}}));
  EXPECT_FALSE(covers(3, {{0, 1}, {1, 0.5}, {1, 0.5}, {1, 1}, {2, 1}}));
  EXPECT_FALSE(covers(3, {{0, 1}, {1, 0.5}, {1, 0.4}, {1, 1}, {2, 1}}));
  EXPECT_FALSE(covers(3, {{0, 1}, {1, 1}, {1, 1}, {2, 1}}));
  EXPECT_FALSE(covers(3, {{0, 1}, {1, 1}, {0, 1}}));
  EXPECT_FALSE(covers(3, {{2, 1}}));
}

TEST(Coverage, RefusesPathsThatAreNotFinished) {
  EXPECT_FALSE(covers(3, {{0, 1}, {1, 1}}));
  EXPECT_FALSE(covers(2, {{0, 1}, {1, 0.999999}}));
  EXPECT_FALSE(covers(1, {}));
}

TEST(Coverage, RefusesFractionsAndPointsOutsideOfTheirDomain) {
  EXPECT_FALSE(covers(2, {{0, 1}, {1, 0.0}}));
  EXPECT_FALSE(covers(2, {{0, 1}, {1, 1.5}}));
  EXPECT_FALSE(covers(2, {{0, 0.5}}));
  EXPECT_FALSE(covers(2, {{0, 1}, {1, 1}, {2, 1}}));
}

}  // namespace
}  // namespace pentapost::verify
