#include "pentapost/machine/near_names.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace pentapost::machine {
namespace {

constexpr std::size_t longest_compared = 100;  ///< letters; keeps the table of a comparison small
constexpr std::size_t most_offered = 3;
constexpr std::size_t shortest_part = 3;  ///< letters that a part must have to count

char lower_case(char letter) {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

std::string lower_case(std::string_view text) {
  std::string lower{text};
  for (char& letter : lower) letter = lower_case(letter);
  return lower;
}

/// Edit distance with exchanged neighbours counted as one (optimal string alignment).
std::size_t edit_distance(std::string_view x, std::string_view y) {
  std::vector<std::vector<std::size_t>> distance(x.size() + 1,
                                                 std::vector<std::size_t>(y.size() + 1));
  for (std::size_t i = 0; i <= x.size(); ++i) distance[i][0] = i;
  for (std::size_t j = 0; j <= y.size(); ++j) distance[0][j] = j;
  for (std::size_t i = 1; i <= x.size(); ++i) {
    for (std::size_t j = 1; j <= y.size(); ++j) {
      const std::size_t change = x[i - 1] == y[j - 1] ? 0 : 1;
      auto& best = distance[i][j];
      best = std::min(
          {distance[i - 1][j] + 1, distance[i][j - 1] + 1, distance[i - 1][j - 1] + change});
      if (i > 1 && j > 1 && x[i - 1] == y[j - 2] && x[i - 2] == y[j - 1])
        best = std::min(best, distance[i - 2][j - 2] + 1);
    }
  }
  return distance[x.size()][y.size()];
}

bool is_part(std::string_view part, std::string_view whole) {
  return part.size() >= shortest_part && whole.find(part) != std::string_view::npos;
}

}  // namespace

std::vector<std::string> near_names(std::string_view name, std::span<const std::string> names) {
  if (name.empty() || name.size() > longest_compared) return {};
  const std::string wanted = lower_case(name);
  std::vector<std::pair<std::size_t, std::string>> near;
  for (const auto& candidate : names) {
    if (candidate.size() > longest_compared) continue;
    const std::string other = lower_case(candidate);
    const std::size_t distance = edit_distance(wanted, other);
    const std::size_t allowed = std::max<std::size_t>(1, std::max(wanted.size(), other.size()) / 3);
    if (distance <= allowed || is_part(wanted, other) || is_part(other, wanted))
      near.emplace_back(distance, candidate);
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  std::vector<std::string> offered;
  for (std::size_t i = 0; i < std::min(near.size(), most_offered); ++i)
    offered.push_back(std::move(near[i].second));
  return offered;
}

}  // namespace pentapost::machine
