#include "pentapost/nc/axis_words.hpp"
#include "pentapost/nc/plain_text.hpp"
#include "pentapost/nc/words.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

namespace pentapost::nc {
namespace {

TEST(WordsWriter, RoundsFeedsDown) {
  EXPECT_EQ(feed_count(1999.999, 0), 1999);
  EXPECT_EQ(feed_count(1999.999, 2), 199999);
  EXPECT_EQ(feed_count(0.3, 1), 3);  // 0.3 * 10 is 3 in double as well
  EXPECT_EQ(feed_count(0.29999, 1), 2);
  EXPECT_EQ(feed_count(1.1, 3), 1100);  // 1.1 * 1000 is 1100.0000000000002
  EXPECT_EQ(feed_count(4.35, 2), 435);  // 4.35 * 100 is 434.99999999999994
}

TEST(WordsWriter, NeverRoundsAFeedToZero) {
  EXPECT_EQ(feed_count(1e-300, 0), 1);
  EXPECT_EQ(feed_count(0.0009, 3), 1);
}

TEST(WordsWriter, FindsFeedsThatAreNone) {
  EXPECT_EQ(feed_count(0.0, 0), std::nullopt);
  EXPECT_EQ(feed_count(-5.0, 0), std::nullopt);
  EXPECT_EQ(feed_count(std::nan(""), 0), std::nullopt);
  EXPECT_EQ(feed_count(std::numeric_limits<double>::infinity(), 0), std::nullopt);
  EXPECT_EQ(feed_count(1e9, 0), std::nullopt);
  EXPECT_EQ(feed_count(999'999'999.0, 3), 999'999'999'000);
}

TEST(WordsWriter, NeverTellsTheControlToBeFaster) {
  std::mt19937_64 random{42};
  std::uniform_real_distribution<double> exponent{-3.0, 6.0};
  for (int i = 0; i < 100'000; ++i) {
    const double feed = std::pow(10.0, exponent(random));
    const auto count = feed_count(feed, 3);
    ASSERT_TRUE(count);
    ASSERT_LE(static_cast<double>(*count) * 1e-3, std::max(feed * (1.0 + 1e-11), 1e-3)) << feed;
    ASSERT_GT(static_cast<double>(*count) * 1e-3, feed - 1.001e-3) << feed;
  }
}

TEST(WordsWriter, RoundsTimesAndSpeedsToTheNearest) {
  EXPECT_EQ(nearest_count(0.0015, 3), 2);
  EXPECT_EQ(nearest_count(799.5, 0), 800);
  EXPECT_EQ(nearest_count(0.0, 0), 0);
  EXPECT_EQ(nearest_count(-0.1, 0), std::nullopt);
  EXPECT_EQ(nearest_count(std::nan(""), 0), std::nullopt);
}

TEST(WordsWriter, RefusesLettersThatAreNoColumns) {
  for (const std::string letters : {"", "XY", "XYZABC", "XYX", "xyz", "XY1", "XYZCC"}) {
    path::Motion motion;
    motion.letters = letters;
    EXPECT_THROW((WordColumns{motion, 5}), std::logic_error) << letters;
  }
}

TEST(WordsWriter, OrdersParallelAndRotaryAxes) {
  path::Motion motion;
  motion.letters = "WYXCB";
  const WordColumns columns{motion, 5};

  std::string order;
  for (const std::size_t column : columns) order += columns.letter(column);

  EXPECT_EQ(order, "XYWBC");
  EXPECT_EQ(columns.find('W'), 0u);
  EXPECT_EQ(columns.find('Z'), WordColumns::none);
}

TEST(WordsWriter, KnowsTheLargestWord) {
  path::Motion motion;
  motion.letters = "XYZAC";
  const WordColumns columns{motion, 5};

  EXPECT_TRUE(columns.fits(0, 99'999'999));
  EXPECT_TRUE(columns.fits(0, -99'999'999));
  EXPECT_FALSE(columns.fits(0, 100'000'000));
  EXPECT_FALSE(columns.fits(0, -100'000'000));
}

TEST(PlainTextWriter, SpellsAccentedLettersPlainly) {
  EXPECT_EQ(printable_ascii("\xC3\x84\xC3\xB6\xC3\x9F\xC3\xA9\xC3\xB1"), "Aeoessen");
  EXPECT_EQ(printable_ascii("\xC3\x98\xC3\xB8\xC3\x97"), "Oox");
}

TEST(PlainTextWriter, MakesOneMarkOfEachOtherCharacter) {
  EXPECT_EQ(printable_ascii("\xE2\x82\xAC|\xF0\x9F\x98\x80|\xCE\xB1"), "?|?|?");
}

TEST(PlainTextWriter, SurvivesDamagedUtf8) {
  EXPECT_EQ(printable_ascii("\xC3"), "?");
  EXPECT_EQ(printable_ascii("\xC3(\xFF\x80"), "?(?");
  EXPECT_EQ(printable_ascii(std::string_view{"a\0b\x7F", 4}), "a b ");
}

TEST(PlainTextWriter, CutsWordsThatAreTooLong) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(comment_lines("abcdefgh ij", "", 4), (Lines{"abcd", "efgh", "ij"}));
  EXPECT_EQ(comment_lines("ab cd ef", "", 5), (Lines{"ab cd", "ef"}));
  EXPECT_EQ(comment_lines("   ", "", 5), Lines{});
  EXPECT_EQ(comment_lines("(a)", "()", 5), Lines{"a"});
}

TEST(PlainTextWriter, FillsPlaceholdersOnce) {
  EXPECT_EQ(filled("T{tool} H{tool}", "{tool}", "7"), "T7 H7");
  EXPECT_EQ(filled("T{tool}", "{tool}", "{tool}"), "T{tool}");
  EXPECT_EQ(filled("T5 G17 {speed}", "{speed}", ""), "T5 G17");
}

}  // namespace
}  // namespace pentapost::nc
