#pragma once

#include "pentapost/machine/library.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace pentapost::server {

/// The folder of machine definitions: `given`, or else share/pentapost/machines beside the
/// program's own folder, or else that of the source tree the program was built from.
std::filesystem::path machine_folder(const std::string& given);

/// Loads the machines of a folder and says on stderr what is wrong with them.
///
/// @return nullopt: a definition is not usable and `skip_bad` is off, or there is none at all.
std::optional<machine::Library> load_library(const std::filesystem::path& folder, bool skip_bad);

}  // namespace pentapost::server
