#include "server/http/transport.hpp"

#include "running_server.hpp"
#include "sample_server.hpp"

#include <gtest/gtest.h>

#include <netinet/tcp.h>

#include <semaphore>
#include <stdexcept>
#include <vector>

namespace pentapost::server {
namespace {

using namespace sample;

TEST(Transport, AnswersWithDateLengthAndId) {
  const Running server{sample::services()};
  const auto answer = server.answer(get("/healthz", "X-Request-Id: mine\r\n"));

  EXPECT_TRUE(has_status(answer, 200));
  EXPECT_NE(answer.find("\r\nX-Request-Id: mine\r\n"), std::string::npos);
  EXPECT_NE(answer.find("\r\nContent-Length: 15\r\n"), std::string::npos);
  EXPECT_NE(answer.find(" GMT\r\n"), std::string::npos);
  EXPECT_TRUE(answer.ends_with("\r\n\r\n{\"status\":\"ok\"}"));
  EXPECT_EQ(count_of(answer, "Content-Length"), 1u);
}

TEST(Transport, AnswersRequestAfterRequestOnOneConnection) {
  Counted counted;
  const Running server{counted.services()};
  const auto answer =
      server.answer(get("/healthz") + post_head("Content-Length: 3\r\n") + "abc" +
                    post_head("Transfer-Encoding: chunked\r\n") + "2\r\nab\r\n0\r\n\r\n" +
                    get("/version") + get("/healthz", "Connection: close\r\n") + get("/healthz"));

  EXPECT_EQ(count_of(answer, "HTTP/1.1 200 "), 5u);
  EXPECT_EQ(count_of(answer, "Connection: close"), 1u);
  EXPECT_EQ(counted.jobs, 2);
}

TEST(Transport, SendsHeadersOnlyToHeadAndForKnownTags) {
  const Running server{sample::services()};
  const auto whole = server.answer(get("/machines/demo"));
  const auto tag_start = whole.find("ETag: ") + 6;
  const auto tag = whole.substr(tag_start, 66);
  const auto length =
      "Content-Length: " + std::to_string(sample::definition_text("demo", "1.1.0").size());
  for (const auto& request : {"HEAD /machines/demo HTTP/1.1\r\nHost: a\r\n\r\n" + std::string{},
                              get("/machines/demo", "If-None-Match: " + tag + "\r\n")}) {
    const auto answer = server.answer(request);
    EXPECT_TRUE(answer.ends_with("\r\n\r\n")) << answer;
    EXPECT_NE(answer.find(length), std::string::npos) << answer;
    EXPECT_EQ(count_of(answer, "Content-Length"), 1u);
  }
}

TEST(Transport, Answers405WithAllowEvenForMethodsThatHttplibDoesNotKnow) {
  const Running server{sample::services()};
  for (const char* method : {"DELETE", "BREW", "TRACE", "PRI", "CONNECT"}) {
    const auto answer = server.answer(std::string{method} + " /post HTTP/1.1\r\nHost: a\r\n\r\n");
    EXPECT_TRUE(has_status(answer, 405)) << answer;
    EXPECT_NE(answer.find("\r\nAllow: POST\r\n"), std::string::npos) << answer;
  }
}

TEST(Transport, RefusesAmbiguousRequestsAndReadsNothingBehindThem) {
  Counted counted;
  const Running server{counted.services()};
  const std::string smuggled = get("/smuggled");
  for (const std::string& fields : {
           std::string{"Content-Length: 0\r\nContent-Length: 40\r\n"},
           std::string{"Content-Length: 40\r\nTransfer-Encoding: chunked\r\n"},
           std::string{"Transfer-Encoding: chunked\r\nContent-Length: 0\r\n"},
           std::string{"Content-Length: abc\r\n"},
           std::string{"Transfer-Encoding: chunked, identity\r\n"},
           std::string{"Content-Length : 0\r\n"},
       }) {
    SCOPED_TRACE(fields);
    const auto answer = server.answer(post_head(fields) + "0\r\n\r\n" + smuggled);
    EXPECT_TRUE(has_status(answer, 400)) << answer;
    EXPECT_NE(answer.find("application/problem+json"), std::string::npos);
    EXPECT_EQ(count_of(answer, "HTTP/1.1 "), 1u) << answer;
  }
  EXPECT_EQ(counted.jobs, 0);
}

TEST(Transport, NeverTakesABodyForTheNextRequest) {
  const Running server{sample::services()};
  const std::string body = get("/smuggled");
  const auto length = "Content-Length: " + std::to_string(body.size()) + "\r\n";
  for (const std::string& request : {
           get("/healthz", length) + body,                                    // GET with a body
           "POST /nowhere HTTP/1.1\r\nHost: a\r\n" + length + "\r\n" + body,  // 404
           "POST /post HTTP/1.1\r\nHost: a\r\nContent-Type: a/b\r\n" + length + "\r\n" +
               body,                                                         // 415
           "DELETE /post HTTP/1.1\r\nHost: a\r\n" + length + "\r\n" + body,  // 405
           "POST /nowhere HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: chunked\r\n\r\n" +
               body,  // 404, chunked
       }) {
    SCOPED_TRACE(request);
    const auto answer = server.answer(request);
    EXPECT_EQ(count_of(answer, "HTTP/1.1 "), 1u) << answer;
    EXPECT_NE(answer.find("Connection: close"), std::string::npos);
  }
}

TEST(Transport, RefusesDamagedAndCutChunks) {
  Counted counted;
  const Running server{counted.services()};
  for (const char* chunks : {"zz\r\n", "4\r\nab", "4\r\nabcdXX", ""}) {
    const auto answer = server.answer(post_head("Transfer-Encoding: chunked\r\n") + chunks);
    EXPECT_TRUE(has_status(answer, 400)) << answer;
  }
  EXPECT_TRUE(has_status(server.answer(post_head("Content-Length: 10\r\n") + "abc"), 400));
  EXPECT_EQ(counted.jobs, 0);
}

TEST(Transport, AnswersDamagedTargetsWithAProblem) {
  const Running server{sample::services()};
  for (const char* target :
       {"/a?b?c", "/%", "/%zz", "/%00", "/?", "/a#b?c", "/%0d%0aX-Injected:%20y"}) {
    SCOPED_TRACE(target);
    const auto answer = server.answer(get(target));
    EXPECT_TRUE(has_status(answer, 400) || has_status(answer, 404)) << answer;
    EXPECT_NE(answer.find("application/problem+json"), std::string::npos);
    EXPECT_EQ(answer.find("\r\nX-Injected"), std::string::npos);
  }
}

TEST(Transport, NeverSendsBrotliAndIgnoresRanges) {
  auto services = sample::services([](const jobs::PostJob&) -> Result<jobs::PostReport> {
    auto report = sample::report();
    report.nc = std::string(1'000'000, 'x');
    return report;
  });
  const Running server{std::move(services)};
  const auto answer = server.answer(
      post_head("Content-Length: 0\r\nAccept-Encoding: br, deflate\r\nRange: bytes=0-0,1-1\r\n"));
  EXPECT_TRUE(has_status(answer, 200));
  EXPECT_EQ(answer.find("Content-Encoding"), std::string::npos);
  EXPECT_TRUE(answer.ends_with("\r\n\r\n" + std::string(1'000'000, 'x')));
  const auto zipped =
      server.answer(post_head("Content-Length: 0\r\nAccept-Encoding: br, gzip\r\n"));
  EXPECT_NE(zipped.find("Content-Encoding: gzip"), std::string::npos);
  EXPECT_LT(zipped.size(), 20'000u);
}

TEST(Transport, AnswersADefectWithoutItsText) {
  auto services = sample::services([](const jobs::PostJob&) -> Result<jobs::PostReport> {
    throw std::runtime_error{"a secret of the house"};
  });
  Running server{std::move(services)};
  const auto answer = server.answer(post_head("Content-Length: 0\r\nX-Request-Id: the-id\r\n"));
  server.stop();

  EXPECT_TRUE(has_status(answer, 500));
  EXPECT_NE(answer.find("\"code\":\"defect\""), std::string::npos);
  EXPECT_NE(answer.find("\"request_id\":\"the-id\""), std::string::npos);
  EXPECT_EQ(answer.find("secret"), std::string::npos);
  EXPECT_EQ(answer.find("EXCEPTION_WHAT"), std::string::npos);
  EXPECT_NE(server.log_text().find("a secret of the house"), std::string::npos);
  EXPECT_NE(server.log_text().find("the-id"), std::string::npos);
}

TEST(Transport, LogsWhyAProgramFailedItsProof) {
  auto services = sample::services([](const jobs::PostJob&) -> Result<jobs::PostReport> {
    return Problem{.code = Code::proof_failed, .message = "block 7 leaves the path"};
  });
  Running server{std::move(services)};
  const auto answer = server.answer(post_head("Content-Length: 0\r\nX-Request-Id: the-id\r\n"));
  server.stop();

  EXPECT_TRUE(has_status(answer, 500));
  EXPECT_NE(server.log_text().find(
                R"("event":"defect","request_id":"the-id","what":"block 7 leaves the path")"),
            std::string::npos)
      << server.log_text();
}

TEST(Transport, LogsRequestsWithoutTheirBody) {
  Running server{sample::services()};
  server.answer(post_head("Content-Length: 16\r\n") + "PARTNO/TOPSECRET");
  server.stop();

  const auto log = server.log_text();
  EXPECT_NE(log.find(R"("method":"POST","path":"/post","status":200)"), std::string::npos) << log;
  EXPECT_NE(log.find(R"("cl_bytes":16)"), std::string::npos) << log;
  EXPECT_EQ(log.find("TOPSECRET"), std::string::npos);
}

TEST(Transport, AsksForTheBodyOfACarefulClient) {
  const Running server{sample::services()};
  const Client client{server.port()};
  client.send(post_head("Content-Length: 3\r\nExpect: 100-continue\r\nConnection: close\r\n"));
  EXPECT_EQ(client.until("\r\n\r\n"), "HTTP/1.1 100 Continue\r\n\r\n");
  client.send("abc");
  EXPECT_TRUE(has_status(client.rest(), 200));
}

TEST(Transport, RefusesACarefulClientWithoutAskingForTheBody) {
  TransportLimits limits;
  limits.body_bytes = 10;
  const Running server{sample::services(), limits};
  const auto answer = server.answer(post_head("Content-Length: 11\r\nExpect: 100-continue\r\n"));
  EXPECT_TRUE(has_status(answer, 413)) << answer;
}

TEST(Transport, SharesItsPortWithNobody) {
  const Running server{sample::services()};
  App app{sample::services(), {}};
  Log log{[](const std::string&) {}};
  Transport second{app, log, {}};
  EXPECT_FALSE(second.bind("127.0.0.1", server.port()));

  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  const int on = 1;
  ::setsockopt(socket, SOL_SOCKET, SO_REUSEPORT, &on, sizeof on);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(server.port()));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  EXPECT_NE(::bind(socket, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  ::close(socket);
}

TEST(Transport, DrainsWhatIsUnderWayAndDropsIdleConnections) {
  std::binary_semaphore started{0};
  std::binary_semaphore go_on{0};
  auto services = sample::services([&](const jobs::PostJob&) -> Result<jobs::PostReport> {
    started.release();
    go_on.acquire();
    return sample::report();
  });
  TransportLimits limits;
  limits.idle_time = Milliseconds{600'000};
  Running server{std::move(services), limits};
  const Client idle{server.port()};
  idle.send(get("/healthz"));
  EXPECT_TRUE(has_status(idle.until("}"), 200));
  const Client busy{server.port()};
  busy.send(post_head("Content-Length: 0\r\n"));
  started.acquire();
  std::thread stopping{[&server] { server.stop(); }};
  EXPECT_EQ(idle.rest(), "");
  go_on.release();
  const auto answer = busy.rest();
  stopping.join();

  EXPECT_TRUE(has_status(answer, 200)) << answer;
  EXPECT_NE(answer.find("Connection: close"), std::string::npos);
}

/// Sockets of this process (the server is in it) with that local port.
std::vector<int> sockets_of(int port) {
  std::vector<int> sockets;
  for (int descriptor = 0; descriptor < 1'024; ++descriptor) {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    if (::getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &size) != 0) continue;
    if (address.sin_family == AF_INET && ntohs(address.sin_port) == port)
      sockets.push_back(descriptor);
  }
  return sockets;
}

int option_of(int socket, int level, int name) {
  int option = -1;
  socklen_t size = sizeof option;
  ::getsockopt(socket, level, name, &option, &size);
  return option;
}

TEST(Transport, ListensWithALongBacklogAlone) {
  const Running server{sample::services()};
  const auto sockets = sockets_of(server.port());
  ASSERT_EQ(sockets.size(), 1u);
  tcp_info info{};
  socklen_t size = sizeof info;
  ASSERT_EQ(::getsockopt(sockets[0], IPPROTO_TCP, TCP_INFO, &info, &size), 0);

  EXPECT_EQ(info.tcpi_sacked, 1'024u);  // of a listening socket: its longest queue
  EXPECT_EQ(option_of(sockets[0], SOL_SOCKET, SO_REUSEPORT), 0);
}

TEST(Transport, SendsWithoutDelay) {
  // Nagle's algorithm with delayed acknowledgements makes each answer wait 40 ms.
  const Running server{sample::services()};
  const Client client{server.port()};
  client.send(get("/healthz"));
  ASSERT_TRUE(has_status(client.until("}"), 200));
  for (const int socket : sockets_of(server.port()))
    EXPECT_NE(option_of(socket, IPPROTO_TCP, TCP_NODELAY), 0);
}

TEST(Transport, StopsBeforeItRuns) {
  App app{sample::services(), {}};
  Log log{[](const std::string&) {}};
  Transport transport{app, log, {}};
  ASSERT_TRUE(transport.bind("127.0.0.1", 0));
  transport.stop();
  transport.run();
}

TEST(Transport, SaysThatAnAddressIsNotItsOwn) {
  App app{sample::services(), {}};
  Log log{[](const std::string&) {}};
  Transport transport{app, log, {}};
  EXPECT_FALSE(transport.bind("192.0.2.1", 0));  // RFC 5737: an address of documentation
}

}  // namespace
}  // namespace pentapost::server
