#pragma once

#include "pentapost/core/number_text.hpp"
#include "pentapost/path/motion.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pentapost::nc {

/// Appends letter, count * 10^-decimals and a blank: "X+12.5 ".
inline void append_word(std::string& out, char letter, std::int64_t count, int decimals,
                        const NumberStyle& style) {
  std::array<char, decimal_room + 2> text;
  text[0] = letter;
  const std::size_t end = 1 + write_decimal(&text[1], count, decimals, style);
  text[end] = ' ';
  out.append(text.data(), end + 1);
}

/// Appends letter, whole number and a blank: "S12000 ".
inline void append_whole_word(std::string& out, char letter, std::int64_t number) {
  append_word(out, letter, number, 0, {});
}

/// `feed` in counts of 10^-decimals: rounded down, so that the control is never told to be faster,
/// but at least one count, since F0 stops the machine.
/// @return nullopt: not finite, not above 0, or more than nine digits.
std::optional<std::int64_t> feed_count(double feed, int decimals);

/// A value that is to be rounded to the nearest count; nullopt: not finite, negative, or more than
/// nine digits.
std::optional<std::int64_t> nearest_count(double value, int decimals);

/// The columns of a Motion as a block spells them: in the order X Y Z U V W A B C.
class WordColumns {
 public:
  static constexpr std::size_t none = 5;  ///< index of a column that there is not

  /// @param whole_digits  the most digits that the control takes before the decimal point.
  /// Letters that are not 3 to 5 different ones of A to Z are a std::logic_error.
  WordColumns(const path::Motion& motion, int whole_digits);

  /// Column indices in the order of writing.
  const std::uint8_t* begin() const noexcept { return order_.data(); }
  const std::uint8_t* end() const noexcept { return order_.data() + count_; }

  std::size_t count() const noexcept { return count_; }
  char letter(std::size_t column) const { return letter_[column]; }
  int decimals(std::size_t column) const { return decimals_[column]; }
  bool is_linear(std::size_t column) const { return column < linear_columns; }
  bool fits(std::size_t column, std::int64_t count) const {
    return count <= largest_[column] && count >= -largest_[column];
  }
  /// none: the machine has no such word.
  std::size_t find(char letter) const;
  std::uint8_t all() const { return static_cast<std::uint8_t>((1U << count_) - 1U); }

 private:
  static constexpr std::size_t linear_columns = 3;
  std::size_t count_;
  std::array<std::uint8_t, 5> order_{};
  std::array<char, 5> letter_{};
  std::array<int, 5> decimals_{};
  std::array<std::int64_t, 5> largest_{};
};

}  // namespace pentapost::nc
