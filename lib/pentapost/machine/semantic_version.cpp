#include "pentapost/machine/semantic_version.hpp"

#include <array>
#include <charconv>
#include <cstddef>

namespace pentapost::machine {
namespace {

constexpr std::size_t most_digits = 9;  ///< what 32 bits hold in any case

std::optional<std::uint32_t> number_of(std::string_view digits) {
  const bool leading_zero = digits.size() > 1 && digits.front() == '0';
  if (digits.empty() || digits.size() > most_digits || leading_zero) return std::nullopt;
  for (const char digit : digits)
    if (digit < '0' || digit > '9') return std::nullopt;
  std::uint32_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

}  // namespace

std::optional<SemanticVersion> semantic_version(std::string_view text) {
  std::array<std::uint32_t, 3> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const bool last = i + 1 == numbers.size();
    const auto point = text.find('.');
    if (last != (point == std::string_view::npos)) return std::nullopt;
    const auto number = number_of(text.substr(0, point));
    if (!number) return std::nullopt;
    numbers[i] = *number;
    text.remove_prefix(last ? text.size() : point + 1);
  }
  return SemanticVersion{numbers[0], numbers[1], numbers[2]};
}

}  // namespace pentapost::machine
