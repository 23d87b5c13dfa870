#pragma once

#include "lib/nc/read_items.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace pentapost::sample::siemens {

/// Reads `blocks` behind a safe start; the tool is at X0 Y0 Z100 A0 C0, its length is on, and the
/// feed is 200.
inline ReadProgramItems read_after_start(std::string_view blocks,
                                         std::string_view letters = "XYZAC") {
  std::string text = "%_N_TEST_MPF\n;$PATH=/_N_MPF_DIR\nG90 G94 G17 G710\nT5\nM6\nG54 G0 X0 Y0";
  if (letters.find('A') != std::string_view::npos) text += " A0";
  if (letters.find('C') != std::string_view::npos) text += " C0";
  text += "\nD1 Z100\nF200\n";
  text.append(blocks).append("\nM30\n");
  return read_items("siemens-840d", text, letters);
}

/// The motions of `blocks` alone.
inline std::vector<nc::ReadMotion> motions_of(std::string_view blocks,
                                              std::string_view letters = "XYZAC") {
  const auto read = read_after_start(blocks, letters);
  EXPECT_EQ(read.message(), "") << blocks;
  auto motions = read.motions();
  motions.erase(motions.begin(),
                motions.begin() + std::min<std::ptrdiff_t>(2, std::ssize(motions)));
  return motions;
}

inline nc::ReadMotion last_motion(std::string_view blocks) {
  const auto motions = motions_of(blocks);
  EXPECT_FALSE(motions.empty()) << blocks;
  return motions.empty() ? nc::ReadMotion{} : motions.back();
}

inline void expect_refused(std::string_view blocks, std::string_view word,
                           Code code = Code::not_in_dialect) {
  SCOPED_TRACE(blocks);
  const auto read = read_after_start(blocks);
  ASSERT_FALSE(read.status.has_value());
  EXPECT_NE(read.message().find(word), std::string::npos) << read.message();
  EXPECT_EQ(row_of(read.status.error().code).name, row_of(code).name);
}

}  // namespace pentapost::sample::siemens
