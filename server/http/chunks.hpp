#pragma once

#include "pentapost/core/result.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace pentapost::server {

/// Takes a chunked body (RFC 9112, 7.1) apart as it arrives. Strict: CRLF only, plain hexadecimal
/// sizes. Extensions and trailers are bounded and dropped.
class ChunkDecoder {
 public:
  /// @param limit_bytes  bound on the decoded body.
  explicit ChunkDecoder(std::uint64_t limit_bytes) : limit_bytes_{limit_bytes} {}

  /// Decodes from the start of `arrived` and appends to `body`.
  /// @return how many bytes of `arrived` were used: all of them, unless the body ends before.
  ///         Problem bad_request; Problem body_too_large as soon as a chunk's size says so.
  Result<std::size_t> feed(std::string_view arrived, std::string& body);

  bool finished() const noexcept { return state_ == State::finished; }

 private:
  enum class State { size, content, content_end, trailer, finished };
  Status end_line(const std::string& line);
  Status start_chunk(std::string_view size_text);

  std::uint64_t limit_bytes_;
  State state_ = State::size;
  std::string line_;               ///< of the size, the chunk's end or the trailer, so far
  std::uint64_t open_bytes_ = 0;   ///< of the chunk, still to come
  std::uint64_t total_bytes_ = 0;  ///< of all chunks announced
  std::size_t trailer_bytes_ = 0;
};

}  // namespace pentapost::server
