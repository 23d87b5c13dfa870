#pragma once

#include "pentapost/core/codes.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pentapost {

enum class Severity { error, warning, info };

/// One remark about the input, with its place.
struct Diagnostic {
  Severity severity = Severity::warning;
  Code code = Code::unknown_statement;
  std::uint32_t cl_line = 0;  ///< 1-based line of the CL data; 0: none
  std::string message;        ///< one sentence: value, limit, unit, place
};

/// Diagnostics in the order found. Keeps the first 100 of each severity, counts all.
class Diagnostics {
 public:
  static constexpr std::size_t kept_per_severity = 100;

  /// True while a further diagnostic of this severity would be kept: then it is worth a text.
  bool keeps(Severity severity) const {
    return counts_[static_cast<std::size_t>(severity)] < kept_per_severity;
  }
  void add(Diagnostic diagnostic) {
    const bool kept = keeps(diagnostic.severity);
    ++counts_[static_cast<std::size_t>(diagnostic.severity)];
    if (kept) list_.push_back(std::move(diagnostic));
  }
  /// Counts one that is not kept any more (see keeps()).
  void count(Severity severity) { ++counts_[static_cast<std::size_t>(severity)]; }
  /// Adds those of `other`, which is another object, after its own.
  void append(const Diagnostics& other) {
    auto not_kept = other.counts_;
    for (const auto& diagnostic : other.list_) {
      add(diagnostic);
      --not_kept[static_cast<std::size_t>(diagnostic.severity)];
    }
    for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += not_kept[i];
  }

  const std::vector<Diagnostic>& list() const noexcept { return list_; }
  std::size_t total() const noexcept { return counts_[0] + counts_[1] + counts_[2]; }
  std::size_t total(Severity severity) const noexcept {
    return counts_[static_cast<std::size_t>(severity)];
  }
  bool has_errors() const noexcept { return counts_[0] > 0; }

 private:
  std::vector<Diagnostic> list_;
  std::array<std::size_t, 3> counts_{};  ///< by severity
};

}  // namespace pentapost
