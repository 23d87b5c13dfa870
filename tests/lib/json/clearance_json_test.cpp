#include "lib/json/demo_definition.hpp"
#include "pentapost/json/definition_json.hpp"

#include <gtest/gtest.h>

#include <string>

namespace pentapost::json {
namespace {

using sample::demo_definition;
using sample::dialects;
using sample::with;

Result<machine::Definition> read(const std::string& text) {
  return definition_from_text(text, dialects);
}

TEST(DefinitionClearance, HasTheCylindersOfTheSpindle) {
  const auto spindle = read(demo_definition).value().clearance.spindle.value();
  ASSERT_EQ(spindle.size(), 2u);
  EXPECT_EQ(spindle[0].radius_mm, 40.0);
  EXPECT_EQ(spindle[0].from_mm, -5.0);
  EXPECT_EQ(spindle[0].to_mm, 60.0);
  EXPECT_EQ(spindle[1].radius_mm, 110.0);
}

TEST(DefinitionClearance, HasTheTable) {
  const auto table = read(demo_definition).value().clearance.table.value();
  EXPECT_EQ(table.radius_mm, 160.0);
  EXPECT_EQ(table.centre_mm, Vec3(1, 2, 3));
  EXPECT_EQ(table.normal.vec(), Vec3(0, 0, -1));
  EXPECT_EQ(table.thickness_mm, 45.0);
}

TEST(DefinitionClearance, OfATableNeedsTheRadiusAlone) {
  const auto table =
      read(with(demo_definition,
                R"(, "centre_mm": [1, 2, 3], "normal": [0, 0, -1], "thickness_mm": 45)", ""))
          .value()
          .clearance.table.value();
  EXPECT_EQ(table.centre_mm, Vec3(0, 0, 0));
  EXPECT_EQ(table.normal.vec(), Vec3(0, 0, 1));
  EXPECT_EQ(table.thickness_mm, 50.0);
}

void expect_refused(const std::string& part, const std::string& replacement, Code code,
                    const std::string& pointer) {
  const auto definition = read(with(demo_definition, part, replacement));
  ASSERT_FALSE(definition) << replacement;
  EXPECT_EQ(definition.error().code, code) << definition.error().message;
  EXPECT_EQ(definition.error().pointer, pointer) << definition.error().message;
}

TEST(DefinitionClearance, RefusesACylinderThatEndsBelowItsStart) {
  expect_refused(R"("from_mm": 60, "to_mm": 400)", R"("from_mm": 60, "to_mm": 60)",
                 Code::definition_meaning, "/clearance/spindle/1/to_mm");
}

TEST(DefinitionClearance, RefusesANormalThatIsNoUnitVector) {
  expect_refused(R"("normal": [0, 0, -1])", R"("normal": [0, 0.5, 0.5])", Code::definition_meaning,
                 "/clearance/table/normal");
}

TEST(DefinitionClearance, RefusesWhatDoesNotFitTheSchema) {
  expect_refused(R"("radius_mm": 160)", R"("radius_mm": 0)", Code::definition_schema,
                 "/clearance/table/radius_mm");
  expect_refused(R"("thickness_mm": 45)", R"("thickness_mm": "45")", Code::definition_schema,
                 "/clearance/table/thickness_mm");
}

}  // namespace
}  // namespace pentapost::json
