#include "lib/nc/read_items.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace {

using namespace pentapost;

class EveryReader : public ::testing::TestWithParam<nc::Reader> {};

TEST_P(EveryReader, IsFoundByItsName) {
  ASSERT_NE(nc::find_reader(GetParam().name), nullptr);
  EXPECT_EQ(nc::find_reader(GetParam().name)->read, GetParam().read);
}

TEST_P(EveryReader, RefusesAnEmptyText) {
  EXPECT_FALSE(sample::read_items(GetParam().name, "").status.has_value());
}

TEST_P(EveryReader, RefusesTenMillionOfOneCharacter) {
  for (const char character : {'(', '%', '/', 'X', '1', ' ', '\n', ';', '*', '.', '-', 'G', '\0'}) {
    const std::string text(10'000'000, character);
    EXPECT_FALSE(sample::read_items(GetParam().name, text).status.has_value()) << character;
    EXPECT_FALSE(sample::read_items(GetParam().name, "%A G71 *\n" + text).status.has_value());
  }
}

TEST_P(EveryReader, ReadsALineOfTenMillionBlanks) {
  const std::string blanks(10'000'000, ' ');
  const std::string start = GetParam().name == "heidenhain" ? "BEGIN PGM A MM\n"
                            : GetParam().name == "heidenhain-iso"    ? "%A G71 *\n"
                                                                     : "%\n";
  const std::string end = GetParam().name == "heidenhain-iso" ? "M30 *\n" : "M30\n";
  EXPECT_TRUE(sample::read_items(GetParam().name, start + blanks + end).status.has_value());
}

TEST_P(EveryReader, SurvivesRandomWords) {
  std::mt19937_64 random{42};
  const std::string alphabet = "GGGMMXYZACIJKRFNTSHPQ0123456789012345....--++ %*;()\n\n\r/,E";
  for (int i = 0; i < 20'000; ++i) {
    std::string text = i % 2 == 0 ? "%A G71 *\nG90 G01 F5 *\n" : "%\nG90 G94 G17 G21 G1 F5.\n";
    const auto length = random() % 60;
    for (std::size_t k = 0; k < length; ++k) text += alphabet[random() % alphabet.size()];
    for (const auto& motion : sample::read_items(GetParam().name, text).motions())
      ASSERT_TRUE(std::all_of(motion.position.begin(), motion.position.end(), [](double position) {
        return std::isfinite(position);
      })) << text;
  }
}

INSTANTIATE_TEST_SUITE_P(, EveryReader,
                         ::testing::ValuesIn(nc::readers_of_dialects().begin(),
                                             nc::readers_of_dialects().end()),
                         [](const auto& param_info) {
                           std::string name{param_info.param.name};
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Readers, AreInAlphabeticalOrder) {
  const auto readers = nc::readers_of_dialects();
  for (std::size_t i = 1; i < readers.size(); ++i) EXPECT_LT(readers[i - 1].name, readers[i].name);
}

TEST(Readers, ThereIsNoneOfAnUnknownName) { EXPECT_EQ(nc::find_reader("fagor"), nullptr); }

}  // namespace
