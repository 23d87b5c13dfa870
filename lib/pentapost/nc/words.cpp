#include "pentapost/nc/words.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pentapost::nc {
namespace {

constexpr double largest_number = 999'999'999.0;
/// A feed that a computation left this little below a count is that count.
constexpr double feed_rounding_ratio = 1e-14;

std::int64_t power_of_ten(int exponent) {
  std::int64_t power = 1;
  for (int i = 0; i < exponent; ++i) power *= 10;
  return power;
}

/// Where a letter stands among the words of a block.
std::size_t rank(char letter) {
  constexpr std::string_view usual{"XYZUVWABC"};
  const std::size_t found = usual.find(letter);
  return found == std::string_view::npos ? usual.size() + static_cast<std::size_t>(letter) : found;
}

}  // namespace

std::optional<std::int64_t> feed_count(double feed, int decimals) {
  if (!(feed > 0.0 && feed <= largest_number)) return std::nullopt;
  const double scaled = feed * static_cast<double>(power_of_ten(decimals));
  const auto count = static_cast<std::int64_t>(scaled + scaled * feed_rounding_ratio);
  return std::max<std::int64_t>(count, 1);
}

std::optional<std::int64_t> nearest_count(double value, int decimals) {
  if (!(value >= 0.0 && value <= largest_number)) return std::nullopt;
  return std::llround(value * static_cast<double>(power_of_ten(decimals)));
}

WordColumns::WordColumns(const path::Motion& motion, int whole_digits)
    : count_{motion.letters.size()} {
  if (count_ < linear_columns || count_ > order_.size())
    throw std::logic_error{"WordColumns: a motion has 3 to 5 columns"};
  for (std::size_t column = 0; column < count_; ++column) {
    const char letter = motion.letters[column];
    if (letter < 'A' || letter > 'Z' || motion.letters.find(letter) != column)
      throw std::logic_error{"WordColumns: the letters of a motion are different ones of A to Z"};
    order_[column] = static_cast<std::uint8_t>(column);
    letter_[column] = letter;
    decimals_[column] = motion.decimals(column);
    if (decimals_[column] < 0 || decimals_[column] > 9)
      throw std::logic_error{"WordColumns: a word has 0 to 9 decimals"};
    largest_[column] = power_of_ten(whole_digits + decimals_[column]) - 1;
  }
  std::sort(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(count_),
            [&](std::size_t a, std::size_t b) { return rank(letter_[a]) < rank(letter_[b]); });
}

std::size_t WordColumns::find(char letter) const {
  for (std::size_t column = 0; column < count_; ++column) {
    if (letter_[column] == letter) return column;
  }
  return none;
}

}  // namespace pentapost::nc
