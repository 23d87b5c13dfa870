#include "pentapost/json/definition_json.hpp"

#include "lib/json/demo_definition.hpp"
#include "pentapost/core/sha256.hpp"
#include "pentapost/json/machine_schema.hpp"
#include "pentapost/json/strict_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <random>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace pentapost::json {
namespace {

using sample::demo_definition;
using sample::dialects;
using sample::with;

machine::Definition demo() { return definition_from_text(demo_definition, dialects).value(); }

const machine::RotaryJoint& rotary(const machine::Joint& joint) {
  return std::get<machine::RotaryJoint>(joint.kind);
}
const machine::LinearJoint& linear(const machine::Joint& joint) {
  return std::get<machine::LinearJoint>(joint.kind);
}

TEST(Definition, HasNameVersionTitleAndSources) {
  const auto definition = demo();

  EXPECT_EQ(definition.name, "demo");
  EXPECT_EQ(definition.version, "1.0.0");
  EXPECT_EQ(definition.title, "Demo, A/C table");
  EXPECT_EQ(definition.sources, std::vector<std::string>{"assumed"});
}

TEST(Definition, PutsAxesLeftOfTheBaseOnTheTableSide) {
  const auto definition = demo();

  ASSERT_EQ(definition.chain.table().size(), 2u);
  EXPECT_EQ(definition.chain.table()[0].name, "C");
  EXPECT_EQ(definition.chain.table()[1].name, "A");
  ASSERT_EQ(definition.chain.head().size(), 3u);
  EXPECT_EQ(definition.chain.head()[0].name, "Y");
}

TEST(Definition, HasDirectionsAndPointsAsGiven) {
  const auto definition = demo();

  EXPECT_EQ(rotary(definition.chain.table()[0]).direction.vec(), Vec3(0, 0, -1));
  EXPECT_EQ(rotary(definition.chain.table()[1]).point_mm, Vec3(0, 20, 10));
}

TEST(Definition, TurnsDegreesIntoRadians) {
  const auto definition = demo();
  const auto& tilt = rotary(definition.chain.table()[1]);

  EXPECT_DOUBLE_EQ(tilt.range->lower.rad(), -1.9198621771937625);                    // -110 deg
  EXPECT_DOUBLE_EQ(tilt.range->upper.rad(), 1.5707963267948966);                     // 90 deg
  EXPECT_DOUBLE_EQ(*definition.limits.at("A").max_speed, 2.6179938779914944);        // 150 deg/s
  EXPECT_DOUBLE_EQ(*definition.limits.at("A").max_acceleration, 8.726646259971648);  // 500 deg/s2
  EXPECT_DOUBLE_EQ(*definition.limits.at("A").max_jerk, 87.26646259971648);          // 5000 deg/s3
}

TEST(Definition, KeepsMillimetres) {
  const auto definition = demo();

  EXPECT_EQ(linear(definition.chain.head()[1]).range_mm, (Range<double>{-300, 310}));
  EXPECT_EQ(definition.limits.at("X").max_speed, 250.0);
  EXPECT_EQ(definition.limits.at("X").max_acceleration, 2000.0);
  EXPECT_EQ(definition.limits.at("X").max_jerk, 30000.0);
}

TEST(Definition, HasNoRangeForAnEndlessAxis) {
  EXPECT_EQ(rotary(demo().chain.table()[0]).range, std::nullopt);
}

TEST(Definition, LeavesOutWhatNoSourceGives) {
  const auto definition = demo();

  EXPECT_EQ(linear(definition.chain.head()[0]).range_mm, std::nullopt);
  EXPECT_EQ(definition.limits.at("C").max_speed, std::nullopt);
  EXPECT_EQ(definition.limits.at("Y").max_jerk, std::nullopt);
}

TEST(Definition, HasPreferencesAndController) {
  const auto definition = demo();

  EXPECT_EQ(definition.preferences.tilt, machine::Preferences::Tilt::negative);
  EXPECT_DOUBLE_EQ(definition.preferences.first_turn->upper.rad(), 6.283185307179586);
  EXPECT_EQ(definition.controller.dialect, "heidenhain-iso");
  EXPECT_EQ(definition.controller.output, Output::tcp);
}

TEST(Definition, KeepsOptionsOfEveryKind) {
  const auto options = demo().controller.options;

  EXPECT_EQ(std::get<bool>(options.at("comments")), true);
  EXPECT_EQ(std::get<double>(options.at("decimals_mm")), 4.0);
  EXPECT_EQ(std::get<std::string>(options.at("coolant_flood")), "M8");
  EXPECT_EQ(std::get<std::vector<std::string>>(options.at("end_lines")),
            (std::vector<std::string>{"M5", "M30"}));
}

TEST(Definition, TakesAnEmptyListAsAnOption) {
  const auto text = with(demo_definition, R"(["M5", "M30"])", "[]");
  const auto definition = definition_from_text(text, dialects);

  ASSERT_TRUE(definition);
  EXPECT_TRUE(
      std::get<std::vector<std::string>>(definition->controller.options.at("end_lines")).empty());
}

TEST(Definition, HasTheHashOfItsBytes) { EXPECT_EQ(demo().sha256, sha256_hex(demo_definition)); }

TEST(Definition, NormalisesADirectionThatIsRounded) {
  const auto text = with(demo_definition, R"("direction": [1, 0, 0], "point_mm")",
                         R"("direction": [0.7071068, 0.7071068, 0], "point_mm")");
  const auto definition = definition_from_text(text, dialects);

  ASSERT_TRUE(definition) << definition.error().message;
  const auto& direction = rotary(definition->chain.table()[1]).direction.vec();
  EXPECT_NEAR(direction.x(), std::sqrt(0.5), 1e-16);
  EXPECT_EQ(direction.x(), direction.y());
}

TEST(Definition, IsRefusedAtThePrefixedPointerWhenInline) {
  const auto text = with(demo_definition, R"("heidenhain-iso")", R"("heidenhein-iso")");
  const auto problem = definition_from_text(text, dialects, "/machine").error();

  EXPECT_EQ(problem.pointer, "/machine/controller/dialect");
  EXPECT_NE(problem.message.find("did you mean \"heidenhain-iso\"?"), std::string::npos);
}

TEST(Definition, IsRefusedWhenItIsTooLarge) {
  const std::string text(max_definition_bytes + 1, ' ');

  EXPECT_EQ(definition_from_text(text, dialects).error().code, Code::too_large);
}

// A regular expression over a million letters would overflow the stack.
TEST(Definition, IsRefusedWithoutHarmWhenItsNameIsEndless) {
  for (const auto* part : {R"("name": "demo")", R"("version": "1.0.0")"}) {
    const auto key = std::string_view{part}.substr(0, std::string_view{part}.find(':'));
    const auto text =
        with(demo_definition, part, std::string{key} + ": \"" + std::string(1'000'000, 'a') + "\"");

    EXPECT_EQ(definition_from_text(text, dialects).error().code, Code::definition_schema);
  }
}

TEST(Definition, SaysWhatTheSchemaDidNotFit) {
  const auto text = with(demo_definition, R"("max_speed_mm_s": 250)", R"("max_speed_mm_s": -250)");
  const auto problem = definition_from_text(text, dialects).error();

  EXPECT_NE(problem.message.find("-250"), std::string::npos) << problem.message;
}

/// A definition with one part replaced, and what must be said about it.
struct Broken {
  const char* name;
  const char* part;
  const char* replacement;
  Code code;
  const char* pointer;
};
void PrintTo(const Broken& broken, std::ostream* out) { *out << broken.name; }

class BrokenDefinition : public ::testing::TestWithParam<Broken> {};

TEST_P(BrokenDefinition, IsRefusedWithItsPointer) {
  const auto text = with(demo_definition, GetParam().part, GetParam().replacement);

  const auto definition = definition_from_text(text, dialects);

  ASSERT_FALSE(definition);
  EXPECT_EQ(row_of(definition.error().code).name, row_of(GetParam().code).name)
      << definition.error().message;
  EXPECT_EQ(definition.error().pointer, GetParam().pointer) << definition.error().message;
}

constexpr const char* demo_chain = R"("workpiece", "C", "A", "base", "Y", "X", "Z", "tool")";
constexpr const char* y_axis = R"("Y": {"type": "linear", "direction": [0, 1, 0]},)";

INSTANTIATE_TEST_SUITE_P(Json, BrokenDefinition,
                         ::testing::Values(Broken{"Syntax", R"("name": "demo",)",
                                                  R"("name": "demo")", Code::bad_json, ""},
                                           Broken{"DuplicateKey", R"("name": "demo",)",
                                                  R"("name": "demo", "name": "demo",)",
                                                  Code::bad_json, "/name"},
                                           Broken{"Overflow", "[-300, 310]", "[-300, 1e400]",
                                                  Code::bad_number, "/axes/X/range_mm/1"}),
                         [](const auto& param_info) { return param_info.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Schema, BrokenDefinition,
    ::testing::Values(
        Broken{"MissingTitle", R"("title": "Demo, A/C table",)", "", Code::definition_schema, ""},
        Broken{"UnknownKey", R"("name": "demo",)", R"("name": "demo", "nmae": 1,)",
               Code::definition_schema, "/nmae"},
        Broken{"OtherSchemaVersion", R"("schema_version": 1)", R"("schema_version": 2)",
               Code::definition_schema, "/schema_version"},
        Broken{"NameWithCapitals", R"("name": "demo")", R"("name": "Demo")",
               Code::definition_schema, "/name"},
        Broken{"NameThatLeavesTheFolder", R"("name": "demo")", R"("name": "../demo")",
               Code::definition_schema, "/name"},
        Broken{"VersionOfTwoNumbers", R"("version": "1.0.0")", R"("version": "1.0")",
               Code::definition_schema, "/version"},
        Broken{"VersionWithALeadingZero", R"("version": "1.0.0")", R"("version": "1.00.0")",
               Code::definition_schema, "/version"},
        Broken{"NoSources", R"(["assumed"])", "[]", Code::definition_schema, "/sources"},
        Broken{"SourceThatIsNoText", R"(["assumed"])", "[1]", Code::definition_schema,
               "/sources/0"},
        Broken{"ChainWord", demo_chain, R"("workpiece", "C", "A", "bed", "Y", "X", "Z", "tool")",
               Code::definition_schema, "/chain/3"},
        Broken{"AxisLetter", R"("Z": {)", R"("Q": {)", Code::definition_schema, "/axes/Q"},
        Broken{"UnknownType", R"("C": {"type": "rotary")", R"("C": {"type": "spherical")",
               Code::definition_schema, "/axes/C/type"},
        Broken{"LinearAxisWithARotaryLetter", R"("C": {"type": "rotary")",
               R"("C": {"type": "linear")", Code::definition_schema, "/axes/C/type"},
        Broken{"MissingPoint", R"("point_mm": [0, 0, 0], )", "", Code::definition_schema,
               "/axes/C"},
        Broken{"LinearLimitOnARotaryAxis", R"("max_speed_deg_s": 150)", R"("max_speed_mm_s": 150)",
               Code::definition_schema, "/axes/A/max_speed_mm_s"},
        Broken{"DirectionOfTwoNumbers", R"("direction": [0, 0, -1])", R"("direction": [0, 0])",
               Code::definition_schema, "/axes/C/direction"},
        Broken{"DirectionWithText", R"("direction": [0, 0, -1])", R"("direction": [0, 0, "-1"])",
               Code::definition_schema, "/axes/C/direction/2"},
        Broken{"SpeedOfZero", R"("max_speed_deg_s": 150)", R"("max_speed_deg_s": 0)",
               Code::definition_schema, "/axes/A/max_speed_deg_s"},
        Broken{"SpeedThatIsNull", R"("max_speed_deg_s": 150)", R"("max_speed_deg_s": null)",
               Code::definition_schema, "/axes/A/max_speed_deg_s"},
        Broken{"LinearRangeThatIsNull", "[-300, 310]", "null", Code::definition_schema,
               "/axes/X/range_mm"},
        Broken{"RangeOfThreeNumbers", "[-110, 90]", "[-110, 90, 100]", Code::definition_schema,
               "/axes/A/range_deg"},
        Broken{"RangeOfTexts", "[-110, 90]", R"(["-110", "90"])", Code::definition_schema,
               "/axes/A/range_deg/0"},
        Broken{"RangeBeyondAllBounds", "[-300, 310]", "[-300, 1e7]", Code::definition_schema,
               "/axes/X/range_mm/1"},
        Broken{"UnknownTilt", R"("negative")", R"("upwards")", Code::definition_schema,
               "/preferences/tilt"},
        Broken{"UnknownPreference", R"("tilt": "negative",)", R"("tlit": "negative",)",
               Code::definition_schema, "/preferences/tlit"},
        Broken{"UnknownOutput", R"("tcp")", R"("tip")", Code::definition_schema,
               "/controller/output"},
        Broken{"OptionThatIsAnObject", R"("comments": true)", R"("comments": {})",
               Code::definition_schema, "/controller/options/comments"},
        Broken{"OptionThatIsNull", R"("comments": true)", R"("comments": null)",
               Code::definition_schema, "/controller/options/comments"},
        Broken{"OptionWithNumbers", R"(["M5", "M30"])", R"(["M5", 30])", Code::definition_schema,
               "/controller/options/end_lines/1"}),
    [](const auto& param_info) { return param_info.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Meaning, BrokenDefinition,
    ::testing::Values(
        Broken{"DirectionNotOfUnitLength", R"("direction": [0, 0, -1])",
               R"("direction": [0, 0.01, -1])", Code::definition_meaning, "/axes/C/direction"},
        Broken{"DirectionJustBeyondRounding", R"("direction": [0, 0, -1])",
               R"("direction": [0, 0, -0.999998])", Code::definition_meaning, "/axes/C/direction"},
        Broken{"ZeroDirection", R"("direction": [0, 0, -1])", R"("direction": [0, 0, 0])",
               Code::definition_meaning, "/axes/C/direction"},
        Broken{"ToolAxisNotOfUnitLength", R"("tool_axis": [0, 0, 1])",
               R"("tool_axis": [0, 0.7, 0.7])", Code::definition_meaning, "/tool_axis"},
        Broken{"RangeUpsideDown", "[-110, 90]", "[90, -110]", Code::definition_meaning,
               "/axes/A/range_deg"},
        Broken{"EmptyRange", "[-300, 310]", "[310, 310]", Code::definition_meaning,
               "/axes/X/range_mm"},
        Broken{"WindowUpsideDown", "[0, 360]", "[360, 0]", Code::definition_meaning,
               "/preferences/first_turn_deg"},
        Broken{"ChainFromTheTool", demo_chain,
               R"("tool", "C", "A", "base", "Y", "X", "Z", "workpiece")", Code::chain_shape,
               "/chain/0"},
        Broken{"ChainWithoutATool", demo_chain, R"("workpiece", "C", "A", "base", "Y", "X", "Z")",
               Code::chain_shape, "/chain/6"},
        Broken{"ChainWithTheToolInside", demo_chain,
               R"("workpiece", "C", "tool", "base", "Y", "X", "Z", "tool")", Code::chain_shape,
               "/chain/2"},
        Broken{"ChainWithoutABase", demo_chain, R"("workpiece", "C", "A", "Y", "X", "Z", "tool")",
               Code::chain_shape, "/chain"},
        Broken{"ChainWithTwoBases", demo_chain,
               R"("workpiece", "C", "base", "base", "Y", "X", "Z", "tool")", Code::chain_shape,
               "/chain/3"},
        Broken{"AxisTwiceInTheChain", demo_chain,
               R"("workpiece", "C", "A", "base", "Y", "X", "X", "tool")", Code::chain_shape,
               "/chain/6"},
        Broken{"ChainWithAnUndefinedAxis", demo_chain,
               R"("workpiece", "C", "B", "base", "Y", "X", "Z", "tool")", Code::chain_shape,
               "/chain/2"},
        Broken{"AxisOutsideTheChain", demo_chain,
               R"("workpiece", "C", "base", "Y", "X", "Z", "tool")", Code::chain_shape, "/axes/A"},
        Broken{"LinearAxesInOnePlane", y_axis,
               R"("Y": {"type": "linear", "direction": [0, 0, 1]},)", Code::chain_shape, "/axes"},
        Broken{"ParallelRotaryAxes", R"("direction": [0, 0, -1])", R"("direction": [-1, 0, 0])",
               Code::chain_shape, "/axes"},
        Broken{"UnknownDialect", R"("heidenhain-iso")", R"("klartext")", Code::unknown_dialect,
               "/controller/dialect"}),
    [](const auto& param_info) { return param_info.param.name; });

TEST(Definition, NeedsThreeLinearAxes) {
  const auto text = with(with(demo_definition, y_axis, ""), R"("base", "Y",)", R"("base",)");
  const auto problem = definition_from_text(text, dialects).error();

  EXPECT_EQ(problem.code, Code::chain_shape);
  EXPECT_EQ(problem.message, "the chain has 2 linear joints; 3 are needed");
}

// The demo has every key that the schema knows, so that the reader knows them too.
TEST(Definition, MayHaveEveryKeyOfTheSchema) {
  auto schema = Document::parse(machine_schema_text()).value();
  const auto root = schema.object();
  const auto definitions = root.object("definitions");
  const std::vector<Object> described{root, definitions.object("linear_axis"),
                                      definitions.object("rotary_axis"),
                                      root.object("properties").object("preferences"),
                                      root.object("properties").object("controller")};
  for (const auto& object : described)
    for (const auto& key : object.object("properties").keys())
      EXPECT_NE(demo_definition.find("\"" + key + "\":"), std::string::npos) << key;
  EXPECT_FALSE(schema.problem());
}

TEST(Definition, SurvivesDamage) {
  std::mt19937_64 random{42};
  constexpr std::string_view letters = "{}[]\",:019.-eE \\nullXYZABC\x80";
  int refused = 0;
  for (int i = 0; i < 400; ++i) {
    std::string text = demo_definition;
    const auto at = random() % text.size();
    if (i % 3 == 0)
      text.erase(at, 1 + random() % 8);
    else
      text[at] = letters[random() % letters.size()];
    const auto definition = definition_from_text(text, dialects);
    if (definition) continue;
    ++refused;
    ASSERT_FALSE(definition.error().message.empty()) << text;
  }
  EXPECT_GT(refused, 100);
}

TEST(Definition, IsRefusedWhenItIsNoObject) {
  for (const auto* text : {"[]", "1", "null", "\"demo\""})
    EXPECT_EQ(definition_from_text(text, dialects).error().code, Code::definition_schema) << text;
}

}  // namespace
}  // namespace pentapost::json
