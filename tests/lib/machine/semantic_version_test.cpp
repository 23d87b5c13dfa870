#include "pentapost/machine/semantic_version.hpp"

#include <gtest/gtest.h>

namespace pentapost::machine {
namespace {

TEST(SemanticVersion, ReadsThreeNumbers) {
  const auto version = semantic_version("1.20.300");

  ASSERT_TRUE(version);
  EXPECT_EQ(*version, (SemanticVersion{1, 20, 300}));
}

TEST(SemanticVersion, OrdersByNumberAndNotByText) {
  EXPECT_LT(*semantic_version("1.9.0"), *semantic_version("1.10.0"));
  EXPECT_LT(*semantic_version("9.9.9"), *semantic_version("10.0.0"));
  EXPECT_LT(*semantic_version("1.0.9"), *semantic_version("1.0.10"));
}

TEST(SemanticVersion, RefusesWhatIsNone) {
  for (const auto* text : {"", "1", "1.0", "1.0.0.0", "1.0.", ".0.0", "1..0", "01.0.0", "1.0.0-rc1",
                           "v1.0.0", "1.0.x", " 1.0.0", "1.0.0 ", "-1.0.0", "1.0.1234567890"})
    EXPECT_FALSE(semantic_version(text)) << text;
}

TEST(SemanticVersion, TakesZeroAndNineDigits) {
  EXPECT_TRUE(semantic_version("0.0.0"));
  EXPECT_EQ(semantic_version("999999999.0.0")->major, 999'999'999u);
}

}  // namespace
}  // namespace pentapost::machine
