#include "server/app.hpp"

#include "sample_server.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <atomic>
#include <future>
#include <random>
#include <semaphore>
#include <set>

namespace pentapost::server {
namespace {

App sample_app() { return App{sample::services(), {}}; }

Request get(const std::string& path, Fields headers = {}) {
  return {.method = "GET", .path = path, .headers = std::move(headers)};
}

Request post(const std::string& type, const std::string& body, Fields query = {}) {
  return {.method = "POST",
          .path = "/post",
          .query = std::move(query),
          .headers = {{"content-type", type}},
          .body = body};
}

std::string header(const Response& response, std::string_view name) {
  const auto* const value = find_field(response.headers, name);
  return value == nullptr ? "" : *value;
}

bool has_code(const Response& response, const std::string& code) {
  return response.content_type == "application/problem+json" &&
         response.body.find("\"code\":\"" + code + '"') != std::string::npos;
}

TEST(App, ServesEveryListedPathWithGetAndHead) {
  auto app = sample_app();
  for (const char* path :
       {"/machines", "/machines/demo", "/machines/demo/versions/1.0.0", "/dialects", "/healthz",
        "/version", "/openapi.yaml", "/schemas/machine.schema.json"}) {
    SCOPED_TRACE(path);
    auto request = get(path);
    EXPECT_EQ(app.handle(request).status, 200);
    request.method = "HEAD";
    EXPECT_EQ(app.handle(request).status, 200);
  }
}

TEST(App, Answers404WhereNothingIs) {
  auto app = sample_app();
  for (const char* path :
       {"/", "", "/interpolate", "/metrics", "/docs", "/post/", "/machines/", "/machines/demo/",
        "/machines/demo/versions", "/schemas/openapi.yaml", "/schemas/../openapi.yaml", "//post"}) {
    SCOPED_TRACE(path);
    const auto response = app.handle(get(path));
    EXPECT_EQ(response.status, 404);
    EXPECT_TRUE(has_code(response, "not_found") || has_code(response, "unknown_machine"));
  }
}

TEST(App, Answers405WithTheMethodsThatServe) {
  auto app = sample_app();
  EXPECT_EQ(app.handle(get("/post")).status, 405);
  EXPECT_EQ(header(app.handle(get("/post")), "Allow"), "POST");
  for (const char* method : {"POST", "PUT", "DELETE", "PATCH", "OPTIONS", "BREW"}) {
    const auto response = app.handle({.method = method, .path = "/machines/demo"});
    EXPECT_EQ(response.status, 405);
    EXPECT_EQ(header(response, "Allow"), "GET, HEAD");
    EXPECT_TRUE(has_code(response, "method_not_allowed"));
  }
}

TEST(App, Answers406And415) {
  auto app = sample_app();
  EXPECT_EQ(app.handle(get("/machines", {{"accept", "text/html"}})).status, 406);
  for (const char* type : {"application/xml", "application/x-www-form-urlencoded", "", "json"}) {
    const auto response = app.handle(post(type, "{}"));
    EXPECT_EQ(response.status, 415);
    EXPECT_TRUE(has_code(response, "unsupported_media_type"));
  }
  EXPECT_EQ(app.handle({.method = "POST", .path = "/post"}).status, 415);
  auto compressed = post("application/json", "{}");
  compressed.headers.emplace_back("content-encoding", "gzip");
  EXPECT_EQ(app.handle(compressed).status, 415);
}

TEST(App, AnswersTheThreeFormsOfAJob) {
  auto app = sample_app();
  const auto json =
      app.handle(post("application/json; charset=utf-8", R"({"machine": "demo", "cl": "x"})"));
  EXPECT_EQ(json.status, 200);
  EXPECT_EQ(json.content_type, "application/json");
  EXPECT_TRUE(json.body.starts_with("{\"nc\":\"%\\nO1"));

  const auto text = app.handle(post("text/plain", "x", {{"machine", "demo"}}));
  EXPECT_EQ(text.status, 200);
  EXPECT_EQ(text.content_type, "text/plain; charset=utf-8");
  EXPECT_EQ(text.body, "%\nO1 (A \"B\\C\")\nM30\n%\n");

  const auto form =
      app.handle(post("multipart/form-data; boundary=b",
                      "--b\r\nContent-Disposition: form-data; name=machine\r\n\r\ndemo\r\n"
                      "--b\r\nContent-Disposition: form-data; name=cl\r\n\r\nx\r\n--b--"));
  EXPECT_EQ(form.status, 200);
  EXPECT_EQ(form.body, json.body);
}

TEST(App, AnswersATextInJsonWhereThatIsPreferred) {
  auto app = sample_app();
  auto request = post("text/plain", "x", {{"machine", "demo"}});
  request.headers.emplace_back("accept", "application/json");
  EXPECT_EQ(app.handle(request).content_type, "application/json");
  auto job = post("application/json", R"({"machine": "demo", "cl": "x"})");
  job.headers.emplace_back("accept", "text/plain");
  EXPECT_EQ(app.handle(job).content_type, "text/plain; charset=utf-8");
}

TEST(App, GivesTheJobToThePostFunction) {
  jobs::PostJob seen{.machine = sample::library().find("other")->definition, .path = {}};
  App app{sample::services([&seen](const jobs::PostJob& job) -> Result<jobs::PostReport> {
            seen = job;
            return sample::report();
          }),
          {}};
  app.handle(post("text/plain", "GOTO/1,2,3", {{"machine", "demo"}, {"tip_mm", "0.5"}}));

  EXPECT_EQ(seen.machine.name, "demo");
  EXPECT_EQ(std::get<jobs::ClText>(seen.path).text, "GOTO/1,2,3");
  EXPECT_EQ(seen.tolerances.tip_mm, 0.5);
}

TEST(App, NamesAProgramByTheFileOfAFormAlone) {
  std::string name;
  App app{sample::services([&name](const jobs::PostJob& job) -> Result<jobs::PostReport> {
            name = job.post.default_program_name;
            return sample::report();
          }),
          {}};
  app.handle(post("multipart/form-data; boundary=b",
                  "--b\r\nContent-Disposition: form-data; name=machine\r\n\r\ndemo\r\n"
                  "--b\r\nContent-Disposition: form-data; name=cl; filename=\"flange.cls\"\r\n\r\n"
                  "GOTO/1,2,3\r\n--b--"));
  EXPECT_EQ(name, "flange");
  app.handle(post("text/plain", "GOTO/1,2,3", {{"machine", "demo"}}));
  EXPECT_EQ(name, "");
}

TEST(App, RefusesQueryKeysBesideAJsonJob) {
  auto app = sample_app();
  const auto response = app.handle(
      post("application/json", R"({"machine": "demo", "cl": "x"})", {{"machine", "demo"}}));
  EXPECT_EQ(response.status, 400);
  EXPECT_TRUE(has_code(response, "unknown_key"));
  EXPECT_NE(response.body.find(R"("pointer":"/machine")"), std::string::npos) << response.body;
}

TEST(App, RefusesUnknownAndDoubleFormFields) {
  auto app = sample_app();
  const auto field = [](const std::string& name) {
    return "--b\r\nContent-Disposition: form-data; name=" + name + "\r\n\r\nx\r\n";
  };
  const std::string type = "multipart/form-data; boundary=b";
  EXPECT_TRUE(has_code(app.handle(post(type, field("extra") + "--b--")), "unknown_key"));
  EXPECT_TRUE(
      has_code(app.handle(post(type, field("cl") + field("cl") + "--b--")), "conflicting_keys"));
  EXPECT_TRUE(has_code(app.handle(post(type, "x")), "bad_form"));
}

TEST(App, TurnsAProblemOfTheJobIntoItsStatus) {
  for (const auto& [code, status] : std::vector<std::pair<Code, int>>{
           {Code::no_motion, 400}, {Code::out_of_reach, 422}, {Code::proof_failed, 500}}) {
    App app{sample::services([code = code](const jobs::PostJob&) -> Result<jobs::PostReport> {
              return Problem{.code = code, .message = "why", .cl_line = 5};
            }),
            {}};
    const auto response = app.handle(post("text/plain", "x", {{"machine", "demo"}}));
    EXPECT_EQ(response.status, status);
    EXPECT_TRUE(has_code(response, std::string{row_of(code).name}));
    ASSERT_TRUE(response.cl);
    EXPECT_EQ(response.cl->bytes, 1u);
    // printf x | sha256sum
    EXPECT_EQ(response.cl->sha256,
              "2d711642b726b04401627ca9fbac32f5c8530fb1903cc4db02258717921a4881");
  }
}

TEST(App, LeavesExceptionsToItsCaller) {
  App app{sample::services([](const jobs::PostJob&) -> Result<jobs::PostReport> {
            throw std::logic_error{"a secret"};
          }),
          {}};
  EXPECT_THROW(app.handle(post("text/plain", "x", {{"machine", "demo"}})), std::logic_error);
}

TEST(App, SurvivesRandomBytesInEveryForm) {
  auto app = sample_app();
  std::mt19937_64 random{42};
  std::string bytes(10'000'000, '\0');
  for (char& byte : bytes) byte = static_cast<char>(random());
  EXPECT_TRUE(has_code(app.handle(post("application/json", bytes)), "bad_json"));
  EXPECT_TRUE(has_code(app.handle(post("multipart/form-data; boundary=b", bytes)), "bad_form"));
  EXPECT_EQ(app.handle(post("text/plain", bytes, {{"machine", "demo"}})).status, 200);
}

TEST(App, AnswersEmptyBodies) {
  auto app = sample_app();
  EXPECT_TRUE(has_code(app.handle(post("application/json", "")), "bad_json"));
  EXPECT_TRUE(has_code(app.handle(post("multipart/form-data; boundary=b", "")), "bad_form"));
}

TEST(App, KeepsUnicodeAndNeverAnswersBytesThatAreNotUtf8) {
  auto app = sample_app();
  EXPECT_NE(app.handle(get("/machines/fr\xc3\xa4se")).body.find("fr\xc3\xa4se"), std::string::npos);
  const auto response = app.handle(get("/machines/\xff"));
  EXPECT_EQ(response.body.find('\xff'), std::string::npos);
  EXPECT_NE(response.body.find("\xef\xbf\xbd"), std::string::npos);
}

TEST(App, RefusesDoubleKeys) {
  auto app = sample_app();
  const auto response =
      app.handle(post("application/json", R"({"machine":"demo","cl":"","cl":""})"));
  EXPECT_EQ(response.status, 400);
}

TEST(App, AnswersAMachineAsTheBytesOfItsFile) {
  auto app = sample_app();
  EXPECT_EQ(app.handle(get("/machines/demo/versions/1.0.0")).body,
            sample::definition_text("demo", "1.0.0"));
  EXPECT_EQ(app.handle(get("/machines/demo")).body, sample::definition_text("demo", "1.1.0"));
}

TEST(App, Answers304ForAKnownTag) {
  auto app = sample_app();
  const auto tag = header(app.handle(get("/machines/demo")), "ETag");
  ASSERT_EQ(tag.size(), 66u);
  EXPECT_EQ(app.handle(get("/machines/demo", {{"if-none-match", tag}})).status, 304);
  EXPECT_EQ(app.handle(get("/machines/demo", {{"if-none-match", "\"x\", W/" + tag}})).status, 304);
  EXPECT_EQ(app.handle(get("/machines/demo", {{"if-none-match", "*"}})).status, 304);
  EXPECT_EQ(app.handle(get("/machines/demo/versions/1.0.0", {{"if-none-match", tag}})).status, 200);
}

TEST(App, Answers404ForUnknownMachinesAndVersions) {
  auto app = sample_app();
  for (const char* path :
       {"/machines/dmeo", "/machines/demo@1.0.0", "/machines/dmeo/versions/1.0.0"}) {
    EXPECT_TRUE(has_code(app.handle(get(path)), "unknown_machine")) << path;
  }
  const auto response = app.handle(get("/machines/demo/versions/7.0.0"));
  EXPECT_TRUE(has_code(response, "unknown_version"));
  EXPECT_NE(response.body.find("1.1.0, 1.0.0"), std::string::npos);
}

TEST(App, ListsMachinesWithTheirVersions) {
  auto app = sample_app();
  const auto body = app.handle(get("/machines")).body;
  EXPECT_TRUE(body.starts_with(
      R"({"machines":[{"name":"demo","version":"1.1.0","versions":["1.1.0","1.0.0"],"title":"A sample")"))
      << body;
}

TEST(App, EchoesAUsableRequestIdAndReplacesOthers) {
  auto app = sample_app();
  EXPECT_EQ(
      header(app.handle(get("/healthz", {{"x-request-id", "Az09-_.:/+=@~"}})), "X-Request-Id"),
      "Az09-_.:/+=@~");
  for (const std::string& bad : {std::string{}, std::string(129, 'a'), std::string{"a b"},
                                 std::string{"a\"b"}, std::string{"\xc3\xa4"}})
    EXPECT_EQ(header(app.handle(get("/healthz", {{"x-request-id", bad}})), "X-Request-Id"),
              "new-id");
}

TEST(App, CompressesBigAnswersOnlyWhereAskedTo) {
  App app{sample::services([](const jobs::PostJob&) -> Result<jobs::PostReport> {
            auto report = sample::report();
            report.nc = std::string(100'000, 'x');
            return report;
          }),
          {}};
  auto request = post("text/plain", "x", {{"machine", "demo"}});
  EXPECT_EQ(app.handle(request).body, std::string(100'000, 'x'));
  request.headers.emplace_back("accept-encoding", "br");
  EXPECT_EQ(app.handle(request).body, std::string(100'000, 'x'));
  request.headers.emplace_back("accept-encoding", "gzip");
  const auto response = app.handle(request);
  EXPECT_EQ(header(response, "Content-Encoding"), "gzip");
  EXPECT_EQ(header(response, "Vary"), "Accept-Encoding");

  z_stream stream{};
  ASSERT_EQ(inflateInit2(&stream, 15 + 16), Z_OK);
  std::string text(200'000, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(response.body.data()));
  stream.avail_in = static_cast<uInt>(response.body.size());
  stream.next_out = reinterpret_cast<Bytef*>(text.data());
  stream.avail_out = static_cast<uInt>(text.size());
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  EXPECT_EQ(text.substr(0, stream.total_out), std::string(100'000, 'x'));
  inflateEnd(&stream);
}

TEST(App, RefusesJobsBeyondTheBoundAndStartsNothing) {
  std::binary_semaphore started{0};
  std::binary_semaphore go_on{0};
  std::atomic<int> count = 0;
  App app{sample::services([&](const jobs::PostJob&) -> Result<jobs::PostReport> {
            if (++count == 1) {
              started.release();
              go_on.acquire();
            }
            return sample::report();
          }),
          {.running_jobs = 1, .waiting_jobs = 0}};
  auto first = std::async(std::launch::async, [&app] {
    return app.handle(post("text/plain", "x", {{"machine", "demo"}}));
  });
  started.acquire();
  const auto refused = app.handle(post("text/plain", "x", {{"machine", "demo"}}));
  const auto other = app.handle(get("/healthz"));
  go_on.release();

  EXPECT_EQ(refused.status, 503);
  EXPECT_TRUE(has_code(refused, "overloaded"));
  EXPECT_EQ(header(refused, "Retry-After"), "1");
  EXPECT_EQ(other.status, 200);
  EXPECT_EQ(first.get().status, 200);
  EXPECT_EQ(count, 1);
  EXPECT_EQ(app.handle(post("text/plain", "x", {{"machine", "demo"}})).status, 200);
}

TEST(App, QueuesJobsUpToTheBound) {
  std::atomic<int> running = 0;
  std::atomic<int> most = 0;
  App app{sample::services([&](const jobs::PostJob&) -> Result<jobs::PostReport> {
            most = std::max(most.load(), ++running);
            --running;
            return sample::report();
          }),
          {.running_jobs = 1, .waiting_jobs = 7}};
  std::vector<std::future<Response>> answers;
  for (int i = 0; i < 8; ++i) {
    answers.push_back(std::async(std::launch::async, [&app] {
      return app.handle(post("text/plain", "x", {{"machine", "demo"}}));
    }));
  }
  for (auto& answer : answers) EXPECT_EQ(answer.get().status, 200);
  EXPECT_EQ(most, 1);
}

TEST(Endpoints, AreThoseOfTheContract) {
  auto app = sample_app();
  const auto contract = app.handle(get("/openapi.yaml")).body;
  std::set<std::string> documented;
  for (auto at = contract.find("\n  /"); at != std::string::npos;
       at = contract.find("\n  /", at + 1)) {
    const auto path = contract.substr(at + 3, contract.find(":\n", at) - at - 3);
    const auto method = contract.find_first_not_of(" \n", contract.find('\n', at + 1));
    documented.insert(contract.substr(method, contract.find(':', method) - method) + ' ' + path);
  }
  std::set<std::string> served;
  for (const auto& endpoint : endpoints())
    served.insert((endpoint.method == "GET" ? "get " : "post ") + std::string{endpoint.path});
  EXPECT_EQ(documented, served);
}

TEST(MatchPath, FillsNamesAndNothingElse) {
  EXPECT_EQ(match_path("/a/{b}/c/{d}", "/a/x/c/y"), (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(match_path("/a/{b}", "/a/"), std::nullopt);
  EXPECT_EQ(match_path("/a/{b}", "/a/x/"), std::nullopt);
  EXPECT_EQ(match_path("/a", "/A"), std::nullopt);
}

}  // namespace
}  // namespace pentapost::server
