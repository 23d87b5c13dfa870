#pragma once

#include <functional>
#include <string>

namespace pentapost::server {

/// A source of request ids of 32 hexadecimal digits. Safe to call from all threads.
std::function<std::string()> random_request_ids();

}  // namespace pentapost::server
