#pragma once

#include "pentapost/jobs/post.hpp"

#include <string>

namespace pentapost::server {

/// The report alone, without the NC program.
std::string report_json(const jobs::PostReport& report);

/// The answer of POST /post: {"nc": ..., "report": {...}}.
std::string post_answer_json(const jobs::PostReport& report);

}  // namespace pentapost::server
