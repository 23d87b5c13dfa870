#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pentapost {

/// A decimal number held exactly: count * 10^-decimals.
double decimal_value(std::int64_t count, int decimals);

/// The count of 10^-decimals nearest to `value` (halves away from zero).
/// @param decimals  0 to 9; |value| * 10^decimals must stay below 2^53, otherwise std::logic_error.
std::int64_t decimal_count(double value, int decimals);

/// How a control spells numbers.
struct NumberStyle {
  bool plus_sign = false;       ///< "+12" rather than "12"
  bool trailing_zeros = false;  ///< "12.500" rather than "12.5"
  bool always_point = false;    ///< "12." rather than "12"
  bool leading_zero = true;     ///< "0.5" rather than ".5"
};

/// Appends count * 10^-decimals; never "-0". Exact, locale-free.
void append_decimal(std::string& out, std::int64_t count, int decimals, const NumberStyle& style);

/// Shortest text that reads back as `value`, for messages ("118.204").
std::string number_text(double value);

/// `value` with at most `decimals` places, trailing zeros trimmed, for messages.
std::string number_text(double value, int decimals);

/// The finite number at the start of `text` and how many characters it takes; nullopt: none there,
/// or it overflows. Reads "5.", ".25", "-.5", "+3", "1.E-3" and, as APT allows, "1.5D+02".
struct ParsedNumber {
  double value;
  std::size_t length;
};
std::optional<ParsedNumber> parse_number(std::string_view text);

}  // namespace pentapost
