#include "server/json/clearance_json.hpp"

#include <gtest/gtest.h>

#include <string>

namespace pentapost::server {
namespace {

constexpr auto table_frame = clearance::JigBox::Frame::table;
constexpr auto workpiece_frame = clearance::JigBox::Frame::workpiece;

/// The model of {"clearance": text}, or the first Problem.
Result<std::optional<clearance::Model>> read(const std::string& text) {
  auto document = json::Document::parse("{\"clearance\": " + text + "}");
  if (!document) return std::move(document).error();
  const auto object = document->object();
  auto model = read_clearance(object);
  object.finish();
  if (document->problem()) return *document->problem();
  return model;
}

void expect_refused(const std::string& text, Code code, const std::string& pointer) {
  const auto model = read(text);
  ASSERT_FALSE(model) << text;
  EXPECT_EQ(model.error().code, code) << text << ": " << model.error().message;
  EXPECT_EQ(model.error().pointer, pointer) << text << ": " << model.error().message;
}

TEST(ClearanceJson, IsNoneWhereItIsNotGiven) {
  const auto model = read("null");
  ASSERT_TRUE(model);
  EXPECT_FALSE(model->has_value());
}

TEST(ClearanceJson, HasDefaults) {
  const auto model = read("{}").value().value();
  EXPECT_TRUE(model.holder.empty());
  EXPECT_FALSE(model.machine.spindle);
  EXPECT_FALSE(model.machine.table);
  EXPECT_TRUE(model.jig.empty());
  EXPECT_EQ(model.safety_mm, 2.0);
}

TEST(ClearanceJson, ReadsEveryPart) {
  const auto model = read(R"({
    "holder": [{"radius_mm": 20, "from_mm": 50, "to_mm": 90}],
    "spindle": [{"radius_mm": 60, "from_mm": 0, "to_mm": 200}],
    "table": {"radius_mm": 300, "centre_mm": [1, 2, 3], "normal": [0, 1, 0], "thickness_mm": 70},
    "jig": [{"min_mm": [-1, -2, -3], "max_mm": [4, 5, 6], "frame": "workpiece"},
            {"min_mm": [0, 0, 0], "max_mm": [1, 1, 1], "frame": "table"}],
    "safety_mm": 0
  })")
                         .value()
                         .value();
  ASSERT_EQ(model.holder.size(), 1u);
  EXPECT_EQ(model.holder[0].radius_mm, 20.0);
  EXPECT_EQ(model.holder[0].from_mm, 50.0);
  EXPECT_EQ(model.holder[0].to_mm, 90.0);
  EXPECT_EQ(model.machine.spindle.value().at(0).to_mm, 200.0);
  EXPECT_EQ(model.machine.table.value().normal.vec(), Vec3(0, 1, 0));
  EXPECT_EQ(model.machine.table->centre_mm, Vec3(1, 2, 3));
  ASSERT_EQ(model.jig.size(), 2u);
  EXPECT_EQ(model.jig[0].min_mm, Vec3(-1, -2, -3));
  EXPECT_EQ(model.jig[0].max_mm, Vec3(4, 5, 6));
  EXPECT_EQ(model.jig[0].frame, workpiece_frame);
  EXPECT_EQ(model.jig[1].frame, table_frame);
  EXPECT_EQ(model.safety_mm, 0.0);
}

// It takes the place of the definition's.
TEST(ClearanceJson, TellsAnEmptySpindleFromNone) {
  EXPECT_TRUE(read(R"({"spindle": []})").value().value().machine.spindle.value().empty());
}

TEST(ClearanceJson, RefusesNumbersOutOfTheirDomain) {
  expect_refused(R"({"safety_mm": -1})", Code::out_of_domain, "/clearance/safety_mm");
  expect_refused(R"({"holder": [{"radius_mm": 0, "from_mm": 0, "to_mm": 1}]})", Code::out_of_domain,
                 "/clearance/holder/0/radius_mm");
  expect_refused(R"({"holder": [{"radius_mm": 1, "from_mm": 2, "to_mm": 1}]})", Code::out_of_domain,
                 "/clearance/holder/0/to_mm");
  expect_refused(R"({"spindle": [{"radius_mm": 1, "from_mm": 2, "to_mm": 10001}]})",
                 Code::out_of_domain, "/clearance/spindle/0/to_mm");
  expect_refused(R"({"table": {"radius_mm": 100, "thickness_mm": 0}})", Code::out_of_domain,
                 "/clearance/table/thickness_mm");
  expect_refused(R"({"table": {"radius_mm": 100, "normal": [0, 0, 2]}})", Code::out_of_domain,
                 "/clearance/table/normal");
  expect_refused(R"({"table": {"radius_mm": 100, "centre_mm": [0, 0, 2e6]}})", Code::out_of_domain,
                 "/clearance/table/centre_mm");
  expect_refused(R"({"jig": [{"min_mm": [0, 0, 0], "max_mm": [1, 0, 1], "frame": "table"}]})",
                 Code::out_of_domain, "/clearance/jig/0/max_mm");
}

TEST(ClearanceJson, RefusesAJigWithoutItsFrame) {
  expect_refused(R"({"jig": [{"min_mm": [0, 0, 0], "max_mm": [1, 1, 1]}]})", Code::missing_key,
                 "/clearance/jig/0/frame");
  expect_refused(R"({"jig": [{"min_mm": [0, 0, 0], "max_mm": [1, 1, 1], "frame": "head"}]})",
                 Code::out_of_domain, "/clearance/jig/0/frame");
}

TEST(ClearanceJson, RefusesUnknownKeys) {
  expect_refused(R"({"holders": []})", Code::unknown_key, "/clearance/holders");
  expect_refused(R"({"table": {"radius_mm": 1, "r": 2}})", Code::unknown_key, "/clearance/table/r");
}

TEST(ClearanceJson, RefusesMorePartsThanAreChecked) {
  std::string cylinders, boxes;
  for (int i = 0; i < 33; ++i) {
    cylinders +=
        (i == 0 ? "" : ", ") + std::string{R"({"radius_mm": 1, "from_mm": 0, "to_mm": 1})"};
    boxes += (i == 0 ? "" : ", ") +
             std::string{R"({"min_mm": [0, 0, 0], "max_mm": [1, 1, 1], "frame": "table"})"};
  }
  expect_refused("{\"holder\": [" + cylinders + "]}", Code::out_of_domain, "/clearance/holder");
  expect_refused("{\"jig\": [" + boxes + "]}", Code::out_of_domain, "/clearance/jig");
}

}  // namespace
}  // namespace pentapost::server
