#pragma once

#include "pentapost/jobs/reorient.hpp"

#include <string>

namespace pentapost::server {

/// The answer of POST /reorient.
std::string reorient_json(const jobs::ReorientReport& report);

}  // namespace pentapost::server
