#pragma once

#include <optional>
#include <string>

namespace pentapost::jobs {

/// The path as a finished NC program.
struct NcProgram {
  std::string text;
  std::optional<std::string> dialect = {};  ///< of the controller; nullopt: the machine's
};

}  // namespace pentapost::jobs
