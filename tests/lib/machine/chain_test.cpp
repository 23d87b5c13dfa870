#include "pentapost/machine/chain.hpp"

#include "sample/chains.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace pentapost::machine {
namespace {

using sample::linear;
using sample::rotary;

std::string refusal(std::vector<Joint> table, std::vector<Joint> head,
                    const Vec3& tool_axis = Vec3::UnitZ()) {
  const auto chain =
      Chain::make(std::move(table), std::move(head), UnitVector::normalised(tool_axis));
  if (chain) return "accepted";
  EXPECT_EQ(chain.error().code, Code::chain_shape);
  return chain.error().message;
}

TEST(Chain, KeepsTheJointsInTheirOrder) {
  const Chain chain = sample::nutating_head();

  ASSERT_EQ(chain.table().size(), 2u);
  ASSERT_EQ(chain.head().size(), 3u);
  EXPECT_EQ(chain.table()[0].name, "C");
  EXPECT_EQ(chain.table()[1].name, "Y");
  EXPECT_EQ(chain.head()[2].name, "B");
}

TEST(Chain, CountsRotaryJoints) {
  EXPECT_EQ(sample::three_axis().rotary_count(), 0);
  EXPECT_EQ(sample::four_axis_a().rotary_count(), 1);
  EXPECT_EQ(sample::swivel_head().rotary_count(), 2);
}

TEST(Chain, TellsWhetherTheHeadTurns) {
  EXPECT_FALSE(sample::trunnion_ac().head_turns());
  EXPECT_TRUE(sample::swivel_head().head_turns());
  EXPECT_TRUE(sample::bridge_head_cb().head_turns());
  EXPECT_FALSE(sample::three_axis().head_turns());
}

TEST(Chain, RefusesTwoLinearJoints) {
  EXPECT_EQ(refusal({}, {sample::x(), sample::y()}), "the chain has 2 linear joints; 3 are needed");
}

TEST(Chain, RefusesFourLinearJoints) {
  EXPECT_EQ(refusal({}, {sample::x(), sample::y(), sample::z(), linear("W", Vec3::UnitZ())}),
            "the chain has 4 linear joints; 3 are needed");
}

TEST(Chain, RefusesLinearJointsInOnePlane) {
  const auto message = refusal({}, {sample::x(), sample::y(), linear("Z", {1, 1, 0})});

  EXPECT_NE(message.find("do not span space"), std::string::npos) << message;
}

TEST(Chain, RefusesThreeRotaryJoints) {
  EXPECT_EQ(refusal({rotary("A", Vec3::UnitX()), rotary("B", Vec3::UnitY())},
                    {sample::x(), sample::y(), sample::z(), rotary("C", Vec3::UnitZ())}),
            "the chain has 3 rotary joints; at most 2 are possible");
}

TEST(Chain, RefusesParallelRotaryJointsWhateverTheirSense) {
  EXPECT_EQ(refusal({rotary("C", Vec3::UnitX()), rotary("A", -Vec3::UnitX())},
                    {sample::x(), sample::y(), sample::z()}),
            "the two rotary axes are parallel");
}

TEST(Chain, RefusesASecondRotaryJointAlongTheTool) {
  EXPECT_EQ(refusal({rotary("A", Vec3::UnitX())},
                    {sample::x(), sample::y(), sample::z(), rotary("C", Vec3::UnitZ())}),
            "the rotary axis nearest the tool is parallel to the tool axis");
}

TEST(Chain, TakesAFirstRotaryJointAlongTheTool) {
  EXPECT_EQ(refusal({rotary("C", Vec3::UnitZ()), rotary("A", Vec3::UnitX())},
                    {sample::x(), sample::y(), sample::z()}),
            "accepted");
}

TEST(Chain, TakesASingleRotaryJointAlongTheTool) {
  EXPECT_EQ(refusal({rotary("C", Vec3::UnitZ())}, {sample::x(), sample::y(), sample::z()}),
            "accepted");
}

// Sines of 1e-6 are the limit; one half and two of them lie on either side.
TEST(Chain, RefusesNearlyParallelRotaryJointsOnly) {
  const auto with_angle = [](double angle_rad) {
    return refusal({rotary("C", Vec3{std::cos(angle_rad), std::sin(angle_rad), 0}),
                    rotary("A", Vec3::UnitX())},
                   {sample::x(), sample::y(), sample::z()});
  };

  EXPECT_EQ(with_angle(0.5e-6), "the two rotary axes are parallel");
  EXPECT_EQ(with_angle(2e-6), "accepted");
}

TEST(Chain, RefusesANameTwice) {
  EXPECT_EQ(refusal({rotary("X", Vec3::UnitX())}, {sample::x(), sample::y(), sample::z()}),
            "the chain names the joint X twice");
}

TEST(SampleChains, HaveDifferentNames) {
  std::vector<std::string> names;
  for (const auto& each : sample::chains()) names.push_back(each.name);
  std::sort(names.begin(), names.end());

  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

TEST(SampleChains, AreTheSameForTheSameSeed) {
  const auto once = sample::random_chains(3, 7);
  const auto again = sample::random_chains(3, 7);

  for (std::size_t i = 0; i < once.size(); ++i)
    EXPECT_EQ(once[i].chain.tool_axis().vec(), again[i].chain.tool_axis().vec());
}

}  // namespace
}  // namespace pentapost::machine
