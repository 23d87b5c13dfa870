#include "lib/kinematics/hard_chains.hpp"
#include "pentapost/kinematics/forward.hpp"

#include <gtest/gtest.h>
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/frames.hpp>

#include <random>
#include <span>

namespace pentapost::kinematics {
namespace {

KDL::Vector kdl(const Vec3& vector) { return {vector.x(), vector.y(), vector.z()}; }
Vec3 eigen(const KDL::Vector& vector) { return {vector.x(), vector.y(), vector.z()}; }

KDL::Segment segment(const machine::Joint& joint) {
  if (const auto* turning = std::get_if<machine::RotaryJoint>(&joint.kind))
    return KDL::Segment{
        KDL::Joint{kdl(turning->point_mm), kdl(turning->direction.vec()), KDL::Joint::RotAxis}};
  const Vec3 direction = std::get<machine::LinearJoint>(joint.kind).direction.vec();
  return KDL::Segment{KDL::Joint{KDL::Vector::Zero(), kdl(direction), KDL::Joint::TransAxis}};
}

double value_of(const Model& model, const Joints& joints, const std::string& name) {
  for (std::size_t i = 0; i < 3; ++i)
    if (model.linear_names[i] == name) return joints.linear_mm[static_cast<Eigen::Index>(i)];
  return name == model.rotary_names[0] ? joints.first_rad : joints.second_rad;
}

/// Frame of what the joints carry, in the base frame; joints counted from the base.
KDL::Frame carried(const std::vector<machine::Joint>& from_base, const Model& model,
                   const Joints& joints) {
  KDL::Chain chain;
  KDL::JntArray values{static_cast<unsigned>(from_base.size())};
  for (std::size_t i = 0; i < from_base.size(); ++i) {
    chain.addSegment(segment(from_base[i]));
    values(static_cast<unsigned>(i)) = value_of(model, joints, from_base[i].name);
  }
  KDL::Frame frame = KDL::Frame::Identity();
  if (!from_base.empty()) KDL::ChainFkSolverPos_recursive{chain}.JntToCart(values, frame);
  return frame;
}

/// By the definition: workpiece and tool each carried from the base with directions as given.
Pose by_kdl(const machine::Chain& chain, const Model& model, const Joints& joints,
            double gauge_length_mm) {
  const std::vector<machine::Joint> table{chain.table().rbegin(), chain.table().rend()};
  const std::vector<machine::Joint> head{chain.head().begin(), chain.head().end()};
  const KDL::Frame wp_tool = carried(table, model, joints).Inverse() * carried(head, model, joints);
  const Vec3 tool_axis = chain.tool_axis().vec();
  return {eigen(wp_tool * kdl(-gauge_length_mm * tool_axis)), eigen(wp_tool.M * kdl(tool_axis))};
}

class ForwardAgainstOrocosKdl : public ::testing::TestWithParam<sample::NamedChain> {};

TEST_P(ForwardAgainstOrocosKdl, Agrees) {
  const Model model{GetParam().chain};
  std::mt19937_64 random{42};
  std::uniform_real_distribution<double> turn_rad{-2 * pi, 2 * pi};
  std::uniform_real_distribution<double> travel_mm{-600.0, 600.0}, gauge_mm{0.0, 300.0};
  for (int i = 0; i < 2000; ++i) {
    const Joints joints{{travel_mm(random), travel_mm(random), travel_mm(random)},
                        turn_rad(random),
                        turn_rad(random)};
    const double gauge_length_mm = gauge_mm(random);

    const Pose found = forward(model, joints, gauge_length_mm);

    const Pose expected = by_kdl(GetParam().chain, model, joints, gauge_length_mm);
    ASSERT_LT((found.tip_mm - expected.tip_mm).norm(), 1e-9) << i;
    ASSERT_LT((found.axis - expected.axis).norm(), 1e-13) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(, ForwardAgainstOrocosKdl, ::testing::ValuesIn(sample::all_chains()),
                         sample::name_of_chain);

}  // namespace
}  // namespace pentapost::kinematics
