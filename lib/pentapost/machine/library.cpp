#include "pentapost/machine/library.hpp"

#include "pentapost/machine/near_names.hpp"
#include "pentapost/machine/semantic_version.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace pentapost::machine {
namespace {

SemanticVersion version_of(const LibraryEntry& entry) {
  const auto version = semantic_version(entry.definition.version);
  if (!version)
    throw std::logic_error{"Library: \"" + entry.definition.version + "\" is not a version"};
  return *version;
}

}  // namespace

Library::Library(std::vector<LibraryEntry> entries) {
  for (auto& entry : entries) {
    auto& same_name = entries_[entry.definition.name];
    same_name.push_back(std::move(entry));
  }
  for (auto& [name, same_name] : entries_) {
    std::sort(same_name.begin(), same_name.end(),
              [](const auto& x, const auto& y) { return version_of(y) < version_of(x); });
    const auto twice = std::adjacent_find(
        same_name.begin(), same_name.end(),
        [](const auto& x, const auto& y) { return version_of(x) == version_of(y); });
    if (twice != same_name.end())
      throw std::logic_error{"Library: " + name + " " + twice->definition.version + " twice"};
  }
}

const LibraryEntry* Library::find(std::string_view name) const {
  const auto found = entries_.find(name);
  return found == entries_.end() ? nullptr : &found->second.front();
}

const LibraryEntry* Library::find(std::string_view name, std::string_view version) const {
  const auto found = entries_.find(name);
  if (found == entries_.end()) return nullptr;
  const auto entry =
      std::find_if(found->second.begin(), found->second.end(),
                   [&](const auto& each) { return each.definition.version == version; });
  return entry == found->second.end() ? nullptr : &*entry;
}

std::vector<std::string> Library::names() const {
  std::vector<std::string> names;
  for (const auto& [name, entries] : entries_) names.push_back(name);
  return names;
}

std::vector<std::string> Library::versions(std::string_view name) const {
  std::vector<std::string> versions;
  if (const auto found = entries_.find(name); found != entries_.end())
    for (const auto& entry : found->second) versions.push_back(entry.definition.version);
  return versions;
}

std::vector<std::string> Library::near_names(std::string_view name) const {
  return machine::near_names(name, names());
}

}  // namespace pentapost::machine
