#include "pentapost/verify/axis_columns.hpp"

#include "sample/chains.hpp"

#include <gtest/gtest.h>

namespace pentapost::verify {
namespace {

TEST(AxisColumns, PutsTheRotaryWordsInTheOrderOfTheChain) {
  const kinematics::Model model{sample::trunnion_ac()};  // C is nearest the workpiece
  const auto columns = AxisColumns::make("XYZAC", model);
  ASSERT_TRUE(columns);

  const kinematics::Joints joints = columns->joints({1, 2, 3, 90, 180});

  EXPECT_EQ(joints.linear_mm, Vec3(1, 2, 3));
  EXPECT_DOUBLE_EQ(joints.first_rad, pi);
  EXPECT_DOUBLE_EQ(joints.second_rad, pi / 2);
}

TEST(AxisColumns, ServesMachinesWithFewerRotaryAxes) {
  const auto four = AxisColumns::make("XYZA", kinematics::Model{sample::four_axis_a()});
  ASSERT_TRUE(four);
  EXPECT_EQ(four->all(), 0b1111);
  EXPECT_DOUBLE_EQ(four->joints({0, 0, 0, 90, 77}).first_rad, pi / 2);
  EXPECT_EQ(four->joints({0, 0, 0, 90, 77}).second_rad, 0.0);
  const auto three = AxisColumns::make("XYZ", kinematics::Model{sample::three_axis()});
  ASSERT_TRUE(three);
  EXPECT_EQ(three->rotary(), 0);
}

TEST(AxisColumns, RefusesLettersThatAreNotTheMachines) {
  const kinematics::Model model{sample::trunnion_ac()};
  for (const char* letters : {"", "XYZ", "XYZAB", "XYZCC", "XZYAC", "XYZACB"})
    EXPECT_FALSE(AxisColumns::make(letters, model)) << letters;
}

TEST(AxisColumns, FindsALetter) {
  const auto columns = AxisColumns::make("XYZA", kinematics::Model{sample::four_axis_a()});
  ASSERT_TRUE(columns);
  EXPECT_EQ(columns->find('Z'), 2U);
  EXPECT_EQ(columns->find('C'), std::nullopt);
}

}  // namespace
}  // namespace pentapost::verify
