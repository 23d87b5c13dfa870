#pragma once

#include "pentapost/core/diagnostics.hpp"
#include "pentapost/core/result.hpp"
#include "server/http/message.hpp"
#include "server/json/json_writer.hpp"

#include <string_view>

namespace pentapost::server {

inline constexpr std::string_view problem_media_type = "application/problem+json";

/// HTTP status of an answer whose Problem has that code.
int status_of(Code code);

/// The answer to a request that failed (RFC 9457). Serious ones first among the diagnostics.
Response problem_response(const Problem& problem, std::string_view request_id);

/// Writes "diagnostics" (at most 100, errors first) and "diagnostics_total".
void write_diagnostics(JsonWriter& writer, const Diagnostics& diagnostics);

}  // namespace pentapost::server
