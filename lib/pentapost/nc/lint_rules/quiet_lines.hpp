#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace pentapost::nc::lint_rules {

/// Finds the lines that no rule can mind, which are nearly all of a long program: straight moves by
/// words of axes, F and a block number, each number spelled as the control wants it.
class QuietLines {
 public:
  struct Spelling {
    bool needs_signs = false;      ///< on every axis word
    bool needs_points = false;     ///< in every axis word and F
    bool needs_line_word = false;  ///< "L" says that the line is a straight move
  };
  /// @param axis_letters  of the machine.
  QuietLines(std::string_view axis_letters, const Spelling& spelling);

  /// @param needs_feed  inverse time is on.
  bool has(std::string_view line, bool needs_feed) const;

 private:
  Spelling spelling_;
  /// What a character counts for, a byte each: axis letter, F, sign, point, "L", anything else.
  std::array<std::uint64_t, 256> counts_{};
};

}  // namespace pentapost::nc::lint_rules
