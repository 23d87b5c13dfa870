#pragma once

#include "pentapost/cl/reader.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace pentapost::cl {

/// All events of one kind in their order.
template <class Kind>
std::vector<Kind> events_of(const path::ToolPath& path) {
  std::vector<Kind> found;
  for (const path::Event& event : path.events)
    if (const auto* what = std::get_if<Kind>(&event.what)) found.push_back(*what);
  return found;
}

/// The first diagnostic of that code; one of line 4294967295 where there is none.
inline Diagnostic diagnostic_of(const ReadResult& result, Code code) {
  for (const Diagnostic& diagnostic : result.diagnostics.list())
    if (diagnostic.code == code) return diagnostic;
  return {Severity::info, Code::count_, 4294967295U, "none"};
}

inline bool has(const ReadResult& result, Code code) {
  return diagnostic_of(result, code).code == code;
}

inline ReadResult read_as(std::string_view dialect, const std::string& text) {
  return read(text, {.dialect = dialect});
}

}  // namespace pentapost::cl
