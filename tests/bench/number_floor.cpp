#include "number_floor.hpp"

#include <fast_float/fast_float.h>

#include <array>
#include <cmath>

namespace pentapost::bench {
namespace {

/// A word of three decimals by rounding to an integer and printing its digits.
void print_word(char letter, double number, std::string& out) {
  const long long count = std::llround(number * 1000.0);
  auto rest = static_cast<unsigned long long>(count < 0 ? -count : count);
  int decimals = 3;
  for (; decimals > 0 && rest % 10 == 0; --decimals) rest /= 10;
  std::array<char, 28> text;
  std::size_t first = text.size();
  text[--first] = ' ';
  if (decimals > 0) {
    for (; decimals > 0; --decimals, rest /= 10) text[--first] = static_cast<char>('0' + rest % 10);
    text[--first] = '.';
  }
  do {
    text[--first] = static_cast<char>('0' + rest % 10);
    rest /= 10;
  } while (rest != 0);
  if (count < 0) text[--first] = '-';
  text[--first] = letter;
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

std::size_t number_floor(std::string_view cl, int words, std::string& out) {
  constexpr std::string_view statement = "GOTO / ";
  constexpr double degree_size = 100.0, feed_size = 2000.0;
  const char* const end = cl.data() + cl.size();
  const char* next = cl.data();
  std::size_t count = 0;
  std::array<double, 6> numbers{};
  while (next != end) {
    if (std::string_view{next, end}.starts_with(statement)) {
      next = read_six(next + statement.size(), end, numbers);
      ++count;
      if (words > 5) print_word('N', 10.0 * static_cast<double>(count), out);
      print_word('X', numbers[0], out);
      print_word('Y', numbers[1], out);
      print_word('Z', numbers[2], out);
      print_word('A', degree_size * numbers[3], out);
      print_word('C', degree_size * numbers[4], out);
      if (words > 6) print_word('F', feed_size * numbers[5], out);
      out += '\n';
    }
    while (next != end && *next != '\n') ++next;
    if (next != end) ++next;
  }
  return count;
}

std::string_view what_the_floor_does() {
  return "The floor finds the lines and the GOTO in the same CL text, reads their six numbers "
         "(fast_float)\nand prints as many words a GOTO as the NC program has: letter, sign, at "
         "most three decimals,\nno trailing zeros. No kinematics, no checks, no reading back.";
}

}  // namespace pentapost::bench
