#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace pentapost::nc::lint_rules {

/// One word of a block: letters, the number behind them as written, and what stands in brackets
/// behind that. "G43.4" is {"G", "43.4"}, "CYCLE832(0.01)" {"CYCLE", "832", "0.01"}, "A3=0.5"
/// {"A", "3", "", "0.5"}.
struct LintWord {
  std::string_view letters;
  std::string_view number;
  std::string_view arguments = {};
  std::string_view assigned = {};

  bool is(std::string_view name) const { return letters == name; }
  bool is(std::string_view name, std::string_view value) const {
    return letters == name && number == value;
  }
};

struct LintBlock {
  static constexpr std::size_t most_words = 40;

  std::uint32_t line = 0;  ///< 1-based line of the text
  std::string_view text;   ///< the whole line
  std::size_t count = 0;
  std::array<LintWord, most_words> word{};
  std::uint32_t single = 0;  ///< bit i: a word of the one letter 'A' + i

  std::span<const LintWord> words() const { return {word.data(), count}; }
  bool has(char letter) const { return (single >> (letter - 'A') & 1U) != 0; }
  /// The first word of that name; nullptr: there is none.
  const LintWord* find(std::string_view name) const;
  bool has(std::string_view name, std::string_view number) const;
};

/// How a control marks what is no word.
struct LintSyntax {
  bool round_comments = false;  ///< "( )"
  bool semicolon_comments = false;
  bool calls = false;  ///< round brackets hold arguments
};

/// The blocks of a text, one a line. Takes upper case words.
class LintText {
 public:
  LintText(std::string_view text, const LintSyntax& syntax) : text_{text}, syntax_{syntax} {}

  /// The text of the next line, without words. False: the text is at its end.
  bool next(LintBlock& block);
  /// Finds the words of the line.
  void split(LintBlock& block) const;

 private:
  std::string_view text_;
  LintSyntax syntax_;
  std::size_t at_ = 0;
  std::uint32_t line_ = 0;
};

}  // namespace pentapost::nc::lint_rules
