#include "pentapost/nc/readers/axis_columns.hpp"

#include <string>

namespace pentapost::nc::readers {

Result<AxisColumns> AxisColumns::make(std::string_view letters) {
  constexpr std::string_view linear_letters = "XYZUVW", rotary_letters = "ABC";
  AxisColumns columns;
  if (letters.empty() || letters.size() > columns.letters_.size())
    return Problem{Code::unsupported_output,
                   "an NC program is read for 1 to 5 axes, not " + std::to_string(letters.size())};
  for (const char letter : letters) {
    const bool is_linear = linear_letters.find(letter) != std::string_view::npos;
    if (!is_linear && rotary_letters.find(letter) == std::string_view::npos)
      return Problem{Code::unsupported_output,
                     std::string{"'"} + letter + "' is not an axis address of this control"};
    if ((columns.letter_bits_ & letter_bit(letter)) != 0)
      return Problem{Code::unsupported_output, std::string{"two axes have the address "} + letter};
    if (is_linear)
      columns.linear_ = static_cast<std::uint8_t>(columns.linear_ | 1U << columns.size_);
    columns.letter_bits_ |= letter_bit(letter);
    columns.letters_[columns.size_++] = letter;
  }
  return columns;
}

std::size_t AxisColumns::column_of(char letter) const {
  for (std::size_t column = 0; column < size_; ++column)
    if (letters_[column] == letter) return column;
  return size_;
}

std::uint8_t AxisColumns::bit_of(char letter) const {
  const std::size_t column = column_of(letter);
  return column == size_ ? std::uint8_t{0} : static_cast<std::uint8_t>(1U << column);
}

}  // namespace pentapost::nc::readers
