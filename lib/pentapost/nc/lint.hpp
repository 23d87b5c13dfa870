#pragma once

#include "pentapost/nc/reader.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pentapost::nc {

/// What a control does not want in a program, though it may run.
struct LintRule {
  std::string_view name;
  std::string_view description;
  std::string_view source;  ///< manual and section; empty: agreed practice
};

struct LintFinding {
  std::uint32_t nc_line = 0;
  std::string_view rule;  ///< name of its LintRule
  std::string message;    ///< what stands there
};

struct LintReport {
  static constexpr std::size_t most = 100;
  std::vector<LintFinding> findings;  ///< in the order of the lines, the first ones
  std::uint64_t total = 0;
};

/// The lint of a dialect: looks at the text alone and knows nothing of its writer or its reader.
struct Lint {
  std::string_view dialect;
  std::span<const LintRule> rules;
  LintReport (*look)(std::string_view text, const ReaderSetup& setup);
};

/// All lints, in alphabetical order of their dialects.
std::span<const Lint* const> lints();
/// nullptr: no dialect of that name has one.
const Lint* find_lint(std::string_view dialect);

}  // namespace pentapost::nc
