#pragma once

#include "pentapost/nc/lint.hpp"
#include "pentapost/nc/lint_rules/lint_text.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pentapost::nc::lint_rules {

/// What a block does, as far as the common rules go.
struct Doings {
  enum class Motion : std::uint8_t { none, rapid, line, arc, cycle };
  std::optional<Motion> motion =
      {};  ///< the mode that the block sets; nullopt: it keeps the one it finds
  bool tcp_on = false, tcp_off = false;
  bool machine_move = false;  ///< to a machine position or the reference point
  bool inverse_time = false, per_minute = false;
  bool smoothing_on = false;
  bool length_on = false, length_off = false;
  bool dwell = false, tool_change = false, ends = false;
};

/// The rules that all controls share; the sources differ.
std::vector<LintRule> common_rules(std::string_view source);

/// Follows a program block by block and keeps what breaks a rule.
class LintState {
 public:
  /// @param longest_line  characters; 0: no bound.
  LintState(const ReaderSetup& setup, std::size_t longest_line)
      : setup_{setup}, longest_line_{longest_line} {}

  void take(const LintBlock& block, const Doings& doings);
  void add(const LintBlock& block, std::string_view rule, std::string message);

  bool tcp() const { return tcp_; }
  bool length() const { return length_; }
  bool inverse_time() const { return inverse_time_; }
  Doings::Motion motion() const { return motion_; }
  /// Whether a word of the block moves a rotary axis of the machine.
  bool has_rotary_words(const LintBlock& block) const;
  bool has_axis_words(const LintBlock& block) const;
  /// Whether words of axes alone would be a straight move.
  bool goes_straight() const {
    return motion_ == Doings::Motion::line || motion_ == Doings::Motion::rapid;
  }
  LintReport finish() && { return std::move(report_); }

 private:
  const ReaderSetup& setup_;
  std::size_t longest_line_;
  LintReport report_;
  bool tcp_ = false, length_ = false, inverse_time_ = false;
  Doings::Motion motion_ = Doings::Motion::none;
};

}  // namespace pentapost::nc::lint_rules
