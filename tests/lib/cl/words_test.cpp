#include "pentapost/cl/words.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <optional>
#include <random>
#include <string>
#include <utility>

namespace pentapost::cl {
namespace {

Decimal decimal(std::string_view text) {
  return read_decimal(text.data(), text.data() + text.size());
}

TEST(ReadDecimal, ReadsAllFormsOfApt) {
  const std::pair<const char*, double> cases[] = {
      {"5.", 5.0},     {".25", 0.25},    {"-.5", -0.5},      {"+3", 3.0},
      {"0", 0.0},      {"1.E-3", 0.001}, {"1.5D+02", 150.0}, {"1e2", 100.0},
      {"-0.000", 0.0}, {"12", 12.0},     {"-7.25", -7.25},   {"0012.50", 12.5}};
  for (const auto& [text, value] : cases) {
    SCOPED_TRACE(text);
    EXPECT_EQ(decimal(text).state, Decimal::State::number);
    EXPECT_EQ(decimal(text).value, value);
    EXPECT_EQ(decimal(text).next, text + std::string_view{text}.size());
  }
}

TEST(ReadDecimal, NeverGivesMinusZero) { EXPECT_FALSE(std::signbit(decimal("-0.000").value)); }

TEST(ReadDecimal, CountsDecimals) {
  EXPECT_EQ(decimal("1").decimals, 0);
  EXPECT_EQ(decimal("1.").decimals, 0);
  EXPECT_EQ(decimal("0.1234567").decimals, 7);
  EXPECT_EQ(decimal("1.5E-3").decimals, 4);
  EXPECT_EQ(decimal("1.5E+3").decimals, 0);
}

TEST(ReadDecimal, IsCorrectlyRounded) {
  std::mt19937_64 random{42};
  for (int i = 0; i < 100'000; ++i) {
    std::string text = std::to_string(random() % 1'000'000) + "." + std::to_string(random());
    if (i % 3 == 0) text = "-" + text;
    ASSERT_EQ(decimal(text).value, std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(ReadDecimal, TellsWhatIsNotFiniteFromWhatIsNoNumber) {
  for (const char* text : {"NAN", "nan", "-inf", "1E999", "Infinity"})
    EXPECT_EQ(decimal(text).state, Decimal::State::not_finite) << text;
  for (const char* text : {"", "-", ".", "X1", "- 1", "--1"})
    EXPECT_EQ(decimal(text).state, Decimal::State::not_a_number) << text;
}

TEST(ReadCoordinates, PartsNumbersByCommasAndBlanks) {
  const Coordinates found = read_coordinates(" 1.5 , -2 3.25,");
  EXPECT_EQ(found.fault, Coordinates::Fault::none);
  ASSERT_EQ(found.count, 3U);
  EXPECT_EQ(found.value[0], 1.5);
  EXPECT_EQ(found.value[1], -2.0);
  EXPECT_EQ(found.value[2], 3.25);
}

TEST(ReadCoordinates, CountsADecimalCommaAsTwoNumbers) {
  EXPECT_EQ(read_coordinates("0.0, 0.0, 90,2364, 0.0, 0.0, 1.0").count, 7U);
}

TEST(ReadCoordinates, RefusesWhatIsNoNumber) {
  for (const char* text : {"1,,2", ",1,2", "1,2,X", "5.000. 1", "1,2,- 3", "1;2"})
    EXPECT_EQ(read_coordinates(text).fault, Coordinates::Fault::not_a_number) << text;
}

TEST(ReadCoordinates, KeepsTheMostDecimals) {
  const Coordinates found = read_coordinates("1.5,2.25,3,0.1234567,0.5,1");
  EXPECT_EQ(found.tip_decimals, 2);
  EXPECT_EQ(found.axis_decimals, 7);
}

TEST(Words, DivideGluedNumbersAndWords) {
  Words words;
  words.read("900CCLW");
  ASSERT_EQ(words.size(), 2U);
  EXPECT_EQ(words[0].number, 900.0);
  EXPECT_TRUE(words[1].is("CCLW"));
}

TEST(Words, KeepAWordThatStartsWithADigit) {
  Words words;
  words.read("1STPECK,2.5");
  ASSERT_EQ(words.size(), 2U);
  EXPECT_TRUE(words[0].is("1STPECK"));
}

TEST(Words, SeeADamagedNumber) {
  Words words;
  words.read(" 5.000000. MMPM");
  EXPECT_TRUE(words.has_damage());
}

TEST(Words, KeepQuotedTextWhole) {
  Words words;
  words.read("'END MILL, 10',3");
  ASSERT_EQ(words.size(), 2U);
  EXPECT_EQ(words[0].text, "END MILL, 10");
}

TEST(Words, KnowWhatIsGluedToANumber) {
  Words words;
  words.read("1O 1,O");
  ASSERT_EQ(words.size(), 4U);
  EXPECT_TRUE(words[1].is_glued_to(words[0]));
  EXPECT_FALSE(words[3].is_glued_to(words[2]));
}

TEST(MatchForm, TakesTheNumberThatNoWordTakes) {
  constexpr std::array known{MinorWord{"RPM"}, MinorWord{"RANGE", Takes::number_or_gear},
                             MinorWord{"MAXRPM", Takes::number},
                             MinorWord{"ORIENT", Takes::number_if_there}};
  const std::pair<const char*, std::optional<double>> cases[] = {{"RPM,5", 5.0},
                                                                 {"RANGE,LOW,5", 5.0},
                                                                 {"range,2,5", 5.0},
                                                                 {"MAXRPM,9,5,ORIENT", 5.0},
                                                                 {"ORIENT,9", {}},
                                                                 {"5,ORIENT,9", 5.0},
                                                                 {"", {}}};
  for (const auto& [text, number] : cases) {
    Words words;
    words.read(text);
    const FormMatch match = match_form(words, known);
    EXPECT_EQ(match.fault, "") << text;
    EXPECT_EQ(match.number, number) << text;
  }
}

TEST(MatchForm, NamesWhatDoesNotBelong) {
  constexpr std::array known{MinorWord{"MAXRPM", Takes::number},
                             MinorWord{"LOCK", Takes::on_or_off}};
  const std::pair<const char*, const char*> cases[] = {
      {"5,6", "a second number, \"6\""},
      {"5O", "\"O\""},
      {"5,MAXRPM", "\"MAXRPM\" without its value"},
      {"MAXRPM,LOCK,5", "\"MAXRPM\" without its value"},
      {"LOCK,5", "\"LOCK\" without its value"},
      {"5.5.5", "\"5.5.5\""},
      {"'5'", "\"5\""}};
  for (const auto& [text, fault] : cases) {
    Words words;
    words.read(text);
    const FormMatch match = match_form(words, known);
    EXPECT_EQ(match.fault, fault) << text;
    EXPECT_EQ(match.number, std::nullopt) << text;
  }
}

TEST(MatchForm, RefusesWhatWasCutOff) {
  constexpr std::array known{MinorWord{"ON"}};
  std::string text;
  for (std::size_t i = 0; i <= Words::max_words; ++i) text += "ON,";
  Words words;
  words.read(text);
  EXPECT_EQ(match_form(words, known).fault, "too many words");
}

TEST(ReadMajor, ReadsAnyCaseAndBlanksBeforeTheSlash) {
  const Major major = read_major("from  /  1,2");
  EXPECT_EQ(major.word(), "FROM");
  EXPECT_TRUE(major.slash);
  EXPECT_EQ(major.rest, "1,2");
}

TEST(ReadMajor, TakesToolPathAsOneWord) {
  EXPECT_EQ(read_major("TOOL  PATH / X").word(), "TOOL PATH");
  EXPECT_EQ(read_major("TOOL/3").word(), "TOOL");
  EXPECT_FALSE(read_major("Tool Path Listing has 81 lines.").slash);
}

TEST(QuotedExcerpt, IsShortAndAscii) {
  EXPECT_EQ(quoted_excerpt("a\tb\xC3"), "\"a b?\"");
  EXPECT_EQ(quoted_excerpt(std::string(100, 'x')), "\"" + std::string(80, 'x') + "...\"");
}

}  // namespace
}  // namespace pentapost::cl
