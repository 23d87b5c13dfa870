#include "server/json/problem_json.hpp"

#include "pentapost/json/strict_reader.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace pentapost::server {
namespace {

TEST(ProblemResponse, HoldsAllThatTheProblemSays) {
  const auto response = problem_response(
      Problem{.code = Code::out_of_reach, .message = "no way", .cl_line = 431, .pointer = "/cl"},
      "id-1");

  EXPECT_EQ(response.status, 422);
  EXPECT_EQ(response.content_type, "application/problem+json");
  EXPECT_EQ(
      response.body,
      R"({"type":"urn:pentapost:problem:out_of_reach","title":"The machine cannot reach a tool axis",)"
      R"("status":422,"detail":"no way","code":"out_of_reach","pointer":"/cl","cl_line":431,)"
      R"("request_id":"id-1","diagnostics":[{"severity":"error","code":"out_of_reach","cl_line":431,)"
      R"("message":"no way"}],"diagnostics_total":1})");
}

TEST(ProblemResponse, HasTheEmptyPointerOfAWholeDocumentOfTheWrongType) {
  const auto whole = problem_response(Problem{.code = Code::wrong_type, .message = "x"}, "id");
  EXPECT_NE(whole.body.find(R"("pointer":"",)"), std::string::npos) << whole.body;
  const auto none = problem_response(Problem{.code = Code::bad_json, .message = "x"}, "id");
  EXPECT_EQ(none.body.find("pointer"), std::string::npos) << none.body;
}

TEST(ProblemResponse, ShowsAHundredDiagnosticsErrorsFirstAndCountsAll) {
  Problem problem{.code = Code::damaged_motion, .message = "damaged"};
  for (int i = 0; i < 150; ++i)
    problem.diagnostics.add({.severity = Severity::warning, .message = "w"});
  problem.diagnostics.add(
      {.severity = Severity::error, .code = Code::damaged_motion, .message = "e"});
  const auto response = problem_response(problem, "id");
  const auto document = json::Document::parse(response.body);
  ASSERT_TRUE(document);
  const auto list = document->object().array("diagnostics");

  EXPECT_EQ(list.size(), 100u);
  EXPECT_EQ(list.at(0).object().string("severity"), "error");
  EXPECT_EQ(document->object().integer("diagnostics_total", 0, 1'000), 151);
}

TEST(StatusOf, FollowsTheContract) {
  EXPECT_EQ(status_of(Code::damaged_motion), 400);
  EXPECT_EQ(status_of(Code::no_motion), 400);
  EXPECT_EQ(status_of(Code::unknown_key), 400);
  EXPECT_EQ(status_of(Code::unknown_machine), 404);
  EXPECT_EQ(status_of(Code::unknown_version), 404);
  EXPECT_EQ(status_of(Code::rotary_range), 422);
  EXPECT_EQ(status_of(Code::linear_range), 422);
  EXPECT_EQ(status_of(Code::definition_schema), 422);
  EXPECT_EQ(status_of(Code::proof_failed), 500);
  EXPECT_EQ(status_of(Code::body_too_large), 413);
  EXPECT_EQ(status_of(Code::overloaded), 503);
}

TEST(ErrorsPage, HasOneRowACodeWithItsStatus) {
  std::ifstream file{PENTAPOST_SOURCE_DIR "/api/errors.md"};
  const std::string page{std::istreambuf_iterator<char>{file}, {}};
  ASSERT_FALSE(page.empty());
  std::size_t rows = 0;
  for (auto at = page.find("\n| `"); at != std::string::npos; at = page.find("\n| `", at + 1))
    ++rows;
  EXPECT_EQ(rows, code_rows.size());
  for (const auto& row : code_rows) {
    const std::string start = "\n| `" + std::string{row.name} + "` | ";
    const auto place = page.find(start);
    ASSERT_NE(place, std::string::npos) << row.name;
    const auto status = page.substr(place + start.size(), 3);
    if (status == "\xe2\x80\x93") continue;  // an en dash: a remark only
    EXPECT_EQ(status, std::to_string(status_of(row.code))) << row.name;
  }
}

}  // namespace
}  // namespace pentapost::server
