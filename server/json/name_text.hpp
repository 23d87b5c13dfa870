#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pentapost::server {

/// Names as a message lists them.
inline std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// A name as a message shows it: what a client sends may be long.
inline std::string quoted(std::string_view name) {
  constexpr std::size_t longest = 80;
  const bool cut = name.size() > longest;
  std::string text{"'"};
  return text.append(name.substr(0, longest)).append(cut ? "...'" : "'");
}

}  // namespace pentapost::server
