#pragma once

#include "pentapost/core/diagnostics.hpp"
#include "pentapost/path/tool_path.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pentapost::cl {

enum class Units : std::uint8_t { mm, inch };

struct ReadOptions {
  std::optional<Units> units = {};               ///< overrules the file
  std::optional<std::string_view> dialect = {};  ///< a name of dialect_names(); overrules detection
};

struct ReadResult {
  path::ToolPath path;  ///< in mm; not to be used where diagnostics has errors
  Diagnostics diagnostics;
  std::string dialect;      ///< name of the dialect that was detected or asked for
  Units units = Units::mm;  ///< of the file
  std::uint64_t lines = 0;
  std::uint64_t points = 0;  ///< GOTO read
};

/// Reads CL data of any dialect. Never throws except std::bad_alloc; linear in the length of the
/// text, memory bounded by a multiple of it.
ReadResult read(std::string_view text, const ReadOptions& options = {});

}  // namespace pentapost::cl
