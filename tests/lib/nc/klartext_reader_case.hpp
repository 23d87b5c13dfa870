#pragma once

#include "lib/nc/read_items.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace pentapost::sample::klartext {

/// Reads blocks between BEGIN PGM and M30.
inline ReadProgramItems read(std::string_view blocks, std::string_view letters = "XYZAC") {
  return read_items("heidenhain",
                    "BEGIN PGM TEST MM\n" + std::string{blocks} + "M30\nEND PGM TEST MM\n",
                    letters);
}

inline std::vector<nc::ReadMotion> motions(std::string_view blocks) {
  const auto items = read(blocks);
  EXPECT_EQ(items.message(), "") << blocks;
  return items.motions();
}

/// The last motion; a program without one fails the test.
inline nc::ReadMotion last(std::string_view blocks) {
  const auto all = motions(blocks);
  EXPECT_FALSE(all.empty()) << blocks;
  return all.empty() ? nc::ReadMotion{} : all.back();
}

/// What stands in the message of the refusal behind "NC text line n: "; the test fails where the
/// program is read.
inline std::string refusal(std::string_view blocks) {
  const auto items = read(blocks);
  EXPECT_FALSE(items.status.has_value()) << blocks;
  const std::string message = items.message();
  EXPECT_TRUE(message.starts_with("NC text line ")) << message;
  const auto colon = message.find(": ");
  return colon == std::string::npos ? message : message.substr(colon + 2);
}

}  // namespace pentapost::sample::klartext
