#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/nc/readers/words.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace pentapost::nc::readers {

/// Where every axis is, as far as the program says: one column a letter.
class AxisColumns {
 public:
  /// @param letters  as ReaderSetup::letters.
  /// @return Problem unsupported_output for a letter that is no axis address or stands twice, or
  /// more than five.
  static Result<AxisColumns> make(std::string_view letters);

  std::array<double, 5> position{};  ///< mm and degrees; only where known
  std::uint8_t known = 0;            ///< bit i: position[i] is known

  std::size_t size() const { return size_; }
  char letter(std::size_t column) const { return letters_[column]; }
  std::uint32_t letter_bits() const { return letter_bits_; }
  bool is_linear(std::size_t column) const { return (linear_ >> column & 1U) != 0; }
  std::uint8_t linear() const { return linear_; }
  std::uint8_t all() const { return static_cast<std::uint8_t>((1U << size_) - 1U); }
  /// Bit of the column of `letter`; 0: the machine has no such axis.
  std::uint8_t bit_of(char letter) const;
  /// Column of `letter`; size() if there is none.
  std::size_t column_of(char letter) const;

  void forget(std::uint8_t columns) { known = static_cast<std::uint8_t>(known & ~columns); }

 private:
  AxisColumns() = default;
  std::array<char, 5> letters_{};
  std::size_t size_ = 0;
  std::uint32_t letter_bits_ = 0;
  std::uint8_t linear_ = 0;
};

}  // namespace pentapost::nc::readers
