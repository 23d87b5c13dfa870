#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace pentapost::nc::readers {

/// A number as an NC word writes it: an optional sign, digits, an optional point. No exponent.
struct Decimal {
  /// Digits read exactly: 10^15 is below 2^53, so value() is the nearest double.
  static constexpr int most_digits = 15;

  std::uint64_t mantissa = 0;
  int decimals = 0;  ///< digits after the point
  int digits = 0;
  bool negative = false;
  bool has_sign = false;
  bool has_point = false;

  /// Never -0.
  double value() const {
    static constexpr std::array<double, most_digits + 1> powers_of_ten{
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const double magnitude =
        static_cast<double>(mantissa) / powers_of_ten[static_cast<std::size_t>(decimals)];
    return negative && mantissa != 0 ? -magnitude : magnitude;
  }
  /// Plain digits only, as in N10 or M30.
  bool is_plain_integer() const { return !has_sign && !has_point; }
};

/// Moves `at` behind the digits there, which continue `mantissa`. @return their count.
inline std::ptrdiff_t read_digits(const char*& at, const char* end, std::uint64_t& mantissa) {
  const char* const first = at;
  for (; at != end; ++at) {
    const auto digit = static_cast<unsigned>(*at) - static_cast<unsigned>('0');
    if (digit > 9) break;
    mantissa = mantissa * 10 + digit;  // what is too long wraps round and is refused
  }
  return at - first;
}

/// Reads a number at `at` and moves `at` behind it.
/// @return false: no digit there, or more than most_digits.
inline bool read_decimal(const char*& at, const char* end, Decimal& number) {
  number = {};
  if (at != end && (*at == '+' || *at == '-')) {
    number.has_sign = true;
    number.negative = *at == '-';
    ++at;
  }
  const std::ptrdiff_t whole = read_digits(at, end, number.mantissa);
  std::ptrdiff_t decimals = 0;
  if (at != end && *at == '.') {
    number.has_point = true;
    ++at;
    decimals = read_digits(at, end, number.mantissa);
  }
  if (whole > Decimal::most_digits || decimals > Decimal::most_digits - whole) {
    number.digits = Decimal::most_digits + 1;
    return false;
  }
  number.decimals = static_cast<int>(decimals);
  number.digits = static_cast<int>(whole + decimals);
  return number.digits > 0;
}

}  // namespace pentapost::nc::readers
