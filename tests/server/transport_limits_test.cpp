#include "server/http/connection.hpp"

#include "running_server.hpp"
#include "sample_server.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <semaphore>
#include <vector>

namespace pentapost::server {
namespace {

using namespace sample;

TEST(Transport, RefusesAnAnnouncedBodyOverTheLimitBeforeItComes) {
  Counted counted;
  TransportLimits limits;
  limits.body_bytes = 1'000;
  const Running server{counted.services(), limits};
  const Client client{server.port()};
  client.send(post_head("Content-Length: 1001\r\n"));
  const auto answer = client.until("}");

  EXPECT_TRUE(has_status(answer, 413)) << answer;
  EXPECT_EQ(counted.jobs, 0);
}

TEST(Transport, CountsChunkedBodiesToo) {
  Counted counted;
  TransportLimits limits;
  limits.body_bytes = 1'000;
  const Running server{counted.services(), limits};
  std::string chunks;
  for (int i = 0; i < 10; ++i) chunks += "64\r\n" + std::string(100, 'x') + "\r\n";
  const auto fits =
      server.answer(post_head("Transfer-Encoding: chunked\r\n") + chunks + "0\r\n\r\n");
  EXPECT_TRUE(has_status(fits, 200)) << fits;
  EXPECT_EQ(counted.bytes, 1'000u);
  const auto over =
      server.answer(post_head("Transfer-Encoding: chunked\r\n") + chunks + "1\r\nx\r\n0\r\n\r\n");
  EXPECT_TRUE(has_status(over, 413)) << over;
  EXPECT_EQ(counted.jobs, 1);
}

TEST(Transport, GivesTheRefusalToAClientThatGoesOnSending) {
  TransportLimits limits;
  limits.body_bytes = 1'000;
  const Running server{sample::services(), limits};
  const auto answer =
      server.answer(post_head("Content-Length: 5000000\r\n") + std::string(5'000'000, 'x'));
  EXPECT_TRUE(has_status(answer, 413)) << answer.substr(0, 100);
}

TEST(Transport, BoundsTheHead) {
  const Running server{sample::services()};
  std::string flood;
  for (int i = 0; i < 5'000; ++i) flood += "X-" + std::to_string(i) + ": y\r\n";
  EXPECT_TRUE(has_status(server.answer(get("/healthz", flood)), 431));
  EXPECT_TRUE(has_status(server.answer(get("/" + std::string(12'000, 'a'))), 431));
  EXPECT_TRUE(has_status(
      server.answer(get("/healthz", "X-A: " + std::string(100'000, 'a') + "\r\n")), 431));
}

TEST(Transport, ClosesSilentAndSlowClients) {
  TransportLimits limits;
  limits.idle_time = Milliseconds{200};
  limits.head_time = Milliseconds{300};
  limits.grace_time = Milliseconds{300};
  const Running server{sample::services(), limits};
  const Client silent{server.port()};
  const Client slow_head{server.port()};
  const Client slow_body{server.port()};
  slow_head.send("GET / HTTP/1.1\r\nX-A: ");
  slow_body.send(post_head("Content-Length: 10\r\n") + "abc");

  EXPECT_EQ(silent.rest(), "");
  EXPECT_TRUE(has_status(slow_head.rest(), 408));
  EXPECT_TRUE(has_status(slow_body.rest(), 408));
}

TEST(Transport, ClosesClientsThatDripWhateverTheyDrip) {
  TransportLimits limits;
  limits.head_time = Milliseconds{300};
  const Running server{sample::services(), limits};
  const Client client{server.port()};
  std::atomic<bool> ended = false;
  std::thread drip{[&] {
    client.send("GET / HTTP/1.1\r\n");
    while (!ended) {
      client.send("X-A: b\r\n");
      std::this_thread::sleep_for(std::chrono::milliseconds{20});
    }
  }};
  const auto answer = client.until("}");
  ended = true;
  drip.join();
  EXPECT_TRUE(has_status(answer, 408) || has_status(answer, 431)) << answer;
}

TEST(Transport, ServesOthersBesideMoreSilentAndDrippingClientsThanThreads) {
  TransportLimits limits;
  limits.connection_threads = 2;
  limits.crowded_time = Milliseconds{50};
  limits.idle_time = limits.head_time =
      Milliseconds{600'000};  // only crowding can end them in time
  const Running server{sample::services(), limits};
  std::vector<std::unique_ptr<Client>> clients;
  for (int i = 0; i < 12; ++i) {
    clients.push_back(std::make_unique<Client>(server.port()));
    if (i % 2 == 0) clients.back()->send("GET / HTTP/1.1\r\nX: ");
  }
  EXPECT_TRUE(has_status(server.answer(get("/healthz")), 200));
}

TEST(Transport, GivesUpOnAClientThatTakesNothing) {
  auto services = sample::services([](const jobs::PostJob&) -> Result<jobs::PostReport> {
    auto report = sample::report();
    report.nc = std::string(50'000'000, 'x');
    return report;
  });
  TransportLimits limits;
  limits.connection_threads = 1;
  limits.grace_time = Milliseconds{200};
  limits.least_bytes_per_s = 1'000'000'000;
  const Running server{std::move(services), limits};
  const Client taker_of_nothing{server.port()};
  taker_of_nothing.send(post_head("Content-Length: 0\r\n"));
  EXPECT_TRUE(has_status(server.answer(get("/healthz")), 200));
}

TEST(Transport, Answers503WithNothingStarted) {
  std::binary_semaphore started{0};
  std::binary_semaphore go_on{0};
  std::atomic<int> jobs = 0;
  auto services = sample::services([&](const jobs::PostJob&) -> Result<jobs::PostReport> {
    ++jobs;
    started.release();
    go_on.acquire();
    return sample::report();
  });
  const Running server{std::move(services), {}, {.running_jobs = 1, .waiting_jobs = 0}};
  const Client busy{server.port()};
  busy.send(post_head("Content-Length: 0\r\nConnection: close\r\n"));
  started.acquire();
  const auto body = get("/smuggled");
  const auto refused =
      server.answer(post_head("Content-Length: " + std::to_string(body.size()) + "\r\n") + body);
  go_on.release();

  EXPECT_TRUE(has_status(refused, 503)) << refused;
  EXPECT_NE(refused.find("\r\nRetry-After: 1\r\n"), std::string::npos);
  EXPECT_EQ(count_of(refused, "HTTP/1.1 "), 1u);
  EXPECT_TRUE(has_status(busy.rest(), 200));
  EXPECT_EQ(jobs, 1);
}

TEST(Transport, TakesABurstOfConnections) {
  TransportLimits limits;
  limits.connection_threads = 4;
  const Running server{sample::services(), limits};
  std::vector<std::unique_ptr<Client>> clients;
  for (int i = 0; i < 300; ++i) clients.push_back(std::make_unique<Client>(server.port()));
  for (const auto& client : clients) client->send(get("/healthz", "Connection: close\r\n"));
  int answered = 0;
  for (const auto& client : clients) answered += has_status(client->rest(), 200) ? 1 : 0;
  EXPECT_EQ(answered, 300);
}

}  // namespace
}  // namespace pentapost::server
