#include "server/http/connection.hpp"

#include "server/http/chunks.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

namespace pentapost::server {
namespace {

constexpr std::string_view head_end = "\r\n\r\n";
constexpr Milliseconds look_around{100};       // between two questions to the surroundings
constexpr std::size_t receive_bytes = 65'536;  // at once
constexpr std::size_t most_reserved = std::size_t{16} << 20;  // ahead of the bytes themselves

}  // namespace

Connection::Connection(int socket, const TransportLimits& limits, Surroundings surroundings)
    : socket_{socket}, limits_{limits}, surroundings_{std::move(surroundings)} {}

Connection::~Connection() { ::close(socket_); }

Connection::Wait Connection::wait_for(short events, Clock::time_point deadline) const {
  for (;;) {
    const auto rest = std::chrono::ceil<Milliseconds>(deadline - Clock::now());
    if (rest <= Milliseconds{0}) return Wait::late;
    pollfd entry{.fd = socket_, .events = events, .revents = 0};
    const int count = ::poll(&entry, 1, static_cast<int>(rest.count()));
    if (count > 0) return Wait::ready;  // an error or a hang-up shows at the next call
    if (count < 0 && errno != EINTR) return Wait::closed;
  }
}

Connection::Wait Connection::receive(Clock::time_point deadline) {
  std::array<char, receive_bytes> bytes;
  for (;;) {
    if (const auto wait = wait_for(POLLIN, deadline); wait != Wait::ready) return wait;
    const auto count = ::recv(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT);
    if (count > 0) {
      arrived_.append(bytes.data(), static_cast<std::size_t>(count));
      return Wait::ready;
    }
    if (count == 0) return Wait::closed;
    if (errno != EINTR && errno != EAGAIN) return Wait::closed;
  }
}

Connection::Arrival Connection::read_head(std::string& head_text) {
  const auto start = Clock::now();
  for (std::size_t scanned = 0;;) {
    while (scanned == 0 && arrived_.starts_with("\r\n")) arrived_.erase(0, 2);  // RFC 9112, 2.2
    if (const auto end = arrived_.find(head_end, scanned); end != std::string::npos) {
      head_text = arrived_.substr(0, end);
      arrived_.erase(0, end + head_end.size());
      return Arrival::head;
    }
    if (arrived_.size() > limits_.head.bytes) return Arrival::too_large;
    scanned = arrived_.size() - std::min(arrived_.size(), head_end.size() - 1);

    auto bound = arrived_.empty() ? limits_.idle_time : limits_.head_time;
    if (surroundings_.crowded()) bound = std::min(bound, limits_.crowded_time);
    const auto deadline = start + bound;
    const bool late = Clock::now() >= deadline;
    if (late && !arrived_.empty()) return Arrival::too_slow;
    if (late || (arrived_.empty() && surroundings_.draining())) return Arrival::nothing;
    if (receive(std::min(deadline, Clock::now() + look_around)) == Wait::closed)
      return Arrival::nothing;
  }
}

Connection::Clock::time_point Connection::deadline_for(Clock::time_point start,
                                                       std::uint64_t bytes) const {
  return start + limits_.grace_time + Milliseconds{bytes * 1'000 / limits_.least_bytes_per_s};
}

Status Connection::receive_body_part(Clock::time_point start, std::uint64_t bytes_so_far) {
  switch (receive(deadline_for(start, bytes_so_far))) {
    case Wait::ready:
      return ok();
    case Wait::closed:
      return Problem{.code = Code::bad_request,
                     .message = "the body ends before its announced end"};
    case Wait::late:
      break;
  }
  return Problem{.code = Code::too_slow, .message = "the body arrives too slowly"};
}

Status Connection::read_announced(std::uint64_t length, std::string& body) {
  const auto start = Clock::now();
  body.reserve(std::min<std::uint64_t>(length, most_reserved));
  for (;;) {
    const auto missing = static_cast<std::size_t>(length - body.size());
    const auto part = std::min(missing, arrived_.size());
    body.append(arrived_, 0, part);
    arrived_.erase(0, part);
    if (body.size() == length) return ok();
    if (auto status = receive_body_part(start, body.size()); !status) return status;
  }
}

Status Connection::read_chunks(std::string& body) {
  const auto start = Clock::now();
  ChunkDecoder decoder{limits_.body_bytes};
  for (;;) {
    const auto used = decoder.feed(arrived_, body);
    if (!used) return used.error();
    arrived_.erase(0, *used);
    if (decoder.finished()) return ok();
    if (auto status = receive_body_part(start, body.size()); !status) return status;
  }
}

Status Connection::read_body(const Head& head, std::string& body) {
  const auto length = head.content_length.value_or(0);
  if (length > limits_.body_bytes) {
    return Problem{.code = Code::body_too_large,
                   .message = "the body of " + std::to_string(length) +
                              " bytes is over the limit of " + std::to_string(limits_.body_bytes)};
  }
  if (head.expects_continue && head.has_body() && arrived_.empty() &&
      !write("HTTP/1.1 100 Continue\r\n\r\n"))
    return Problem{.code = Code::bad_request, .message = "the client is gone"};
  return head.chunked ? read_chunks(body) : read_announced(length, body);
}

bool Connection::write(std::string_view bytes) {
  const auto start = Clock::now();
  for (std::size_t written = 0; written < bytes.size();) {
    const auto rest = bytes.substr(written);
    const auto count = ::send(socket_, rest.data(), rest.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (count > 0) {
      written += static_cast<std::size_t>(count);
      continue;
    }
    if (errno != EINTR && errno != EAGAIN) return false;
    if (wait_for(POLLOUT, deadline_for(start, written)) != Wait::ready) return false;
  }
  return true;
}

void Connection::linger() {
  ::shutdown(socket_, SHUT_WR);
  const auto deadline = Clock::now() + limits_.linger_time;
  do {
    arrived_.clear();
  } while (receive(deadline) == Wait::ready);
}

}  // namespace pentapost::server
