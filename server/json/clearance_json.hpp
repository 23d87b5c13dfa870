#pragma once

#include "pentapost/jobs/clearances.hpp"
#include "pentapost/json/strict_reader.hpp"

#include <optional>

namespace pentapost::server {

/// Reads what holder, spindle, table and jig look like: the key clearance. What is not given keeps
/// its default, or is that of the machine definition.
///
/// Failures are kept in the document: wrong_type, out_of_domain, missing_key.
/// @return nullopt: not given.
std::optional<clearance::Model> read_clearance(const json::Object& job);

}  // namespace pentapost::server
