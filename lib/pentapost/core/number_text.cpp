#include "pentapost/core/number_text.hpp"

#include <fast_float/fast_float.h>  // 3x faster than std::from_chars of g++ 12, same answers

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <system_error>

namespace pentapost {
namespace {

constexpr std::array<double, 10> powers_of_ten{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};

double power_of_ten(int decimals) {
  const auto index = static_cast<std::size_t>(decimals);
  if (index >= powers_of_ten.size()) throw std::logic_error{"a number has 0 to 9 decimals"};
  return powers_of_ten[index];
}

/// "00", "01" ... "99" in a row.
constexpr auto digit_pairs = [] {
  std::array<char, 200> pairs{};
  for (std::size_t i = 0; i < 100; ++i) {
    pairs[2 * i] = static_cast<char>('0' + i / 10);
    pairs[2 * i + 1] = static_cast<char>('0' + i % 10);
  }
  return pairs;
}();

/// The digits of a count, right-aligned.
struct Digits {
  static constexpr std::size_t size = 24;
  std::array<char, 2 * size> text;  ///< the second half is there to be copied over the end
  std::size_t first = size;

  /// @param least  at least so many digits, by zeros in front.
  Digits(std::uint64_t count, std::size_t least) {
    for (; count >= 100; count /= 100) put_pair(count % 100);
    if (count >= 10)
      put_pair(count);
    else
      text[--first] = static_cast<char>('0' + count);
    while (size - first < least) text[--first] = '0';
  }

 private:
  void put_pair(std::uint64_t pair) {
    first -= 2;
    std::memcpy(&text[first], &digit_pairs[2 * pair], 2);
  }
};

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

struct DoubleText {
  double value;
  const char* end;
};

/// What fast_float reads, less the words "nan" and "inf" and what overflows.
std::optional<DoubleText> read_double(const char* begin, const char* end) {
  double value = 0.0;
  const auto [next, error] = fast_float::from_chars(begin, end, value);
  if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
  return DoubleText{value, next};
}

constexpr std::array<double, 16> divisors{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                          1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};

/// A decimal of at most 15 digits without an exponent, which one exact division gives: nearly all
/// numbers of CL data. nullopt: the number is another one, or none.
std::optional<DoubleText> read_short_decimal(const char* begin, const char* end) {
  const bool minus = *begin == '-';
  const char* next = begin + minus;
  std::int64_t mantissa = 0;
  const auto read_digits = [&] {
    const char* const first = next;
    for (; next != end && is_digit(*next) && next - begin <= 17; ++next)
      mantissa = 10 * mantissa + (*next - '0');
    return next - first;
  };
  const auto whole = read_digits();
  std::ptrdiff_t places = 0;
  if (next != end && *next == '.') {
    ++next;
    places = read_digits();
  }
  const auto digits = whole + places;
  if (digits == 0 || digits > 15) return std::nullopt;
  if (next != end && ((*next | 0x20) == 'e' || (*next | 0x20) == 'd')) return std::nullopt;
  const double value = static_cast<double>(mantissa) / divisors[static_cast<std::size_t>(places)];
  return DoubleText{minus ? -value : value, next};
}

/// End of the exponent "D+02" at `mark`; `mark` itself where there is none.
const char* end_of_d_exponent(const char* mark, const char* end) {
  if (mark == end || (*mark != 'D' && *mark != 'd')) return mark;
  const char* digits = mark + 1;
  if (digits != end && (*digits == '+' || *digits == '-')) ++digits;
  const char* after = digits;
  while (after != end && is_digit(*after)) ++after;
  return after == digits ? mark : after;
}

}  // namespace

double decimal_value(std::int64_t count, int decimals) {
  return static_cast<double>(count) / power_of_ten(decimals);
}

std::int64_t decimal_count(double value, int decimals) {
  const double power = power_of_ten(decimals);
  const double scaled = value * power;
  if (!(std::abs(scaled) < 4503599627370496.0))
    throw std::logic_error{"decimal_count: the value is not finite or too large"};
  const auto towards_zero = static_cast<std::int64_t>(scaled);
  const double part = scaled - static_cast<double>(towards_zero);
  if (std::abs(part) == 0.5) {
    // Rounding the product can turn nearly a half into a half: then the exact product decides.
    const double beyond_half = std::fma(value, power, -scaled) * std::copysign(1.0, value);
    if (beyond_half < 0.0) return towards_zero;
    return part < 0.0 ? towards_zero - 1 : towards_zero + 1;
  }
  return towards_zero + static_cast<int>(part > 0.5) - static_cast<int>(part < -0.5);
}

std::size_t write_decimal(char* to, std::int64_t count, int decimals, const NumberStyle& style) {
  power_of_ten(decimals);  // refuses what is out of its domain
  const auto places = static_cast<std::size_t>(decimals);
  const auto magnitude =
      count < 0 ? 0 - static_cast<std::uint64_t>(count) : static_cast<std::uint64_t>(count);
  const Digits digits{magnitude, places + 1};
  const std::size_t point = Digits::size - places;
  std::size_t end = Digits::size;
  if (!style.trailing_zeros)
    while (end > point && digits.text[end - 1] == '0') --end;
  const bool has_fraction = end > point;
  const bool zero_in_front = point - digits.first == 1 && digits.text[digits.first] == '0';
  const std::size_t first = digits.first + (zero_in_front && has_fraction && !style.leading_zero);

  // Copies of a fixed size cost less than loops; what they copy too much is written over.
  static_assert(decimal_room == 3 * Digits::size);
  std::size_t length = 0;
  to[0] = count < 0 ? '-' : '+';
  length += count < 0 || style.plus_sign;
  std::memcpy(&to[length], &digits.text[first], Digits::size);
  length += point - first;
  to[length] = '.';
  length += has_fraction || style.always_point;
  std::memcpy(&to[length], &digits.text[point], Digits::size);
  return length + end - point;
}

void append_decimal(std::string& out, std::int64_t count, int decimals, const NumberStyle& style) {
  std::array<char, decimal_room> text;
  out.append(text.data(), write_decimal(text.data(), count, decimals, style));
}

std::string number_text(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string number_text(double value, int decimals) {
  if (!(std::abs(value) * power_of_ten(decimals) < 4e15)) return number_text(value);
  std::string text;
  append_decimal(text, decimal_count(value, decimals), decimals, {});
  return text;
}

std::optional<ParsedNumber> parse_number(std::string_view text) {
  const char* const end = text.data() + text.size();
  const char* begin = text.data();
  if (begin != end && *begin == '+') ++begin;
  const bool minus = begin == text.data() && begin != end && *begin == '-';
  // fast_float reads "nan" and "inf" too: a number starts with a digit or a point.
  const char* const lead = minus ? begin + 1 : begin;
  if (lead == end || !(is_digit(*lead) || *lead == '.')) return std::nullopt;
  const auto as_parsed = [&text](const DoubleText& found) {
    return ParsedNumber{found.value, static_cast<std::size_t>(found.end - text.data())};
  };
  if (const auto number = read_short_decimal(begin, end)) return as_parsed(*number);
  auto number = read_double(begin, end);
  if (!number) return std::nullopt;

  const char* const mark = number->end;
  const char* const after = end_of_d_exponent(mark, end);
  const std::string_view mantissa{begin, mark};
  if (after != mark && mantissa.find_first_of("eE") == std::string_view::npos) {
    std::string with_e{begin, after};
    with_e[mantissa.size()] = 'e';
    const auto whole = read_double(with_e.data(), with_e.data() + with_e.size());
    if (!whole) return std::nullopt;
    number = DoubleText{whole->value, after};
  }
  return as_parsed(*number);
}

}  // namespace pentapost
