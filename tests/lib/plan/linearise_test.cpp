#include "pentapost/plan/linearise.hpp"

#include "sample/chains.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pentapost::plan {
namespace {

Vec3 tilted(double tilt_deg, double towards_deg) {
  const double tilt = tilt_deg * rad_per_deg, towards = towards_deg * rad_per_deg;
  return {std::sin(tilt) * std::cos(towards), std::sin(tilt) * std::sin(towards), std::cos(tilt)};
}

/// A move from a tilt of 30 deg into a point 0.004 deg beside the pole, which is taken as the pole,
/// cut by a trunnion table with TCP.
class IntoThePole : public ::testing::Test {
 protected:
  Status divide(double axis_tolerance_deg, std::vector<Waypoint>& ends) {
    Settings settings;
    settings.axis_tolerance_rad = axis_tolerance_deg * rad_per_deg;
    settings.decimals_deg = 6;
    const kinematics::Model model{sample::trunnion_ac()};
    const JointRanges ranges{};
    BlockMaker maker{model, ranges, settings, 0.0, false};
    const PlannedMove move{
        .cl = {{0, 0, 0}, tilted(30.0, 0.0), {10, 0, 0}, tilted(0.004, 90.0)},
        .by_pole = path::Segment{{0, 0, 0}, tilted(30.0, 0.0), {10, 0, 0}, Vec3::UnitZ()}};
    const RotaryPair start{pi / 2.0, 30.0 * rad_per_deg};
    const MovePart part{
        .kind = MovePart::Kind::branch, .branch = 0, .from = start, .to = {start.first_rad, 0.0}};
    const auto from = maker.posture({0, 0, 0}, start, 1);
    EXPECT_TRUE(from);
    EXPECT_LT((from->axis - tilted(30.0, 0.0)).norm(), 1e-8);
    return linearise(model, settings, maker, move, part, *from, 0.0, 1, ends);
  }
};

TEST_F(IntoThePole, ToleranceIsHeldAgainstTheClMove) {
  std::vector<Waypoint> ends;
  const Status status = divide(0.0039, ends);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, Code::tolerance_below_digits);
}

TEST_F(IntoThePole, AWiderToleranceLeavesRoomForThePole) {
  std::vector<Waypoint> ends;
  ASSERT_TRUE(divide(0.0045, ends));
  EXPECT_EQ(ends.back().fraction, 1.0);
  EXPECT_LT((ends.back().posture.axis - Vec3::UnitZ()).norm(), 1e-8);
}

}  // namespace
}  // namespace pentapost::plan
