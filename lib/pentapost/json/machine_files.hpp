#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/machine/library.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pentapost::json {

/// A file of a machine folder that is not usable.
struct BadFile {
  std::filesystem::path file;
  Problem problem;  ///< with the JSON pointer, where it is about a value
};

/// "machines/demo/1.0.0.json at /axes/X/range_mm: found ...", for a log or a terminal.
std::string text_of(const BadFile& bad);

struct LoadReport {
  machine::Library library;    ///< of the usable files
  std::vector<BadFile> bad{};  ///< the caller decides whether they are fatal
};

/// Loads every <name>/<version>.json of a folder.
///
/// A file is bad if definition_from_text says so, if its name or version is not that of its path,
/// or if it was released (RELEASED.sha256 has a line "<sha256>  <name>/<version>.json") and differs
/// or is missing. README.md, RELEASED.sha256 and hidden entries are passed over; anything else that
/// is not <name>/<version>.json is bad too, so that a misplaced file does not go unnoticed.
///
/// @param dialects  names that controller.dialect may have.
LoadReport load_machines(const std::filesystem::path& folder,
                         std::span<const std::string_view> dialects);

}  // namespace pentapost::json
