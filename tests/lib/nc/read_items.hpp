#pragma once

#include "pentapost/nc/reader.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace pentapost::sample {

/// What a reader made of a program.
struct ReadProgramItems {
  Status status = ok();
  std::vector<nc::ReadItem> items;

  template <class What>
  std::vector<What> all() const {
    std::vector<What> found;
    for (const auto& item : items)
      if (const auto* what = std::get_if<What>(&item.what)) found.push_back(*what);
    return found;
  }
  std::vector<nc::ReadMotion> motions() const { return all<nc::ReadMotion>(); }
  /// Empty: there is no Problem.
  std::string message() const { return status ? std::string{} : status.error().message; }
};

inline ReadProgramItems read_items(std::string_view dialect, std::string_view text,
                                   std::string_view letters = "XYZAC") {
  ReadProgramItems read;
  read.status = nc::find_reader(dialect)->read(text, {.letters = std::string{letters}},
                                               [&](const nc::ReadItem& item) {
                                                 read.items.push_back(item);
                                                 return ok();
                                               });
  return read;
}

}  // namespace pentapost::sample
