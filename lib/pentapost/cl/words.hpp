#pragma once

#include "pentapost/core/units.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pentapost::cl {

inline bool is_blank(char c) { return static_cast<unsigned char>(c) <= ' '; }
inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
inline bool is_letter(char c) { return upper(c) >= 'A' && upper(c) <= 'Z'; }

/// True where `text` is `word` in any case. @param word  in upper case.
bool same_word(std::string_view text, std::string_view word);

/// A number as written, with the count of its decimals.
struct Decimal {
  enum class State : std::uint8_t { number, not_a_number, not_finite };
  double value = 0.0;
  int decimals = 0;  ///< digits behind the point, less the exponent; >= 0
  State state = State::not_a_number;
  const char* next = nullptr;  ///< first character behind the number
};

/// The number at `begin`: "5.", ".25", "-.5", "+3", "1.E-3", "1.5D+02". "NAN", "INF" and numbers
/// beyond the range of double are not_finite. Correctly rounded.
Decimal read_decimal(const char* begin, const char* end);

/// The numbers of a GOTO, FROM or GODLTA.
struct Coordinates {
  enum class Fault : std::uint8_t { none, not_a_number, not_finite };
  std::array<double, 6> value{};  ///< in the file's unit; the first `count` are set
  std::size_t count = 0;          ///< readable numbers before the fault, may be more than 6
  int tip_decimals = 0;           ///< most decimals among the first three
  int axis_decimals = 0;          ///< most decimals among the others
  Fault fault = Fault::none;
};

/// Numbers parted by one comma or by blanks; a comma may follow the last.
Coordinates read_coordinates(std::string_view text);

/// A minor word, a number or a quoted text of a statement.
struct Word {
  enum class Kind : std::uint8_t { word, number, quoted, damaged };
  Kind kind = Kind::word;
  std::string_view text;
  double number = 0.0;  ///< Kind::number

  bool is(std::string_view word) const { return kind == Kind::word && same_word(text, word); }
  bool is_number() const { return kind == Kind::number; }
  /// True where nothing parts `before` from this word: "1O" is the number 1 and the word O.
  bool is_glued_to(const Word& before) const {
    return before.is_number() && before.text.data() + before.text.size() == text.data();
  }
};

/// The words of a statement behind its major word. Commas, blanks, brackets and "/" part them; a
/// number that is glued to a word ("900CCLW") is two. At most `max_words` are kept.
class Words {
 public:
  static constexpr std::size_t max_words = 512;

  void read(std::string_view text);

  std::size_t size() const noexcept { return words_.size(); }
  const Word& operator[](std::size_t i) const { return words_[i]; }
  auto begin() const { return words_.begin(); }
  auto end() const { return words_.end(); }
  bool has(std::string_view word) const;
  bool has_damage() const noexcept { return damaged_; }  ///< also: more than max_words

  /// The number directly behind `word`.
  std::optional<double> number_after(std::string_view word) const;
  /// The numbers in order, whatever words stand between them.
  std::vector<double> numbers() const;

 private:
  void read_number_or_word(std::string_view token);

  std::vector<Word> words_;
  bool damaged_ = false;
};

/// What stands directly behind a minor word.
enum class Takes : std::uint8_t { nothing, number, number_if_there, number_or_gear, on_or_off };

/// A minor word that a statement knows.
struct MinorWord {
  std::string_view word;
  Takes takes = Takes::nothing;
};

/// A statement held against the minor words that it knows.
struct FormMatch {
  std::optional<double> number = {};  ///< that no word takes
  std::string_view text = {};         ///< of the number
  std::string fault = {};             ///< what does not belong there, for messages; empty: nothing
};

/// Takes at most one number that no word takes; all else has to be in `known`.
FormMatch match_form(const Words& words, std::span<const MinorWord> known);

/// The major word at the start of a statement.
struct Major {
  std::array<char, 16> letters{};
  std::size_t size = 0;
  bool slash = false;     ///< a "/" follows
  std::string_view rest;  ///< behind the word and its slash, without blanks at its start

  std::string_view word() const { return {letters.data(), size}; }  ///< in upper case
};

/// "TOOL PATH/" is one major word, "TOOL PATH". Empty where the text starts with no letter.
Major read_major(std::string_view text);

/// At most 80 characters of `text` in double quotes, for messages; ASCII.
std::string quoted_excerpt(std::string_view text);

}  // namespace pentapost::cl
