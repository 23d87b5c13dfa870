#pragma once

#include "pentapost/machine/library.hpp"

#include <string>

namespace pentapost::server {

/// The answer of GET /machines.
std::string machine_list_json(const machine::Library& machines);

}  // namespace pentapost::server
