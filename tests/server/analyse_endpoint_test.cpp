#include "machines/bundled.hpp"
#include "pentapost/json/strict_reader.hpp"
#include "sample_server.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace pentapost::server {
namespace {

App app_with(const std::vector<std::string>& machines) {
  std::vector<machine::LibraryEntry> entries;
  for (const auto& name : machines)
    entries.push_back({.definition = pentapost::sample::bundled_machine(name), .bytes = "{}"});
  auto services = sample::services();
  services.machines = machine::Library{std::move(entries)};
  return App{std::move(services), {}};
}

std::string paper(const std::string& name) {
  std::ifstream in{std::filesystem::path{PENTAPOST_TESTS_DIR} / "data/papers" / name};
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

Request request(const std::string& type, const std::string& body, Fields query = {}) {
  return {.method = "POST",
          .path = "/analyse",
          .query = std::move(query),
          .headers = {{"content-type", type}},
          .body = body};
}

json::Document answer_of(App& app, const Request& request) {
  const auto response = app.handle(request);
  EXPECT_EQ(response.status, 200) << response.body;
  EXPECT_EQ(response.content_type, "application/json");
  return json::Document::parse(response.body).value();
}

// Numbers: Cripps et al. 2017, section 2, on a polyline of 1 mm.
TEST(Analyse, AnswersTheZoneOfCripps) {
  auto app = app_with({"hermle-c600u"});
  const auto document = answer_of(
      app, request("text/plain", paper("cripps-2017-original.cl"), {{"machine", "hermle-c600u"}}));
  const auto answer = document.object();
  EXPECT_NEAR(answer.object("summary").number("closest_approach_deg"), 1.000, 0.0005);
  EXPECT_NEAR(answer.object("axes").object("C").number("peak_deg_s"), 198.9 * 6.0, 0.6);
  const auto zones = answer.array("zones");
  ASSERT_EQ(zones.size(), 1U);
  const auto zone = zones.at(0).object();
  EXPECT_EQ(zone.string("kind"), "pole");
  EXPECT_EQ(zone.string("axis"), "C");
  EXPECT_NEAR(zone.object("from").vector3("tip_mm").x(), 21.61, 0.05);
  EXPECT_NEAR(zone.object("to").vector3("tip_mm").x(), 28.39, 0.05);
  EXPECT_EQ(document.problem(), std::nullopt);
}

TEST(Analyse, AnswersNoZoneForTheReorientedPath) {
  auto app = app_with({"hermle-c600u"});
  const auto document = answer_of(app, request("text/plain", paper("cripps-2017-reoriented.cl"),
                                               {{"machine", "hermle-c600u"}}));
  const auto answer = document.object();
  EXPECT_NEAR(answer.object("summary").number("closest_approach_deg"), 11.000, 0.0005);
  EXPECT_EQ(answer.array("zones").size(), 0U);
}

TEST(Analyse, AnswersNoSingularDirectionForThreeAxes) {
  auto app = app_with({"generic-3axis"});
  const auto document =
      answer_of(app, request("application/json",
                             R"({"machine": "generic-3axis", "path": {"feed_mm_min": 600,
                       "points": [[0, 0, 0, 0, 0, 1], [10, 0, 0, 0, 0, 1]]}})"));
  const auto answer = document.object();
  EXPECT_EQ(answer.array("singular_directions").size(), 0U);
  EXPECT_EQ(answer.array("zones").size(), 0U);
  EXPECT_FALSE(answer.object("summary").has("closest_approach_deg"));
}

TEST(Analyse, AnswersTheThreeFormsAlike) {
  auto app = app_with({"hermle-c600u"});
  const std::string cl = "UNITS/MM\nFEDRAT/600,MMPM\nGOTO/0,0,0,0,0.6,0.8\nGOTO/9,0,0,0,0.8,0.6\n";
  const auto text = app.handle(request("text/plain", cl, {{"machine", "hermle-c600u"}}));
  ASSERT_EQ(text.status, 200) << text.body;
  ASSERT_TRUE(text.cl);
  EXPECT_EQ(text.cl->bytes, cl.size());
  EXPECT_EQ(text.cl->sha256.size(), 64U);
  std::string escaped;
  for (const char letter : cl) escaped += letter == '\n' ? std::string{"\\n"} : std::string{letter};
  const auto json = app.handle(
      request("application/json", R"({"machine": "hermle-c600u", "cl": ")" + escaped + "\"}"));
  EXPECT_EQ(json.body, text.body);
  const auto form = app.handle(
      request("multipart/form-data; boundary=b",
              "--b\r\nContent-Disposition: form-data; name=machine\r\n\r\nhermle-c600u\r\n"
              "--b\r\nContent-Disposition: form-data; name=cl\r\n\r\n" +
                  cl + "\r\n--b--"));
  EXPECT_EQ(form.body, text.body);
}

TEST(Analyse, RefusesWithThePlaceInTheJob) {
  auto app = app_with({"hermle-c600u"});
  for (const auto& [members, pointer] : std::vector<std::pair<std::string, std::string>>{
           {R"("zone_share": 0)", "/zone_share"},
           {R"("zone_share": -1)", "/zone_share"},
           {R"("zone_shar": 1)", "/zone_shar"},
           {R"("tolerances": {"tip_mm": 0})", "/tolerances/tip_mm"}}) {
    const auto response = app.handle(request(
        "application/json", R"({"machine": "hermle-c600u", "cl": "GOTO/0,0,0", )" + members + "}"));
    EXPECT_EQ(response.status, 400) << members;
    EXPECT_NE(response.body.find("\"pointer\":\"" + pointer + '"'), std::string::npos)
        << response.body;
  }
}

}  // namespace
}  // namespace pentapost::server
