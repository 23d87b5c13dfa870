#pragma once

#include <string>
#include <string_view>

namespace pentapost::server {

/// `text` as a gzip stream, at the level that costs least time. Throws std::runtime_error where
/// zlib fails.
std::string gzip(std::string_view text);

}  // namespace pentapost::server
