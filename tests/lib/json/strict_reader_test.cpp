#include "pentapost/json/strict_reader.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pentapost::json {
namespace {

Document parsed(std::string_view text) { return Document::parse(text).value(); }

Problem parse_problem(std::string_view text) { return Document::parse(text).error(); }

std::string nested(std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); }

TEST(Document, NamesLineAndColumnOfWhatIsNotJson) {
  const auto problem = parse_problem("{\n  \"a\": tru\n}");

  EXPECT_EQ(problem.code, Code::bad_json);
  EXPECT_EQ(problem.pointer, "");
  EXPECT_NE(problem.message.find("line 3, column"), std::string::npos) << problem.message;
}

TEST(Document, RefusesAnEmptyText) { EXPECT_EQ(parse_problem("").code, Code::bad_json); }

TEST(Document, RefusesTextBehindTheValue) {
  EXPECT_EQ(parse_problem("{} {}").code, Code::bad_json);
}

TEST(Document, RefusesWhatJsonDoesNotHave) {
  for (const auto* text : {"{'a': 1}", "[1,]", "{\"a\": 1,}", "[NaN]", "[Infinity]", "[+1]", "[01]",
                           "[.5]", "[1.]", "[0x10]", "// comment\n{}", "\"open"})
    EXPECT_EQ(parse_problem(text).code, Code::bad_json) << text;
}

TEST(Document, RefusesBytesThatAreNotUtf8AndQuotesNoneOfThem) {
  const auto problem = parse_problem("{\"a\": \"\xff\xfe\"}");

  EXPECT_EQ(problem.code, Code::bad_json);
  EXPECT_EQ(problem.message.find('\xff'), std::string::npos);
}

TEST(Document, RefusesADuplicateKeyWithItsPointer) {
  const auto problem = parse_problem(R"({"x": [1, {"b": {"a": 1, "c": 2, "a": 3}}]})");

  EXPECT_EQ(problem.code, Code::bad_json);
  EXPECT_EQ(problem.pointer, "/x/1/b/a");
}

TEST(Document, RefusesKeysThatDifferOnlyInTheirEscapes) {
  EXPECT_EQ(parse_problem(R"({"a": 1, "\u0061": 2})").code, Code::bad_json);
}

TEST(Document, RefusesANumberThatOverflows) {
  const auto problem = parse_problem(R"({"a": [1, 2, -1e999]})");

  EXPECT_EQ(problem.code, Code::bad_number);
  EXPECT_EQ(problem.pointer, "/a/2");
}

TEST(Document, Takes64LevelsAndRefuses65) {
  EXPECT_TRUE(Document::parse(nested(64)));
  EXPECT_EQ(parse_problem(nested(65)).code, Code::bad_json);
}

TEST(Document, RefusesMillionsOfOpenBracketsWithoutHarm) {
  EXPECT_EQ(parse_problem(std::string(5'000'000, '[')).code, Code::bad_json);
  std::string objects;
  for (int i = 0; i < 100'000; ++i) objects += "{\"a\":";
  EXPECT_EQ(parse_problem(objects).code, Code::bad_json);
}

TEST(Document, BoundsTheNumberOfValues) {
  std::string text = "[";
  for (std::size_t i = 0; i < Document::max_values; ++i) text += "{},";
  text += "{}]";

  EXPECT_EQ(parse_problem(text).code, Code::too_large);
}

TEST(Document, CountsTheNumbersOfAnArrayThatTurnsOutToBeMixed) {
  std::string text = "[";
  for (std::size_t i = 0; i < Document::max_values; ++i) text += "1,";
  text += "null]";

  EXPECT_EQ(parse_problem(text).code, Code::too_large);
}

TEST(Document, BoundsTheLengthOfKeys) {
  EXPECT_TRUE(Document::parse("{\"" + std::string(1000, 'k') + "\": 1}"));
  EXPECT_EQ(parse_problem("{\"" + std::string(1001, 'k') + "\": 1}").code, Code::too_large);
}

TEST(Document, SurvivesRandomBytes) {
  std::mt19937_64 random{42};
  constexpr std::string_view letters = "{}[]\",:0123456789.eE+-truefalsn \n\\u\x80\xff";
  std::uniform_int_distribution<std::size_t> letter{0, letters.size() - 1};
  int accepted = 0;
  for (int i = 0; i < 50'000; ++i) {
    std::string text(random() % 24, ' ');
    for (char& each : text) each = letters[letter(random)];
    auto document = Document::parse(text);
    if (!document) {
      ASSERT_FALSE(document.error().message.empty());
      continue;
    }
    ++accepted;
    document->root().object().finish();
  }
  EXPECT_GT(accepted, 0);
}

TEST(Object, ReadsWhatIsAsked) {
  auto document = parsed(R"({"b": true, "n": -2.5, "i": 7, "s": "text", "v": [1, 2, 3],
                             "r": [-10, 20], "c": "inch", "o": {"x": null}, "l": ["p", "q"]})");
  const auto object = document.object();
  constexpr std::array<std::string_view, 2> units{"mm", "inch"};

  EXPECT_TRUE(object.boolean("b"));
  EXPECT_EQ(object.number("n"), -2.5);
  EXPECT_EQ(object.integer("i", 0, 10), 7);
  EXPECT_EQ(object.string("s"), "text");
  EXPECT_EQ(object.vector3("v"), Vec3(1, 2, 3));
  EXPECT_EQ(object.optional_range("r"), (Range<double>{-10, 20}));
  EXPECT_EQ(object.choice("c", units), 1u);
  EXPECT_EQ(object.object("o").optional_number("x"), std::nullopt);
  EXPECT_EQ(object.array("l").strings(), (std::vector<std::string>{"p", "q"}));
  object.finish();
  EXPECT_FALSE(document.problem());
}

TEST(Object, TakesMissingAndNullAsNone) {
  auto document = parsed(R"({"a": null})");
  const auto object = document.object();

  EXPECT_EQ(object.optional_number("a"), std::nullopt);
  EXPECT_EQ(object.optional_string("b"), std::nullopt);
  EXPECT_FALSE(object.has("a"));
  object.finish();
  EXPECT_FALSE(document.problem());
}

/// Reads one value of a text in a way that must fail.
struct BadRead {
  const char* name;
  const char* text;
  void (*read)(const Object&);
  Code code;
  const char* pointer;
};
void PrintTo(const BadRead& bad, std::ostream* out) { *out << bad.name; }

class BadReadTest : public ::testing::TestWithParam<BadRead> {};

TEST_P(BadReadTest, IsAProblemWithItsPointer) {
  auto document = parsed(GetParam().text);

  GetParam().read(document.object());

  ASSERT_TRUE(document.problem());
  EXPECT_EQ(document.problem()->code, GetParam().code) << document.problem()->message;
  EXPECT_EQ(document.problem()->pointer, GetParam().pointer);
}

constexpr std::array<std::string_view, 2> two_words{"mm", "inch"};

INSTANTIATE_TEST_SUITE_P(StrictReader, BadReadTest,
                         ::testing::Values(
                             BadRead{"MissingKey", R"({"o": {}})",
                                     [](const Object& o) { o.object("o").number("n"); },
                                     Code::missing_key, "/o/n"},
                             BadRead{"NullIsNoNumber", R"({"n": null})",
                                     [](const Object& o) { o.number("n"); }, Code::wrong_type,
                                     "/n"},
                             BadRead{"TextIsNoNumber", R"({"n": "1"})",
                                     [](const Object& o) { o.number("n"); }, Code::wrong_type,
                                     "/n"},
                             BadRead{"TruthIsNoNumber", R"({"n": true})",
                                     [](const Object& o) { o.number("n"); }, Code::wrong_type,
                                     "/n"},
                             BadRead{"NumberIsNoTruth", R"({"n": 1})",
                                     [](const Object& o) { o.boolean("n"); }, Code::wrong_type,
                                     "/n"},
                             BadRead{"NumberIsNoText", R"({"n": 1})",
                                     [](const Object& o) { o.string("n"); }, Code::wrong_type,
                                     "/n"},
                             BadRead{"ArrayIsNoObject", R"({"n": []})",
                                     [](const Object& o) { o.object("n"); }, Code::wrong_type,
                                     "/n"},
                             BadRead{"ObjectIsNoArray", R"({"n": {}})",
                                     [](const Object& o) { o.array("n"); }, Code::wrong_type, "/n"},
                             BadRead{"FractionIsNoInteger", R"({"n": 3.7})",
                                     [](const Object& o) { o.integer("n", 0, 9); },
                                     Code::wrong_type, "/n"},
                             BadRead{"IntegerBelow", R"({"n": -1})",
                                     [](const Object& o) { o.integer("n", 0, 9); },
                                     Code::out_of_domain, "/n"},
                             BadRead{"IntegerAbove2To53", R"({"n": 9007199254740994})",
                                     [](const Object& o) { o.integer("n", 0, INT64_MAX); },
                                     Code::wrong_type, "/n"},
                             BadRead{"HugeInteger", R"({"n": 1e300})",
                                     [](const Object& o) { o.integer("n", INT64_MIN, INT64_MAX); },
                                     Code::wrong_type, "/n"},
                             BadRead{"ZeroIsNotPositive", R"({"n": 0})",
                                     [](const Object& o) { o.number("n", Domain::positive()); },
                                     Code::out_of_domain, "/n"},
                             BadRead{"AboveTheUpperBound", R"({"n": 2})",
                                     [](const Object& o) { o.number("n", Domain::between(0, 1)); },
                                     Code::out_of_domain, "/n"},
                             BadRead{"UnknownWord", R"({"n": "cm"})",
                                     [](const Object& o) { o.choice("n", two_words); },
                                     Code::out_of_domain, "/n"},
                             BadRead{"TwoNumbersAreNoVector", R"({"n": [1, 2]})",
                                     [](const Object& o) { o.vector3("n"); }, Code::wrong_type,
                                     "/n"},
                             BadRead{"TextInAVector", R"({"n": [1, "2", 3]})",
                                     [](const Object& o) { o.vector3("n"); }, Code::wrong_type,
                                     "/n/1"},
                             BadRead{"TextInsteadOfAVector", R"({"n": "1 2 3"})",
                                     [](const Object& o) { o.vector3("n"); }, Code::wrong_type,
                                     "/n"},
                             BadRead{"EmptyRange", R"({"n": [5, 5]})",
                                     [](const Object& o) { o.optional_range("n"); },
                                     Code::out_of_domain, "/n"},
                             BadRead{"RangeUpsideDown", R"({"n": [5, -5]})",
                                     [](const Object& o) { o.optional_range("n"); },
                                     Code::out_of_domain, "/n"},
                             BadRead{"NumberAmongTexts", R"({"n": ["a", 2]})",
                                     [](const Object& o) { o.array("n").strings(); },
                                     Code::wrong_type, "/n/1"},
                             BadRead{"ElementOfAFlatArray", R"({"n": [1, 2, -3]})",
                                     [](const Object& o) {
                                       o.array("n").at(2).number(Domain::positive());
                                     },
                                     Code::out_of_domain, "/n/2"},
                             BadRead{"DeepElement", R"({"p": [[1, 2], [3, null]]})",
                                     [](const Object& o) {
                                       for (std::size_t i = 0; i < 2; ++i)
                                         o.array("p").at(i).array().numbers(2);
                                     },
                                     Code::wrong_type, "/p/1/1"},
                             BadRead{"UnknownKey", R"({"a": 1, "b": {"d": 2}})",
                                     [](const Object& o) {
                                       o.number("a");
                                       o.object("b").finish();
                                     },
                                     Code::unknown_key, "/b/d"},
                             BadRead{"EscapedKey", R"({"a/b~c": 1})",
                                     [](const Object& o) { o.finish(); }, Code::unknown_key,
                                     "/a~1b~0c"}),
                         [](const auto& param_info) { return param_info.param.name; });

TEST(Object, RefusesARootThatIsNoObject) {
  auto document = parsed("[1, 2]");

  document.object().number("a");

  ASSERT_TRUE(document.problem());
  EXPECT_EQ(document.problem()->code, Code::wrong_type);
  EXPECT_EQ(document.problem()->pointer, "");
}

TEST(Object, TakesAnIntegerWrittenWithAPoint) {
  auto document = parsed(R"({"n": 3.0})");

  EXPECT_EQ(document.object().integer("n", 0, 9), 3);
  EXPECT_FALSE(document.problem());
}

TEST(Object, KeepsTheFirstProblemAndGoesOnWithEmptyValues) {
  auto document = parsed(R"({"a": "x", "b": "y"})");
  const auto object = document.object();

  EXPECT_EQ(object.number("a"), 0.0);
  EXPECT_EQ(object.object("b").object("c").array("d").size(), 0u);
  EXPECT_TRUE(object.object("nothing").keys().empty());
  EXPECT_EQ(object.object("nothing").text_in("{}"), "");

  EXPECT_EQ(document.problem()->pointer, "/a");
}

TEST(Object, SaysFoundAndExpected) {
  auto document = parsed(R"({"tip_mm": -1})");

  document.object().number("tip_mm", Domain::positive());

  EXPECT_EQ(document.problem()->message, "found -1; expected a number above 0");
}

TEST(Object, OffersTheKeyThatWasMeant) {
  auto document = parsed(R"({"gauge_lenght_mm": 120})");
  const auto object = document.object();

  object.optional_number("gauge_length_mm");
  object.finish();

  EXPECT_EQ(document.problem()->message,
            "the key \"gauge_lenght_mm\" is not known here; did you mean \"gauge_length_mm\"?");
}

TEST(Object, QuotesNoLongTexts) {
  auto document = parsed("{\"n\": \"" + std::string(1000, 'x') + "\"}");

  document.object().number("n");

  EXPECT_LT(document.problem()->message.size(), 120u);
}

TEST(Object, GivesItsOwnBytes) {
  const std::string text = R"({"a": 1,  "machine": { "axes": {"X": 12}, "n": 3 } , "b": 2})";
  auto document = parsed(text);

  EXPECT_EQ(document.object().object("machine").text_in(text), R"({ "axes": {"X": 12}, "n": 3 })");
  EXPECT_EQ(document.object().object("machine").object("axes").text_in(text), R"({"X": 12})");
}

TEST(Object, HandsABigTextOutOnce) {
  auto document = parsed(R"({"cl": "GOTO/1,2,3"})");

  EXPECT_EQ(document.object().take_string("cl"), "GOTO/1,2,3");
  EXPECT_EQ(document.object().string("cl"), "");
}

TEST(Object, FailsWhereTheCallerSaysSo) {
  auto document = parsed(R"({"a": {"b": 1}})");
  const auto object = document.object().object("a");

  object.fail_at("b", Code::conflicting_keys, "b and c exclude each other");

  EXPECT_EQ(document.problem()->pointer, "/a/b");
}

TEST(Array, RefusesAnIndexBeyondItsEnd) {
  auto document = parsed("[1, 2]");

  EXPECT_THROW(document.root().array().at(2), std::logic_error);
}

TEST(Array, TellsNumbersAndOthersApart) {
  auto document = parsed(R"([1, "a", null, true, [], {}])");
  const auto array = document.root().array();

  ASSERT_EQ(array.size(), 6u);
  EXPECT_TRUE(array.at(0).is_number());
  EXPECT_TRUE(array.at(1).is_string());
  EXPECT_TRUE(array.at(2).is_null());
  EXPECT_TRUE(array.at(3).is_boolean());
  EXPECT_TRUE(array.at(4).is_array());
  EXPECT_TRUE(array.at(5).is_object());
}

TEST(Array, ReadsNumbersAsTheyStand) {
  auto document = parsed("[0.1, 1e-9, 123456789.123456789, -0.0, 1e22, 5]");
  const auto numbers = document.root().array().numbers(6);

  ASSERT_EQ(numbers.size(), 6u);
  EXPECT_EQ(numbers[0], 0.1);
  EXPECT_EQ(numbers[1], 1e-9);
  EXPECT_EQ(numbers[2], 123456789.123456789);
  EXPECT_EQ(numbers[4], 1e22);
  EXPECT_EQ(numbers[5], 5.0);
}

TEST(Document, MayBeMovedWhileItsViewsLive) {
  auto document = parsed(R"({"a": 5, "b": "x"})");
  const auto object = document.object();
  const Document moved = std::move(document);

  EXPECT_EQ(object.number("a"), 5.0);
  object.number("b");
  EXPECT_EQ(moved.problem()->pointer, "/b");
}

}  // namespace
}  // namespace pentapost::json
