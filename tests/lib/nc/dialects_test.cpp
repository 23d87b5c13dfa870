#include "lib/nc/writer_case.hpp"
#include "pentapost/nc/dialect.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace pentapost {
namespace {

using sample::MotionCase;

TEST(Dialects, AreInTheOrderOfTheirNames) {
  EXPECT_TRUE(std::ranges::is_sorted(nc::dialects(), {}, [](const auto* d) { return d->name; }));
}

TEST(Dialects, AreFoundByName) {
  for (const std::string_view name : {"fanuc-30i", "heidenhain-iso", "heidenhain", "siemens-840d"}) {
    const nc::Dialect* const dialect = nc::find_dialect(name);
    ASSERT_NE(dialect, nullptr) << name;
    EXPECT_EQ(dialect->name, name);
  }
}

TEST(Dialects, AnUnknownNameFindsNone) {
  EXPECT_EQ(nc::find_dialect("fanuc"), nullptr);
  EXPECT_EQ(nc::find_dialect(""), nullptr);
  EXPECT_EQ(nc::find_dialect("FANUC-30I"), nullptr);
}

class DialectsEach : public ::testing::TestWithParam<const nc::Dialect*> {};

TEST_P(DialectsEach, DescribesEveryOptionOnce) {
  std::set<std::string_view> names;
  for (const nc::OptionRow& row : GetParam()->options) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_FALSE(row.description.empty()) << row.name;
  }
  EXPECT_TRUE(names.contains("decimals_mm"));
}

TEST_P(DialectsEach, AcceptsItsOwnDefaultsAsOptions) {
  machine::Options options;
  for (const nc::OptionRow& row : GetParam()->options)
    options[std::string{row.name}] = row.default_value;

  const auto abilities = GetParam()->abilities(options);

  ASSERT_TRUE(abilities.has_value()) << abilities.error().message;
}

TEST_P(DialectsEach, RefusesEachOptionOfTheWrongTypeByName) {
  for (const nc::OptionRow& row : GetParam()->options) {
    machine::Options options;
    if (std::holds_alternative<bool>(row.default_value))
      options[std::string{row.name}] = std::string{"yes"};
    else
      options[std::string{row.name}] = true;

    const auto abilities = GetParam()->abilities(options);

    ASSERT_FALSE(abilities.has_value()) << row.name;
    EXPECT_EQ(abilities.error().code, Code::bad_option);
    EXPECT_NE(abilities.error().message.find(row.name), std::string::npos);
  }
}

TEST_P(DialectsEach, RefusesAnUnknownOptionAndListsTheKnownOnes) {
  const auto abilities = GetParam()->abilities({{"decimal_mm", 3.0}});

  ASSERT_FALSE(abilities.has_value());
  EXPECT_EQ(abilities.error().code, Code::bad_option);
  EXPECT_EQ(abilities.error().pointer, "/controller/options/decimal_mm");
  EXPECT_NE(abilities.error().message.find("decimal_mm"), std::string::npos);
  EXPECT_NE(abilities.error().message.find("decimals_mm, decimals_deg"), std::string::npos);
}

TEST_P(DialectsEach, EscapesAnUnknownNameInThePointer) {
  const auto abilities = GetParam()->abilities({{"a/b~c", 3.0}});

  ASSERT_FALSE(abilities.has_value());
  EXPECT_EQ(abilities.error().pointer, "/controller/options/a~1b~0c");
}

TEST_P(DialectsEach, RefusesNumbersOutsideTheirDomain) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {-1.0, 7.0, 2.5, infinity, -infinity, not_a_number}) {
    const auto abilities = GetParam()->abilities({{"decimals_mm", bad}});
    ASSERT_FALSE(abilities.has_value()) << bad;
    EXPECT_EQ(abilities.error().code, Code::bad_option);
  }
}

TEST_P(DialectsEach, RefusesALineThatWouldBecomeTwo) {
  using Lines = std::vector<std::string>;
  for (const std::string bad : {"G90\nM30", "", "G90\r", "M\xC3\xBC"}) {
    const auto abilities = GetParam()->abilities({{"start_lines", Lines{bad}}});
    ASSERT_FALSE(abilities.has_value()) << bad;
    EXPECT_EQ(abilities.error().pointer, "/controller/options/start_lines");
  }
}

TEST_P(DialectsEach, RefusesAnEmptyListWhereABlockIsNeeded) {
  for (const std::string name : {"end_lines", "safe_retract", "tcp_on", "tcp_off", "tool_change"}) {
    const auto abilities = GetParam()->abilities({{name, std::vector<std::string>{}}});
    ASSERT_FALSE(abilities.has_value()) << name;
    EXPECT_NE(abilities.error().message.find(name), std::string::npos);
  }
}

TEST_P(DialectsEach, WantsAFeedForRapidsWrittenAsLines) {
  ASSERT_FALSE(GetParam()->abilities({{"rapid_as_line", true}}).has_value());
  const auto abilities =
      GetParam()->abilities({{"rapid_as_line", true}, {"rapid_feed_mm_min", 15000.0}});
  ASSERT_TRUE(abilities.has_value());
  EXPECT_TRUE(abilities->rapid_is_straight);
  EXPECT_EQ(abilities->rapid_feed_mm_min, 15000.0);
}

TEST_P(DialectsEach, GivesTheOptionsAsAbilities) {
  const auto abilities = GetParam()->abilities({{"decimals_mm", 4.0},
                                                {"decimals_deg", 5.0},
                                                {"rotary_feed_deg_min", 720.0},
                                                {"retract_mm", 55.0},
                                                {"plunge_feed_mm_min", 250.0},
                                                {"arcs", false}});

  ASSERT_TRUE(abilities.has_value());
  EXPECT_EQ(abilities->decimals_mm, 4);
  EXPECT_EQ(abilities->decimals_deg, 5);
  EXPECT_EQ(abilities->rotary_feed_deg_min, 720.0);
  EXPECT_EQ(abilities->retract_mm, 55.0);
  EXPECT_EQ(abilities->plunge_feed_mm_min, 250.0);
  EXPECT_FALSE(abilities->arcs);
}

TEST_P(DialectsEach, WritesNothingWithABadOption) {
  const Problem problem =
      sample::refused(GetParam()->name, MotionCase{}.motion, {{"decimals_deg", 12.0}});

  EXPECT_EQ(problem.code, Code::bad_option);
  EXPECT_EQ(problem.message, "option decimals_deg: 12 is outside 0 to 6");
}

TEST_P(DialectsEach, WritesTheSameBytesTwice) {
  const auto motion = MotionCase{}.line({1, 2, 3, 4, 5}, 100.0).act(path::ProgramEnd{}).motion;

  EXPECT_EQ(sample::program(GetParam()->name, motion), sample::program(GetParam()->name, motion));
}

TEST_P(DialectsEach, KeepsWhatStandsInTheTextAlready) {
  std::string out{"before\n"};

  ASSERT_TRUE(GetParam()->write(MotionCase{}.motion, {}, {}, out).has_value());

  EXPECT_EQ(out.substr(0, 7), "before\n");
  EXPECT_GT(out.size(), 8u);
}

TEST_P(DialectsEach, RefusesAWordWithMoreDigitsThanTheControlTakes) {
  MotionCase long_word;
  long_word.next_line = 431;
  long_word.line({0, 0, 0, 0, 0}, 100.0);
  long_word.motion.blocks[0].word[4] = 9'000'000'000;

  const Problem problem = sample::refused(GetParam()->name, long_word.motion);

  EXPECT_EQ(problem.code, Code::out_of_domain);
  EXPECT_EQ(problem.cl_line, 431u);
  EXPECT_NE(problem.message.find("C = 9000000 "), std::string::npos) << problem.message;
}

TEST_P(DialectsEach, RefusesTheExtremeWords) {
  for (const std::int64_t extreme :
       {std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()}) {
    MotionCase extreme_word;
    extreme_word.line({0, 0, 0, 0, 0}, 100.0);
    extreme_word.motion.blocks[0].word[0] = extreme;
    EXPECT_EQ(sample::refused(GetParam()->name, extreme_word.motion).code, Code::out_of_domain);
  }
}

TEST_P(DialectsEach, RefusesFeedsThatNoControlTakes) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, 1e10, infinity}) {
    MotionCase one;
    one.next_line = 7;
    one.line({0, 0, 0, 0, 0}, 100.0).line({1, 0, 0, 0, 0}, bad);
    const Problem problem = sample::refused(GetParam()->name, one.motion);
    EXPECT_EQ(problem.code, Code::out_of_domain) << bad;
    EXPECT_EQ(problem.cl_line, 7u);
  }
}

TEST_P(DialectsEach, NamesTheOptionOfAMissingCoolantCode) {
  const auto through = MotionCase{}.act(path::Coolant{path::Coolant::State::through}).motion;

  const Problem problem = sample::refused(GetParam()->name, through);

  EXPECT_EQ(problem.code, Code::not_in_dialect);
  EXPECT_NE(problem.message.find("coolant_through"), std::string::npos);
}

TEST_P(DialectsEach, NeverWritesANegativeZero) {
  MotionCase tiny;
  for (const double word : {-0.0, -0.0004, 0.0004, -0.0}) tiny.line({word, 0, word, word, 0}, 10.0);

  EXPECT_EQ(sample::program(GetParam()->name, tiny.motion).find("-0"), std::string::npos);
}

TEST_P(DialectsEach, RefusesToolsThatCannotBeCalled) {
  const auto negative = MotionCase{}.act(path::ToolCall{.number = -1}).motion;

  EXPECT_EQ(sample::refused(GetParam()->name, negative).code, Code::out_of_domain);
}

TEST_P(DialectsEach, TakesActionsOutOfOrderForADefect) {
  auto motion = MotionCase{}.line({0, 0, 0, 0, 0}, 10.0).line({1, 0, 0, 0, 0}, 10.0).motion;
  motion.actions = {{1, 0, path::Stop{}}, {0, 0, path::Stop{}}};
  EXPECT_THROW(sample::program(GetParam()->name, motion), std::logic_error);
  motion.actions = {{9, 0, path::Stop{}}};
  EXPECT_THROW(sample::program(GetParam()->name, motion), std::logic_error);
}

TEST_P(DialectsEach, KeepsLineEndsInCommentsFromMakingBlocks) {
  const auto motion = MotionCase{}
                          .act(path::Comment{"harmless\nG00 X-500"})
                          .act(path::InsertedText{"M8\r\nG00 X-500"})
                          .motion;

  const std::string nc = sample::program(GetParam()->name, motion);

  EXPECT_EQ(nc.find("\nG00 X-500"), std::string::npos);
  EXPECT_NE(nc.find("M8  G00 X-500"), std::string::npos);
}

TEST_P(DialectsEach, LeavesCommentsOutWhereTheShopWantsNone) {
  const auto motion = MotionCase{}.act(path::Comment{"FINISH THE BLADE"}).motion;

  const std::string nc = sample::program(GetParam()->name, motion, {{"comments", false}});

  EXPECT_EQ(nc.find("BLADE"), std::string::npos);
  EXPECT_EQ(nc.find("UNITS"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(, DialectsEach,
                         ::testing::ValuesIn(nc::dialects().begin(), nc::dialects().end()),
                         [](const auto& param_info) {
                           std::string name{param_info.param->name};
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace pentapost
