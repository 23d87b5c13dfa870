#include "server/machine_folder.hpp"

#include "pentapost/jobs/post.hpp"
#include "pentapost/json/machine_files.hpp"
#include "server/dialect_names.hpp"

#include <iostream>
#include <system_error>
#include <utility>
#include <vector>

namespace pentapost::server {

namespace {

/// Takes machines whose controller's options are not usable out of the library.
json::LoadReport with_usable_options(json::LoadReport loaded, const std::filesystem::path& folder) {
  std::vector<machine::LibraryEntry> usable;
  for (const auto& name : loaded.library.names()) {
    for (const auto& version : loaded.library.versions(name)) {
      const auto* const entry = loaded.library.find(name, version);
      if (auto status = jobs::check_options(entry->definition); status)
        usable.push_back(*entry);
      else
        loaded.bad.push_back({folder / name / (version + ".json"), std::move(status).error()});
    }
  }
  loaded.library = machine::Library{std::move(usable)};
  return loaded;
}

}  // namespace

std::filesystem::path machine_folder(const std::string& given) {
  if (!given.empty()) return given;
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  auto installed = program.parent_path().parent_path() / "share/pentapost/machines";
  if (!error && std::filesystem::is_directory(installed, error)) return installed;
  return PENTAPOST_SOURCE_MACHINES;
}

std::optional<machine::Library> load_library(const std::filesystem::path& folder, bool skip_bad) {
  const auto dialects = dialect_names();
  auto loaded = with_usable_options(json::load_machines(folder, dialects), folder);
  for (const auto& bad : loaded.bad) std::cerr << json::text_of(bad) << '\n';
  if (!loaded.bad.empty() && !skip_bad) return std::nullopt;
  if (loaded.library.empty()) {
    std::cerr << "no machine definition in " << folder.string() << '\n';
    return std::nullopt;
  }
  return std::move(loaded.library);
}

}  // namespace pentapost::server
