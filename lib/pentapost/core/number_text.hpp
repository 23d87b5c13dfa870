#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pentapost {

/// The double nearest to count * 10^-decimals, that is the one that its text reads back as.
/// @param count  |count| below 2^53: larger ones are rounded twice.
/// @param decimals  0 to 9, otherwise std::logic_error.
double decimal_value(std::int64_t count, int decimals);

/// The count of 10^-decimals nearest to `value`; a value exactly between two goes away from zero.
/// @param value  |value| * 10^decimals below 2^52, otherwise std::logic_error.
/// @param decimals  0 to 9, otherwise std::logic_error.
std::int64_t decimal_count(double value, int decimals);

/// How a control spells numbers.
struct NumberStyle {
  bool plus_sign = false;       ///< "+12" rather than "12"
  bool trailing_zeros = false;  ///< "12.500" rather than "12.5"
  bool always_point = false;    ///< "12." rather than "12"
  bool leading_zero = true;     ///< "0.5" rather than ".5"
};

/// Appends count * 10^-decimals; never "-0". Exact, locale-free.
/// @param decimals  0 to 9, otherwise std::logic_error.
void append_decimal(std::string& out, std::int64_t count, int decimals, const NumberStyle& style);

/// As append_decimal(), to memory of `decimal_room` characters, of which all may be written.
/// @return the count of characters that the number takes.
inline constexpr std::size_t decimal_room = 72;
std::size_t write_decimal(char* to, std::int64_t count, int decimals, const NumberStyle& style);

/// Shortest text that reads back as `value`, for messages ("118.204").
std::string number_text(double value);

/// `value` with at most `decimals` places, trailing zeros trimmed, for messages.
std::string number_text(double value, int decimals);

struct ParsedNumber {
  double value;        ///< finite, the double nearest to what is written
  std::size_t length;  ///< characters that it takes
};

/// The number at the start of `text`; nullopt: there is none, or it overflows. What is too small
/// for a double is 0. Reads "5.", ".25", "-.5", "+3", "1.E-3" and, as APT allows, "1.5D+02".
std::optional<ParsedNumber> parse_number(std::string_view text);

}  // namespace pentapost
