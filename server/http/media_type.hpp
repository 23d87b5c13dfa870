#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace pentapost::server {

/// "text/plain" of "Text/Plain; charset=utf-8", in lower case.
std::string media_type_of(std::string_view content_type);

/// The parameter of a header value, without quotes: "boundary" of "multipart/form-data;
/// boundary=x". nullopt: it has none.
std::optional<std::string> parameter_of(std::string_view header_value, std::string_view name);

/// Which of `offered` a client accepts best (RFC 9110, 12.5.1); the earlier one among equals.
///
/// @param accept  the Accept header; empty: everything.
/// @return nullopt: none.
std::optional<std::string_view> negotiate(std::string_view accept,
                                          std::span<const std::string_view> offered);

/// True where the Accept-Encoding header asks for gzip.
bool accepts_gzip(std::string_view accept_encoding);

}  // namespace pentapost::server
