#include "machines/bundled.hpp"
#include "pentapost/json/strict_reader.hpp"
#include "sample_server.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pentapost::server {
namespace {

const std::string cl = "UNITS/MM\nFEDRAT/600,MMPM\nGOTO/0,0,0,0,0.6,0.8\nGOTO/9,0,0,0,0.8,0.6\n";

Services services_with(const std::vector<std::string>& machines) {
  std::vector<machine::LibraryEntry> entries;
  for (const auto& name : machines)
    entries.push_back({.definition = pentapost::sample::bundled_machine(name), .bytes = "{}"});
  auto services = sample::services();
  services.machines = machine::Library{std::move(entries)};
  return services;
}

Request request(const std::string& body, Fields query = {}) {
  return {.method = "POST",
          .path = "/compare",
          .query = std::move(query),
          .headers = {{"content-type", "text/plain"}},
          .body = body};
}

/// A report of one row with that failure.
jobs::CompareReport report_with(Problem problem) {
  jobs::CompareReport report;
  report.cl_units = "mm";
  report.rows.push_back({.index = 3,
                         .name = "demo",
                         .version = "1.0.0",
                         .title = "Demo",
                         .sha256 = std::string(64, 'a'),
                         .dialect = "fanuc-30i",
                         .figures = std::move(problem)});
  return report;
}

Response answer_with(const jobs::CompareReport& report) {
  auto services = services_with({"hermle-c600u"});
  services.compare = [&](const jobs::CompareJob&) -> Result<jobs::CompareReport> { return report; };
  App app{std::move(services), {}};
  return app.handle(request(cl));
}

TEST(Compare, IsOfAllMachinesOfTheLibrary) {
  App app{services_with({"hermle-c600u", "generic-3axis"}), {}};
  const auto response = app.handle(request(cl));
  ASSERT_EQ(response.status, 200) << response.body;
  EXPECT_EQ(response.cl.value().bytes, cl.size());
  EXPECT_EQ(response.cl->sha256.size(), 64U);
  const auto document = json::Document::parse(response.body).value();
  const auto machines = document.object().array("machines");
  ASSERT_EQ(machines.size(), 2U);
  EXPECT_EQ(machines.at(0).object().string("name"), "hermle-c600u");
  EXPECT_TRUE(machines.at(0).object().boolean("possible"));
  EXPECT_EQ(machines.at(1).object().object("problem").string("code"), "out_of_reach");
}

TEST(Compare, OfAnEmptyLibraryIsRefused) {
  App app{services_with({}), {}};
  const auto response = app.handle(request(cl));
  EXPECT_EQ(response.status, 400);
  EXPECT_NE(response.body.find(R"("pointer":"/machines")"), std::string::npos) << response.body;
}

/// What an exception says is for the log, not for the client.
TEST(Compare, LeavesWhatADefectSaysToTheLog) {
  const auto response =
      answer_with(report_with({.code = Code::defect, .message = "vector::at of a secret"}));
  EXPECT_EQ(response.status, 200);
  EXPECT_EQ(response.defect, "demo@1.0.0: vector::at of a secret");
  EXPECT_EQ(response.body.find("secret"), std::string::npos);
  EXPECT_NE(response.body.find(R"("code":"defect")"), std::string::npos) << response.body;
}

TEST(Compare, LogsNoDefectWhereThereIsNone) {
  EXPECT_EQ(answer_with(report_with({.code = Code::out_of_reach, .message = "no"})).defect, "");
}

/// The fourth machine of the request, which the library does not have: an inline one.
TEST(Compare, PointsIntoAnInlineDefinition) {
  const auto response = answer_with(report_with(
      {.code = Code::bad_option, .message = "no", .pointer = "/machine/controller/options/x"}));
  EXPECT_NE(response.body.find(R"("pointer":"/machines/3/controller/options/x")"),
            std::string::npos)
      << response.body;
}

/// A machine that the request names has no values there.
TEST(Compare, DoesNotPointIntoANamedDefinition) {
  auto report = report_with(
      {.code = Code::bad_option, .message = "no", .pointer = "/machine/controller/options/x"});
  const auto machine = pentapost::sample::bundled_machine("hermle-c600u");
  report.rows[0].name = machine.name;
  report.rows[0].version = machine.version;
  report.rows[0].sha256 = machine.sha256;
  EXPECT_EQ(answer_with(report).body.find("pointer"), std::string::npos);
}

TEST(Compare, PointsToAnUnknownNameOfTheList) {
  App app{services_with({"hermle-c600u"}), {}};
  const auto response = app.handle(request(cl, {{"machines", "hermle-c600u, hermle"}}));
  EXPECT_EQ(response.status, 404);
  EXPECT_NE(response.body.find(R"("pointer":"/machines/1")"), std::string::npos) << response.body;
  EXPECT_NE(response.body.find("near: hermle-c600u"), std::string::npos) << response.body;
}

}  // namespace
}  // namespace pentapost::server
