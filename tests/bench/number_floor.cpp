#include "number_floor.hpp"

#include <fast_float/fast_float.h>

#include <array>
#include <cmath>

namespace pentapost::bench {
namespace {

/// Three decimals by rounding to an integer and printing its digits.
void print_thousandths(double number, std::string& out) {
  const long long count = std::llround(number * 1000.0);
  auto rest = static_cast<unsigned long long>(count < 0 ? -count : count);
  std::array<char, 24> text;
  std::size_t first = text.size();
  for (int digit = 0; digit < 3 || rest != 0 || digit == 3; ++digit, rest /= 10) {
    if (digit == 3) text[--first] = '.';
    text[--first] = static_cast<char>('0' + rest % 10);
  }
  if (count < 0) text[--first] = '-';
  out.append(text.data() + first, text.size() - first);
}

/// The six numbers behind "GOTO / "; returns where the line ends.
const char* read_six(const char* next, const char* end, std::array<double, 6>& numbers) {
  for (double& number : numbers) {
    while (next != end && (*next == ' ' || *next == ',')) ++next;
    next = fast_float::from_chars(next, end, number).ptr;
  }
  return next;
}

}  // namespace

std::size_t number_floor(std::string_view cl, std::string& out) {
  constexpr std::string_view statement = "GOTO / ";
  const char* const end = cl.data() + cl.size();
  const char* next = cl.data();
  std::size_t count = 0;
  std::array<double, 6> numbers{};
  while (next != end) {
    if (std::string_view{next, end}.starts_with(statement)) {
      next = read_six(next + statement.size(), end, numbers);
      for (std::size_t i = 0; i < 5; ++i) {
        out += ' ';
        print_thousandths(numbers[i], out);
      }
      out += '\n';
      ++count;
    }
    while (next != end && *next != '\n') ++next;
    if (next != end) ++next;
  }
  return count;
}

}  // namespace pentapost::bench
