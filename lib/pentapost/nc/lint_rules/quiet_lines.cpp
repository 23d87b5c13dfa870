#include "pentapost/nc/lint_rules/quiet_lines.hpp"

#include <cstddef>

namespace pentapost::nc::lint_rules {
namespace {

constexpr std::size_t longest = 200;  // no byte of the sum overflows

enum class What : std::uint8_t { axis, feed, sign, point, line_word, other };

constexpr std::uint64_t one(What what) { return std::uint64_t{1} << (8 * static_cast<int>(what)); }

constexpr std::uint64_t count(std::uint64_t sum, What what) {
  return sum >> (8 * static_cast<int>(what)) & 0xFF;
}

}  // namespace

QuietLines::QuietLines(std::string_view axis_letters, const Spelling& spelling)
    : spelling_{spelling} {
  counts_.fill(one(What::other));
  const auto set = [this](std::string_view characters, std::uint64_t counts) {
    for (const char each : characters) counts_[static_cast<unsigned char>(each)] = counts;
  };
  set("0123456789 N*\r", 0);
  set(axis_letters, one(What::axis));
  set("F", one(What::feed));
  set("+-", one(What::sign));
  set(".", one(What::point));
  if (spelling.needs_line_word) set("L", one(What::line_word));
}

bool QuietLines::has(std::string_view line, bool needs_feed) const {
  if (line.size() > longest) return false;
  std::uint64_t sum = 0;
  for (const char each : line) sum += counts_[static_cast<unsigned char>(each)];
  const std::uint64_t axes = count(sum, What::axis), feeds = count(sum, What::feed);
  return count(sum, What::other) == 0 && feeds <= 1 && (!needs_feed || feeds == 1) &&
         (!spelling_.needs_signs || count(sum, What::sign) == axes) &&
         (!spelling_.needs_points || count(sum, What::point) == axes + feeds) &&
         (!spelling_.needs_line_word || count(sum, What::line_word) == 1);
}

}  // namespace pentapost::nc::lint_rules
