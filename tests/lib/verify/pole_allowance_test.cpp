#include "pentapost/verify/pole_allowance.hpp"

#include "sample/chains.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace pentapost::verify {
namespace {

Vec3 tilted(double tilt_deg) {
  return {0.0, std::sin(tilt_deg * rad_per_deg), std::cos(tilt_deg * rad_per_deg)};
}

/// Three feed moves about a pole of a trunnion; what a test changes.
struct Case {
  path::ToolPath tool_path;
  kinematics::Model model{sample::trunnion_ac()};
  path::Motion motion;
  std::vector<Vec3> planned;
  double pole_axis_rad = 1.0 * rad_per_deg;

  explicit Case(double tilt_deg = 0.5) {
    for (int i = 0; i < 4; ++i)
      tool_path.add_point({1.0 * i, 0, 0}, tilted(tilt_deg), static_cast<std::uint32_t>(i + 10),
                          path::Move::feed);
    planned = tool_path.axis_wp;
  }
  Status check() const {
    return check_pole_allowance({.tool_path = tool_path,
                                 .model = model,
                                 .motion = motion,
                                 .reader_setup = {},
                                 .axis_tolerance_rad = 0.05 * rad_per_deg,
                                 .planned_axis_wp = planned,
                                 .pole_axis_rad = pole_axis_rad});
  }
};

TEST(PoleAllowance, TakesAChangeBesideThePole) {
  Case the;
  the.planned[1] = tilted(0.0);
  EXPECT_TRUE(the.check());
}

TEST(PoleAllowance, KnowsBothPoles) {
  Case the{179.5};
  the.planned[1] = tilted(180.0);
  EXPECT_TRUE(the.check());
}

TEST(PoleAllowance, RefusesAChangeAboveWhatIsAllowed) {
  Case the;
  the.planned[2] = tilted(-0.6);
  const Status status = the.check();
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, Code::proof_failed);
  EXPECT_EQ(status.error().cl_line, 12);
}

/// sqrt(2 * 1 deg) = 10.7 deg.
TEST(PoleAllowance, RefusesAChangeFarFromThePole) {
  Case within{10.6};
  within.planned[1] = tilted(10.5);
  EXPECT_TRUE(within.check());
  Case beyond{10.8};
  beyond.planned[1] = tilted(10.7);
  EXPECT_FALSE(beyond.check());
}

TEST(PoleAllowance, RefusesAChangeWhoseMoveEndsFarFromThePole) {
  Case the;
  the.tool_path.axis_wp[2] = the.planned[2] = tilted(20.0);
  the.planned[1] = tilted(0.0);
  EXPECT_FALSE(the.check());
}

/// The first joint of a table with the second one at 45 deg to it and to the tool: no pole below.
TEST(PoleAllowance, RefusesAPoleThatTheMachineDoesNotReach) {
  Case the{179.5};
  the.model.b = Vec3{0.0, 1.0, 1.0}.normalized();
  the.planned[1] = tilted(180.0);
  EXPECT_FALSE(the.check());
}

TEST(PoleAllowance, RefusesRapidsArcsAndEnds) {
  Case rapid;
  rapid.tool_path.move[2] = path::Move::rapid;
  rapid.planned[1] = tilted(0.0);
  EXPECT_FALSE(rapid.check());
  Case arc;
  arc.tool_path.events.push_back({1, 11, path::Arc{.sweep_rad = 1.0}});
  arc.planned[1] = tilted(0.0);
  EXPECT_FALSE(arc.check());
  Case end;
  end.planned[3] = tilted(0.0);
  EXPECT_FALSE(end.check());
}

TEST(PoleAllowance, RefusesNoNumbersAndMissingAxes) {
  Case not_a_number;
  not_a_number.planned[1].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(not_a_number.check());
  Case allowance;
  allowance.pole_axis_rad = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(allowance.check());
  Case missing;
  missing.planned.pop_back();
  EXPECT_FALSE(missing.check());
}

/// It holds on the moves to and from a changed point only.
TEST(PoleAllowance, HoldsOnTheMovesOfAChangedPointAlone) {
  Case the;
  the.planned[1] = tilted(0.0);
  const Claim claim{.tool_path = the.tool_path,
                    .model = the.model,
                    .motion = the.motion,
                    .reader_setup = {},
                    .planned_axis_wp = the.planned};
  EXPECT_FALSE(has_changed_axis(claim, 0));
  EXPECT_TRUE(has_changed_axis(claim, 1));
  EXPECT_TRUE(has_changed_axis(claim, 2));
  EXPECT_FALSE(has_changed_axis(claim, 3));
}

}  // namespace
}  // namespace pentapost::verify
