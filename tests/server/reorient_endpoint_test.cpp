#include "sample_server.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace pentapost::server {
namespace {

/// A server whose reorientation is known.
class ReorientEndpoint : public ::testing::Test {
 protected:
  static Services services(std::optional<jobs::ReorientJob>& seen) {
    auto services = sample::services();
    services.reorient = [&seen](const jobs::ReorientJob& job) -> Result<jobs::ReorientReport> {
      seen = job;
      jobs::ReorientReport report;
      report.machine_name = "demo";
      report.cl_sha256 = "cc";
      report.optimality_gap = job.max_tilt_deg;
      return report;
    };
    return services;
  }

  Response answer(const std::string& type, const std::string& body, Fields query = {},
                  Fields headers = {}) {
    headers.emplace_back("content-type", type);
    return app_.handle({.method = "POST",
                        .path = "/reorient",
                        .query = std::move(query),
                        .headers = std::move(headers),
                        .body = body});
  }

  std::optional<jobs::ReorientJob> seen_;
  App app_{services(seen_), {}};
};

TEST_F(ReorientEndpoint, AnswersTheThreeFormsAlike) {
  const auto text =
      answer("text/plain", "GOTO/1,2,3", {{"machine", "demo"}, {"max_tilt_deg", "12"}});
  ASSERT_EQ(text.status, 200) << text.body;
  EXPECT_EQ(text.content_type, "application/json");
  EXPECT_NE(text.body.find(R"("optimality_gap":12)"), std::string::npos) << text.body;
  EXPECT_EQ(std::get<jobs::ClText>(seen_.value().job.path).text, "GOTO/1,2,3");
  const auto json =
      answer("application/json", R"({"machine": "demo", "cl": "GOTO/1,2,3", "max_tilt_deg": 12})");
  EXPECT_EQ(json.body, text.body);
  const auto form = answer("multipart/form-data; boundary=b",
                           "--b\r\nContent-Disposition: form-data; name=cl\r\n\r\nGOTO/1,2,3\r\n"
                           "--b\r\nContent-Disposition: form-data; name=job\r\n\r\n"
                           R"({"machine": "demo", "max_tilt_deg": 12})"
                           "\r\n--b--");
  EXPECT_EQ(form.body, text.body);
}

TEST_F(ReorientEndpoint, TracesTheClDataForTheLog) {
  const auto response = answer("text/plain", "GOTO/1,2,3", {{"machine", "demo"}});
  ASSERT_TRUE(response.cl);
  EXPECT_EQ(response.cl->bytes, 10U);
  EXPECT_EQ(response.cl->sha256, "cc");
}

TEST_F(ReorientEndpoint, AnswersJsonAlone) {
  EXPECT_EQ(
      answer("text/plain", "GOTO/1,2,3", {{"machine", "demo"}}, {{"accept", "text/plain"}}).status,
      406);
}

TEST_F(ReorientEndpoint, RefusesWithThePlaceInTheJob) {
  const auto response =
      answer("application/json", R"({"machine": "demo", "cl": "", "candidates": [{"theta": 1}]})");
  EXPECT_EQ(response.status, 400);
  EXPECT_NE(response.body.find(R"("pointer":"/candidates/0/theta")"), std::string::npos)
      << response.body;
  EXPECT_FALSE(seen_);
}

TEST_F(ReorientEndpoint, RefusesTheNcPartOfAForm) {
  const auto response = answer("multipart/form-data; boundary=b",
                               "--b\r\nContent-Disposition: form-data; name=machine\r\n\r\ndemo\r\n"
                               "--b\r\nContent-Disposition: form-data; name=nc\r\n\r\n%\r\n--b--");
  EXPECT_EQ(response.status, 400);
  EXPECT_NE(response.body.find(R"("pointer":"/nc")"), std::string::npos) << response.body;
}

}  // namespace
}  // namespace pentapost::server
