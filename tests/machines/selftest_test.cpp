// What every bundled machine must show: forward of inverse over its whole reach, and its singular
// tool axes where the mathematics puts them (lib/README.md sections 2 and 3).

#include "machines/bundled.hpp"
#include "pentapost/core/units.hpp"
#include "pentapost/kinematics/forward.hpp"
#include "pentapost/kinematics/inverse.hpp"
#include "pentapost/kinematics/singularity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <variant>
#include <vector>

namespace pentapost {
namespace {

using kinematics::Joints;
using kinematics::Model;
using kinematics::Singularity;
using kinematics::SingularityKind;

constexpr int poses = PENTAPOST_POSES;       ///< per machine
constexpr int poses_per_place = poses / 50;  ///< near each singularity and distance
constexpr int sphere_axes = poses / 10;      ///< tool axes over the whole sphere, per machine
constexpr double tip_tolerance_mm = 1e-9;
constexpr double axis_tolerance = 1e-13;
constexpr double gauge_length_mm = 143.7;

class MachineSelfTest : public ::testing::TestWithParam<sample::BundledMachine> {
 protected:
  MachineSelfTest() : chain_{GetParam().definition.chain}, model_{chain_} {}

  Vec3 random_point_mm() {
    std::uniform_real_distribution<double> length_mm{-500.0, 500.0};
    return {length_mm(random_), length_mm(random_), length_mm(random_)};
  }
  Vec3 random_axis() {
    std::normal_distribution<double> normal;
    return Vec3{normal(random_), normal(random_), normal(random_)}.normalized();
  }
  /// A value within the joint's range, or within one turn of an endless one.
  double random_value(const std::string& letter) {
    double lower = -pi, upper = pi;
    const auto look_at = [&](const machine::Joint& joint) {
      const auto* const turning = std::get_if<machine::RotaryJoint>(&joint.kind);
      if (joint.name != letter || turning == nullptr || !turning->range) return;
      lower = std::max(turning->range->lower.rad(), -2.0 * pi);
      upper = std::min(turning->range->upper.rad(), 2.0 * pi);
    };
    for (const auto& joint : chain_.table()) look_at(joint);
    for (const auto& joint : chain_.head()) look_at(joint);
    return std::uniform_real_distribution<double>{lower, upper}(random_);
  }
  Joints random_joints() {
    Joints joints{.linear_mm = random_point_mm()};
    if (model_.rotary_count > 0) joints.first_rad = random_value(model_.rotary_names[0]);
    if (model_.rotary_count > 1) joints.second_rad = random_value(model_.rotary_names[1]);
    return joints;
  }

  /// Whether every solution for the pose leads back to it; says so otherwise.
  ::testing::AssertionResult comes_back(const Vec3& tip_mm, const Vec3& axis) {
    const auto found = kinematics::inverse_rotary(model_, axis);
    if (found.count == 0)
      return ::testing::AssertionFailure() << "out of reach: " << axis.transpose();
    for (int i = 0; i < found.count; ++i) {
      const auto& branch = found.branch[static_cast<std::size_t>(i)];
      const auto linear_mm = kinematics::inverse_linear(model_, tip_mm, branch.first_rad,
                                                        branch.second_rad, gauge_length_mm);
      if (!linear_mm) return ::testing::AssertionFailure() << "no linear solution";
      const auto pose = kinematics::forward(
          model_,
          {.linear_mm = *linear_mm, .first_rad = branch.first_rad, .second_rad = branch.second_rad},
          gauge_length_mm);
      const double tip_error_mm = (pose.tip_mm - tip_mm).norm();
      const double axis_error = (pose.axis - axis).norm();
      if (!(tip_error_mm <= tip_tolerance_mm) || !(axis_error <= axis_tolerance))
        return ::testing::AssertionFailure() << "tip " << tip_error_mm << " mm, axis " << axis_error
                                             << " off at " << axis.transpose();
    }
    return ::testing::AssertionSuccess();
  }

  /// Directions of the rotary joints as a tool that moves in the workpiece frame sees them, nearest
  /// the workpiece first; from the definition and not from the model.
  std::vector<Vec3> rotary_directions() const {
    std::vector<Vec3> directions;
    for (const auto& joint : chain_.table())
      if (const auto* const turning = std::get_if<machine::RotaryJoint>(&joint.kind))
        directions.push_back(-turning->direction.vec());
    for (const auto& joint : chain_.head())
      if (const auto* const turning = std::get_if<machine::RotaryJoint>(&joint.kind))
        directions.push_back(turning->direction.vec());
    return directions;
  }

  /// The angles to the first rotary axis between which tool axes are reachable: every point of the
  /// circle that the tool axis describes about the second one, which is at `lambda` to the first.
  struct Reach {
    double from_rad, to_rad;
  };
  Reach reach() const {
    const auto directions = rotary_directions();
    const double lambda = angle_between_rad(directions[0], directions[1]);
    const double mu = angle_between_rad(directions[1], chain_.tool_axis().vec());
    return {std::abs(lambda - mu), std::min(lambda + mu, 2.0 * pi - lambda - mu)};
  }

  /// Whether the rotary axes and the tool axis are inclined by 45 deg; otherwise by 90.
  bool is_nutating_45() const { return std::abs(reach().to_rad - pi / 2.0) < 1e-9; }

  /// A tool axis at `gamma_rad` to the first rotary axis.
  Vec3 axis_at(double gamma_rad) {
    const Vec3 a = rotary_directions()[0];
    Vec3 across = a.cross(random_axis());
    while (across.norm() < 0.01) across = a.cross(random_axis());
    return (std::cos(gamma_rad) * a + std::sin(gamma_rad) * across.normalized()).normalized();
  }

  machine::Chain chain_;
  Model model_;
  std::mt19937_64 random_{42};
};

TEST_P(MachineSelfTest, ForwardIsTheProductOfItsJointMotions) {
  for (int i = 0; i < 10'000; ++i) {
    const Joints joints = random_joints();
    sample::JointValues values{{model_.rotary_names[0], joints.first_rad},
                               {model_.rotary_names[1], joints.second_rad}};
    for (std::size_t k = 0; k < 3; ++k)
      values[model_.linear_names[k]] = joints.linear_mm[static_cast<Eigen::Index>(k)];

    const auto pose = kinematics::forward(model_, joints, gauge_length_mm);
    const auto truth = sample::pose_by_definition(chain_, values, gauge_length_mm);

    ASSERT_LT((pose.tip_mm - truth.tip_mm).norm(), 1e-11);
    ASSERT_LT((pose.axis - truth.axis).norm(), 1e-14);
  }
}

TEST_P(MachineSelfTest, ForwardOfInverseIsThePoseOverItsRange) {
  for (int i = 0; i < poses; ++i) {
    const auto pose = kinematics::forward(model_, random_joints(), gauge_length_mm);
    ASSERT_TRUE(comes_back(pose.tip_mm, pose.axis.normalized())) << i;
  }
}

/// Those with two rotary joints.
class FiveAxisSelfTest : public MachineSelfTest {};

TEST_P(FiveAxisSelfTest, ReachesWhatTheTriangleAllowsAndNothingElse) {
  const Vec3 a = rotary_directions()[0];
  const Reach reachable = reach();
  constexpr double clear_of_the_edge_rad = 1e-9;
  for (int i = 0; i < sphere_axes; ++i) {
    const Vec3 axis = random_axis();
    const double gamma = angle_between_rad(a, axis);
    const double inside_rad = std::min(gamma - reachable.from_rad, reachable.to_rad - gamma);
    if (inside_rad > clear_of_the_edge_rad) {
      ASSERT_TRUE(comes_back(random_point_mm(), axis)) << i;
    } else if (inside_rad < -clear_of_the_edge_rad) {
      ASSERT_EQ(kinematics::inverse_rotary(model_, axis).count, 0) << axis.transpose();
    }
  }
}

TEST_P(FiveAxisSelfTest, ForwardOfInverseIsThePoseNextToItsSingularities) {
  const Reach reachable = reach();
  for (const double distance_rad : {0.0, 1e-15, 1e-12, 1e-9, 1e-8, 1e-6, 1e-3}) {
    SCOPED_TRACE(distance_rad);
    for (int i = 0; i < poses_per_place; ++i) {
      ASSERT_TRUE(comes_back(random_point_mm(), axis_at(reachable.from_rad + distance_rad)));
      ASSERT_TRUE(comes_back(random_point_mm(), axis_at(reachable.to_rad - distance_rad)));
    }
  }
}

// Every bundled machine has its tool axis at the angle of its rotary axes: at right angles, both
// directions of the first rotary axis are poles; at 45 deg, +z is one and the horizon the boundary.
TEST_P(FiveAxisSelfTest, HasItsSingularSetWhereTheMathematicsPutsIt) {
  const auto found = kinematics::singularities(model_);
  const Vec3 a = rotary_directions()[0];
  const bool nutating = is_nutating_45();
  ASSERT_EQ(found.size(), 2u);
  const auto poles = std::count_if(found.begin(), found.end(), [](const Singularity& each) {
    return each.kind == SingularityKind::pole;
  });

  EXPECT_EQ(poles, nutating ? 1 : 2);
  EXPECT_NEAR(kinematics::nearest_singularity(found, a)->distance_rad, 0.0, 1e-12);
  for (int i = 0; i < 100; ++i) {
    const double gamma = pi * (i + 0.5) / 100.0;
    const double to_far_end = nutating ? std::abs(pi / 2.0 - gamma) : pi - gamma;
    EXPECT_NEAR(kinematics::nearest_singularity(found, axis_at(gamma))->distance_rad,
                std::min(gamma, to_far_end), 1e-12);
  }
}

// |[a, o, b']| = sin(lambda) sin(mu) |sin B|: at right angles |sin gamma|; at 45 deg, where
// K = cos(gamma) = (1 + cos B) / 2, it is sqrt(K (1 - K)).
TEST_P(FiveAxisSelfTest, HasADeterminantThatVanishesOnItsSingularSetOnly) {
  const auto directions = rotary_directions();
  const bool nutating = is_nutating_45();
  for (int i = 0; i < sphere_axes; ++i) {
    const Vec3 axis = random_axis();
    const auto solutions = kinematics::inverse_rotary(model_, axis);
    const double k = directions[0].dot(axis);
    const double expected =
        nutating ? std::sqrt(std::max(0.0, k * (1.0 - k))) : directions[0].cross(axis).norm();
    for (int n = 0; n < solutions.count; ++n) {
      const double first_rad = solutions.branch[static_cast<std::size_t>(n)].first_rad;
      const Vec3 b = Eigen::AngleAxisd{first_rad, directions[0]} * directions[1];
      ASSERT_NEAR(std::abs(directions[0].dot(axis.cross(b))), expected, 1e-10) << axis.transpose();
    }
  }
}

/// Those with fewer.
class FewAxesSelfTest : public MachineSelfTest {};

TEST_P(FewAxesSelfTest, HasNoSingularToolAxes) {
  EXPECT_TRUE(kinematics::singularities(model_).empty());
}

TEST_P(FewAxesSelfTest, ReachesOnlyToolAxesAtTheAngleOfItsRotaryAxis) {
  for (int i = 0; i < 1000; ++i)
    ASSERT_EQ(kinematics::inverse_rotary(model_, random_axis()).count, 0);
  EXPECT_TRUE(comes_back(random_point_mm(), chain_.tool_axis().vec()));
}

std::string test_name(const ::testing::TestParamInfo<sample::BundledMachine>& info) {
  std::string name = info.param.definition.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

std::vector<sample::BundledMachine> machines_where(bool five_axis) {
  auto machines = sample::bundled_machines();
  std::erase_if(machines, [&](const auto& machine) {
    return (machine.definition.chain.rotary_count() == 2) != five_axis;
  });
  return machines;
}

INSTANTIATE_TEST_SUITE_P(, MachineSelfTest, ::testing::ValuesIn(sample::bundled_machines()),
                         test_name);
INSTANTIATE_TEST_SUITE_P(, FiveAxisSelfTest, ::testing::ValuesIn(machines_where(true)), test_name);
INSTANTIATE_TEST_SUITE_P(, FewAxesSelfTest, ::testing::ValuesIn(machines_where(false)), test_name);

}  // namespace
}  // namespace pentapost
