#pragma once

#include "sample_server.hpp"
#include "server/http/transport.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <mutex>
#include <string>
#include <thread>

namespace pentapost::server::sample {

inline constexpr int patience_ms =
    20'000;  // for what must happen; a test that waits this long fails

/// A raw client: what it sends is what goes over the wire.
class Client {
 public:
  explicit Client(int port) : socket_{::socket(AF_INET, SOCK_STREAM, 0)} {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    connected_ = ::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
  }
  ~Client() { ::close(socket_); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  bool connected() const { return connected_; }
  void send(std::string_view bytes) const {
    while (!bytes.empty()) {
      const auto count = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (count <= 0) return;
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
  }
  void end() const { ::shutdown(socket_, SHUT_WR); }
  /// All that comes until the server closes; "TIMEOUT" at the end where it does not.
  std::string rest() const {
    std::string text;
    while (receive(text)) {
    }
    return text;
  }
  /// What comes up to and with `end`.
  std::string until(std::string_view end) const {
    std::string text;
    while (text.find(end) == std::string::npos && receive(text)) {
    }
    return text;
  }

 private:
  bool receive(std::string& text) const {
    pollfd entry{.fd = socket_, .events = POLLIN, .revents = 0};
    if (::poll(&entry, 1, patience_ms) <= 0) {
      text += "TIMEOUT";
      return false;
    }
    char bytes[65'536];
    const auto count = ::recv(socket_, bytes, sizeof bytes, 0);
    if (count > 0) text.append(bytes, static_cast<std::size_t>(count));
    return count > 0;
  }

  int socket_;
  bool connected_ = false;
};

/// A server on a free port, drained at the end.
class Running {
 public:
  explicit Running(Services services, TransportLimits limits = {}, AppLimits app_limits = {})
      : app_{std::move(services), app_limits},
        log_{[this](const std::string& line) {
          const std::lock_guard lock{mutex_};
          log_text_ += line;
        }},
        transport_{app_, log_, limits},
        port_{transport_.bind("127.0.0.1", 0).value()},
        thread_{[this] { transport_.run(); }} {}
  ~Running() { stop(); }

  int port() const { return port_; }
  void stop() {
    if (!thread_.joinable()) return;
    transport_.stop();
    thread_.join();
  }
  std::string log_text() {
    const std::lock_guard lock{mutex_};
    return log_text_;
  }
  /// The whole answer to one request, after which the connection is closed.
  std::string answer(std::string_view request) const {
    const Client client{port_};
    client.send(request);
    client.end();
    return client.rest();
  }

 private:
  std::mutex mutex_;
  std::string log_text_;
  App app_;
  Log log_;
  Transport transport_;
  int port_;
  std::thread thread_;
};

inline std::string get(const std::string& path, const std::string& fields = "") {
  return "GET " + path + " HTTP/1.1\r\nHost: a\r\n" + fields + "\r\n";
}

inline std::string post_head(const std::string& fields) {
  return "POST /post?machine=demo HTTP/1.1\r\nHost: a\r\nContent-Type: text/plain\r\n" + fields +
         "\r\n";
}

inline bool has_status(const std::string& answer, int status) {
  return answer.starts_with("HTTP/1.1 " + std::to_string(status) + ' ');
}

inline std::size_t count_of(const std::string& text, std::string_view part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// Counts jobs, and the bytes of their CL text.
struct Counted {
  std::atomic<int> jobs = 0;
  std::atomic<std::size_t> bytes = 0;
  Services services() {
    return sample::services([this](const jobs::PostJob& job) -> Result<jobs::PostReport> {
      ++jobs;
      bytes = std::get<jobs::ClText>(job.path).text.size();
      return report();
    });
  }
};

}  // namespace pentapost::server::sample
