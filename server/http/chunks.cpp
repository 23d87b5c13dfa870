#include "server/http/chunks.hpp"

#include <algorithm>
#include <charconv>

namespace pentapost::server {
namespace {

constexpr std::size_t longest_line = 1024;     // of a size with extensions, or a trailer
constexpr std::size_t longest_trailer = 8192;  // all trailers together

Problem damaged() {
  return Problem{.code = Code::bad_request, .message = "the chunked body is damaged"};
}

}  // namespace

Status ChunkDecoder::start_chunk(std::string_view size_text) {
  const auto digits = size_text.substr(0, size_text.find_first_of("; \t"));
  std::uint64_t size = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, size, 16);
  if (error != std::errc{} || stop != end || digits.size() > 15) return damaged();
  if (size > limit_bytes_ - total_bytes_) {
    return Problem{.code = Code::body_too_large,
                   .message = "the body is over " + std::to_string(limit_bytes_) + " bytes"};
  }
  total_bytes_ += size;
  open_bytes_ = size;
  state_ = size == 0 ? State::trailer : State::content;
  return ok();
}

Status ChunkDecoder::end_line(const std::string& line) {
  switch (state_) {
    case State::size:
      return start_chunk(line);
    case State::content_end:
      if (!line.empty()) return damaged();
      state_ = State::size;
      return ok();
    case State::trailer:
      trailer_bytes_ += line.size();
      if (trailer_bytes_ > longest_trailer) return damaged();
      if (line.empty()) state_ = State::finished;
      return ok();
    case State::content:
    case State::finished:
      break;
  }
  return damaged();
}

Result<std::size_t> ChunkDecoder::feed(std::string_view arrived, std::string& body) {
  std::size_t used = 0;
  while (used < arrived.size() && !finished()) {
    if (state_ == State::content) {
      const auto part = arrived.substr(used, std::min<std::uint64_t>(open_bytes_, arrived.size()));
      body.append(part);
      used += part.size();
      open_bytes_ -= part.size();
      if (open_bytes_ == 0) state_ = State::content_end;
      continue;
    }
    const char c = arrived[used++];
    if (c != '\n') {
      if (line_.size() == longest_line) return damaged();
      line_.push_back(c);
      continue;
    }
    if (line_.empty() || line_.back() != '\r') return damaged();
    line_.pop_back();
    if (line_.find('\r') != std::string::npos) return damaged();
    auto status = end_line(line_);
    if (!status) return std::move(status).error();
    line_.clear();
  }
  return used;
}

}  // namespace pentapost::server
