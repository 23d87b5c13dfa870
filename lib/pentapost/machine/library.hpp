#pragma once

#include "pentapost/machine/definition.hpp"

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace pentapost::machine {

/// A definition and the bytes of the file it came from.
struct LibraryEntry {
  Definition definition;  ///< its sha256 is that of `bytes`
  std::string bytes;
};

/// The machines that are known by name, in memory. Immutable, so threads share it freely.
class Library {
 public:
  Library() = default;
  /// @param entries  versions as semantic_version() reads them; no name and version twice;
  ///                 otherwise std::logic_error.
  explicit Library(std::vector<LibraryEntry> entries);

  /// Newest version; nullptr: no such machine. The entry lives as long as the library.
  const LibraryEntry* find(std::string_view name) const;
  /// nullptr: no such machine, or not in this version.
  const LibraryEntry* find(std::string_view name, std::string_view version) const;

  std::vector<std::string> names() const;                            ///< sorted
  std::vector<std::string> versions(std::string_view name) const;    ///< newest first
  std::vector<std::string> near_names(std::string_view name) const;  ///< nearest first, at most 3
  bool empty() const noexcept { return entries_.empty(); }

 private:
  /// By name; newest version first.
  std::map<std::string, std::vector<LibraryEntry>, std::less<>> entries_;
};

}  // namespace pentapost::machine
