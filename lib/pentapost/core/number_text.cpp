#include "pentapost/core/number_text.hpp"

#include <fast_float/fast_float.h>  // 3x faster than std::from_chars of g++ 12, same answers

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <system_error>

namespace pentapost {
namespace {

constexpr std::array<double, 10> powers_of_ten{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};

double power_of_ten(int decimals) { return powers_of_ten.at(static_cast<std::size_t>(decimals)); }

}  // namespace

double decimal_value(std::int64_t count, int decimals) {
  return static_cast<double>(count) / power_of_ten(decimals);
}

std::int64_t decimal_count(double value, int decimals) {
  const double scaled = value * power_of_ten(decimals);
  if (!(std::abs(scaled) < 9007199254740992.0))
    throw std::logic_error{"decimal_count: the value is not finite or too large"};
  return std::llround(scaled);
}

void append_decimal(std::string& out, std::int64_t count, int decimals, const NumberStyle& style) {
  std::array<char, 24> digits;
  auto first = digits.size();
  auto rest = count < 0 ? -static_cast<std::uint64_t>(count) : static_cast<std::uint64_t>(count);
  bool written = style.trailing_zeros && decimals > 0;
  for (int i = 0; i < decimals; ++i, rest /= 10) {
    const auto digit = static_cast<char>('0' + rest % 10);
    written = written || digit != '0';
    if (written) digits[--first] = digit;
  }
  if (written || style.always_point) digits[--first] = '.';
  if (rest == 0 && (style.leading_zero || !written)) digits[--first] = '0';
  for (; rest != 0; rest /= 10) digits[--first] = static_cast<char>('0' + rest % 10);
  if (count < 0)
    digits[--first] = '-';
  else if (style.plus_sign)
    digits[--first] = '+';
  out.append(digits.data() + first, digits.size() - first);
}

std::string number_text(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string number_text(double value, int decimals) {
  if (!(std::abs(value) * power_of_ten(decimals) < 9e15)) return number_text(value);
  std::string text;
  append_decimal(text, decimal_count(value, decimals), decimals, {});
  return text;
}

std::optional<ParsedNumber> parse_number(std::string_view text) {
  const std::size_t sign = !text.empty() && text.front() == '+' ? 1 : 0;
  const char* const begin = text.data() + sign;
  const char* const end = text.data() + text.size();
  // fast_float accepts the words "nan" and "inf": a number starts with a digit or a point.
  const char* lead = begin != end && *begin == '-' && sign == 0 ? begin + 1 : begin;
  if (lead == end || !((*lead >= '0' && *lead <= '9') || *lead == '.')) return std::nullopt;
  double value = 0.0;
  auto [next, error] = fast_float::from_chars(begin, end, value);
  if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
  if (next != end && (*next == 'D' || *next == 'd')) {
    int exponent = 0;
    const char* digits = next + 1;
    if (digits != end && *digits == '+') ++digits;
    const auto [after, exponent_error] = std::from_chars(digits, end, exponent);
    if (exponent_error == std::errc{} && after != digits) {
      std::string with_e{begin, after};
      with_e[static_cast<std::size_t>(next - begin)] = 'e';
      const auto again =
          fast_float::from_chars(with_e.data(), with_e.data() + with_e.size(), value);
      if (again.ec != std::errc{} || !std::isfinite(value)) return std::nullopt;
      next = after;
    } else if (exponent_error == std::errc::result_out_of_range) {
      return std::nullopt;
    }
  }
  return ParsedNumber{value, static_cast<std::size_t>(next - text.data())};
}

}  // namespace pentapost
