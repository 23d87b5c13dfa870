#pragma once

#include "pentapost/core/result.hpp"
#include "server/http/head.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace pentapost::server {

using Milliseconds = std::chrono::milliseconds;

/// What a client may cost. Every wait for one is bounded.
struct TransportLimits {
  HeadLimits head = {};
  std::uint64_t body_bytes = std::uint64_t{256} << 20;
  Milliseconds head_time{10'000};  ///< for a whole head
  Milliseconds idle_time{5'000};   ///< without the first byte of a request
  Milliseconds crowded_time{500};  ///< both of these, while connections wait for a thread
  Milliseconds grace_time{
      10'000};  ///< for a body or an answer, beside its size / least_bytes_per_s
  std::uint64_t least_bytes_per_s = 16'384;
  Milliseconds linger_time{1'000};  ///< for a refused client to stop sending
  std::size_t requests_per_connection = 1'000;
  int connection_threads = 64;
  int backlog = 1'024;
};

/// One client's socket, which it closes. Blocks its thread, never beyond the limits.
class Connection {
 public:
  /// What the rest of the server is doing, asked while waiting.
  struct Surroundings {
    std::function<bool()> crowded;   ///< other connections wait for a thread
    std::function<bool()> draining;  ///< the server is to end
  };
  Connection(int socket, const TransportLimits& limits, Surroundings surroundings);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  enum class Arrival { head, nothing, too_slow, too_large };
  /// Waits for a request's head. `nothing`: the client left, or was silent for too long.
  /// @param head_text  without the empty line at its end.
  Arrival read_head(std::string& head_text);

  /// Reads the body that `head` announces; counts while it reads.
  /// @return Problem body_too_large, too_slow, or bad_request where it is damaged or ends early.
  Status read_body(const Head& head, std::string& body);

  /// @return false: the client is gone or takes nothing any more.
  bool write(std::string_view bytes);

  /// Ends the answer and takes what the client still sends, for a bounded time: closing a socket
  /// with unread bytes would reset it, and the answer be lost.
  void linger();

 private:
  enum class Wait { ready, closed, late };
  using Clock = std::chrono::steady_clock;
  Wait wait_for(short events, Clock::time_point deadline) const;
  Wait receive(Clock::time_point deadline);  ///< appends to arrived_
  Status read_announced(std::uint64_t length, std::string& body);
  Status read_chunks(std::string& body);
  Status receive_body_part(Clock::time_point start, std::uint64_t bytes_so_far);
  Clock::time_point deadline_for(Clock::time_point start, std::uint64_t bytes) const;

  int socket_;
  TransportLimits limits_;
  Surroundings surroundings_;
  std::string arrived_;  ///< received and not used yet
};

}  // namespace pentapost::server
