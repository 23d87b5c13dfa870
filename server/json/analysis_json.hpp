#pragma once

#include "pentapost/jobs/analyse.hpp"

#include <cstddef>
#include <string>

namespace pentapost::server {

inline constexpr std::size_t most_repositionings = 100;  ///< in an answer; all are counted

/// The answer of POST /analyse.
std::string analysis_json(const jobs::AnalyseReport& report);

}  // namespace pentapost::server
