#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string_view>

namespace pentapost::machine {

/// Version of a definition: "1.0.0". Greater is newer.
struct SemanticVersion {
  std::uint32_t major = 0;
  std::uint32_t minor = 0;
  std::uint32_t patch = 0;
  // clang-tidy 14 takes the comparison that = default makes for one with a literal 0.
  auto operator<=>(const SemanticVersion&) const = default;  // NOLINT(modernize-use-nullptr)
};

/// The version that `text` spells; nullopt unless it is three numbers of at most 9 digits, without
/// leading zeros, joined by points.
std::optional<SemanticVersion> semantic_version(std::string_view text);

}  // namespace pentapost::machine
