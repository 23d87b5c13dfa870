#pragma once

#include "pentapost/nc/dialect.hpp"

#include <string_view>
#include <vector>

namespace pentapost::server {

/// The names of all controller dialects.
inline std::vector<std::string_view> dialect_names() {
  std::vector<std::string_view> names;
  for (const auto* dialect : nc::dialects()) names.push_back(dialect->name);
  return names;
}

}  // namespace pentapost::server
