#include "pentapost/machine/near_names.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pentapost::machine {
namespace {

using Names = std::vector<std::string>;

const Names machines{"dmu-50-evolution", "dmu-70-evo",  "dmu-80-monoblock", "haas-umc-750",
                     "hermle-c600u",     "huron-kx100", "makino-mag3"};

TEST(NearNames, OffersWhatALetterWasLeftOutOf) {
  EXPECT_EQ(near_names("hermle-c60u", machines), Names{"hermle-c600u"});
}

TEST(NearNames, OffersWhatNeighboursWereExchangedIn) {
  EXPECT_EQ(near_names("ab", Names{"ba", "xy"}), Names{"ba"});
}

TEST(NearNames, IgnoresCase) {
  EXPECT_EQ(near_names("HERMLE-C600U", machines), Names{"hermle-c600u"});
}

TEST(NearNames, OffersWhatContainsTheName) {
  EXPECT_EQ(near_names("umc", machines), Names{"haas-umc-750"});
}

TEST(NearNames, PutsTheNearestFirst) {
  EXPECT_EQ(near_names("dmu-70-ev", machines).front(), "dmu-70-evo");
}

TEST(NearNames, OffersNothingForANameOfItsOwn) {
  EXPECT_TRUE(near_names("pocket-nc-v2", machines).empty());
  EXPECT_TRUE(near_names("", machines).empty());
}

TEST(NearNames, OffersAtMostThree) {
  EXPECT_EQ(near_names("axis", Names{"axis1", "axis2", "axis3", "axis4"}),
            (Names{"axis1", "axis2", "axis3"}));
}

TEST(NearNames, ComparesNoEndlessTexts) {
  EXPECT_TRUE(near_names(std::string(10'000'000, 'x'), machines).empty());
}

}  // namespace
}  // namespace pentapost::machine
