#pragma once

#include "pentapost/jobs/compare.hpp"
#include "pentapost/machine/library.hpp"

#include <string>

namespace pentapost::server {

/// The answer of POST /compare. A Problem's pointer is into the request: a machine of the library
/// has no values there. What a defect says is left to the log.
std::string compare_json(const jobs::CompareReport& report, const machine::Library& machines);

/// What defects of rows say, one a line with its machine; empty: there are none.
std::string defects_of(const jobs::CompareReport& report);

}  // namespace pentapost::server
