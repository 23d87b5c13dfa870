#pragma once

#include "pentapost/core/result.hpp"
#include "server/http/message.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pentapost::server {

/// The head of an HTTP/1.x request, vetted so that nobody on the way can see another length of it.
struct Head {
  std::string method;
  std::string target;  ///< origin form: starts with '/', or "*"
  Fields headers;      ///< names in lower case, values trimmed
  std::optional<std::uint64_t> content_length = {};
  bool chunked = false;
  bool keep_alive = false;  ///< the client would go on with this connection
  bool expects_continue = false;

  bool has_body() const { return chunked || content_length.value_or(0) > 0; }
};

struct HeadLimits {
  std::size_t bytes = 16384;  ///< request line and all fields
  std::size_t fields = 100;
};

/// Reads the head of a request, without the empty line that ends it.
///
/// @return Problem bad_request for whatever RFC 9112 lets two readers take differently: bare LF,
///         folded lines, blanks before the colon, several or damaged Content-Length, any
///         Content-Length beside Transfer-Encoding, codings other than chunked, several Host.
///         Problem head_too_large over `limits`.
Result<Head> parse_head(std::string_view text, const HeadLimits& limits);

}  // namespace pentapost::server
