#include "pentapost/json/machine_files.hpp"

#include "pentapost/core/sha256.hpp"
#include "pentapost/json/definition_json.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

namespace pentapost::json {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view released_file = "RELEASED.sha256";
constexpr std::string_view readme_file = "README.md";
constexpr std::size_t sha256_digits = 64;

/// sha256 by "<name>/<version>.json".
using Released = std::map<std::string, std::string>;

/// A file's bytes, at most `limit` + 1 of them; nullopt: not readable.
std::optional<std::string> bytes_of(const fs::path& file, std::size_t limit) {
  std::ifstream in{file, std::ios::binary};
  if (!in) return std::nullopt;
  std::string bytes(limit + 1, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (in.bad()) return std::nullopt;
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

/// What a folder holds, sorted, without hidden entries.
Result<std::vector<fs::path>> entries_of(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> entries;
  fs::directory_iterator entry{folder, error};
  for (; !error && entry != fs::directory_iterator{}; entry.increment(error))
    if (entry->path().filename().string().front() != '.') entries.push_back(entry->path());
  if (error)
    return Problem{.code = Code::definition_meaning,
                   .message = "the folder is not readable: " + error.message()};
  std::sort(entries.begin(), entries.end());
  return entries;
}

bool is_folder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}
bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

class Loader {
 public:
  Loader(const fs::path& folder, std::span<const std::string_view> dialects)
      : folder_{folder}, dialects_{dialects} {}

  LoadReport load() && {
    read_released();
    for (const auto& entry : entries_or_bad(folder_)) {
      if (is_folder(entry))
        load_machine(entry);
      else if (entry.filename() != released_file && entry.filename() != readme_file)
        add_bad(entry, "the file is misplaced; expected <name>/<version>.json");
    }
    for (const auto& [path, sha256] : released_)
      if (!is_file(folder_ / path)) add_bad(folder_ / path, "the file was released and is missing");
    return {.library = machine::Library{std::move(entries_)}, .bad = std::move(bad_)};
  }

 private:
  void add_bad(const fs::path& file, std::string message, std::string pointer = {}) {
    bad_.push_back({file, Problem{.code = Code::definition_meaning,
                                  .message = std::move(message),
                                  .pointer = std::move(pointer)}});
  }

  std::vector<fs::path> entries_or_bad(const fs::path& folder) {
    auto entries = entries_of(folder);
    if (entries) return std::move(entries).value();
    bad_.push_back({folder, std::move(entries).error()});
    return {};
  }

  /// Lines as sha256sum writes them; an empty line and one that starts with # say nothing.
  void read_released() {
    const fs::path file = folder_ / released_file;
    if (!is_file(file)) return;
    std::ifstream in{file};
    if (!in) return add_bad(file, "the file is not readable");
    std::string line;
    for (std::size_t number = 1; std::getline(in, line); ++number) {
      if (line.empty() || line.front() == '#') continue;
      const bool has_form = line.size() > sha256_digits + 2 &&
                            line.find_first_not_of("0123456789abcdef") == sha256_digits &&
                            line.compare(sha256_digits, 2, "  ") == 0;
      if (has_form)
        released_[line.substr(sha256_digits + 2)] = line.substr(0, sha256_digits);
      else
        add_bad(file, "line " + std::to_string(number) +
                          " is not of the form \"<sha256>  <name>/<version>.json\"");
    }
  }

  void load_machine(const fs::path& folder) {
    for (const auto& file : entries_or_bad(folder)) {
      if (file.extension() == ".json" && is_file(file))
        load_file(file);
      else
        add_bad(file, "the file is misplaced; expected <name>/<version>.json");
    }
  }

  void load_file(const fs::path& file) {
    auto bytes = bytes_of(file, max_definition_bytes);
    if (!bytes) return add_bad(file, "the file is not readable");
    const std::string name = file.parent_path().filename().string();
    const std::string version = file.stem().string();
    const auto released = released_.find(name + "/" + version + ".json");
    if (released != released_.end() && released->second != sha256_hex(*bytes))
      return add_bad(file, "the file was released and differs from what was released (sha256 " +
                               released->second + "); a change needs a new version");
    auto definition = definition_from_text(*bytes, dialects_);
    if (!definition) {
      bad_.push_back({file, std::move(definition).error()});
      return;
    }
    if (definition->name != name)
      return add_bad(file, "the name \"" + definition->name + "\" is not that of the folder",
                     "/name");
    if (definition->version != version)
      return add_bad(file, "the version \"" + definition->version + "\" is not that of the file",
                     "/version");
    entries_.push_back({std::move(definition).value(), *std::move(bytes)});
  }

  const fs::path& folder_;
  std::span<const std::string_view> dialects_;
  Released released_;
  std::vector<machine::LibraryEntry> entries_;
  std::vector<BadFile> bad_;
};

}  // namespace

std::string text_of(const BadFile& bad) {
  const auto& pointer = bad.problem.pointer;
  return bad.file.string() + (pointer.empty() ? "" : " at " + pointer) + ": " + bad.problem.message;
}

LoadReport load_machines(const std::filesystem::path& folder,
                         std::span<const std::string_view> dialects) {
  return Loader{folder, dialects}.load();
}

}  // namespace pentapost::json
