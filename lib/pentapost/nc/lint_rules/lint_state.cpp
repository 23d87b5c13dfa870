#include "pentapost/nc/lint_rules/lint_state.hpp"

#include <algorithm>
#include <utility>

namespace pentapost::nc::lint_rules {
namespace {

constexpr std::string_view axis_letters = "XYZUVWABC", rotary_letters = "ABC";

bool is_axis_word(const LintWord& word) {
  return word.letters.size() == 1 && axis_letters.find(word.letters[0]) != std::string_view::npos &&
         (word.assigned.empty() ? !word.number.empty() : word.number.empty());
}

}  // namespace

std::vector<LintRule> common_rules(std::string_view source) {
  return {
      {"machine_move_with_tcp", "no move to a machine position or reference point with TCP on",
       source},
      {"tool_change_with_tcp", "TCP is off where the tool is changed", source},
      {"end_with_tcp", "TCP is off where the program ends", source},
      {"cycle_with_tcp", "TCP is off where a drilling cycle runs", source},
      {"arc_with_rotary_words", "no rotary axis moves in an arc", source},
      {"inverse_time_at_dwell", "feed per minute is back before a dwell or a cycle", source},
      {"unknown_axis_word", "no word of an axis that the machine does not have", source},
      {"long_line", "no line is longer than the control reads", source},
  };
}

void LintState::add(const LintBlock& block, std::string_view rule, std::string message) {
  ++report_.total;
  if (report_.findings.size() < LintReport::most)
    report_.findings.push_back({block.line, rule, std::move(message)});
}

bool LintState::has_rotary_words(const LintBlock& block) const {
  const auto words = block.words();
  return std::any_of(words.begin(), words.end(), [&](const LintWord& word) {
    return is_axis_word(word) && rotary_letters.find(word.letters[0]) != std::string_view::npos &&
           setup_.letters.find(word.letters[0]) != std::string::npos;
  });
}

bool LintState::has_axis_words(const LintBlock& block) const {
  const auto words = block.words();
  return std::any_of(words.begin(), words.end(), is_axis_word);
}

void LintState::take(const LintBlock& block, const Doings& doings) {
  using Motion = Doings::Motion;
  if (longest_line_ > 0 && block.text.size() > longest_line_)
    add(block, "long_line",
        std::to_string(block.text.size()) + " characters, the control reads " +
            std::to_string(longest_line_));
  if (doings.tcp_off) tcp_ = false;
  if (doings.length_off) length_ = false;
  if (doings.machine_move && tcp_)
    add(block, "machine_move_with_tcp", "a move to a machine position while TCP is on");
  if (doings.tool_change && tcp_) add(block, "tool_change_with_tcp", "a tool change with TCP on");
  if (doings.ends && tcp_) add(block, "end_with_tcp", "the program ends with TCP on");
  if (doings.motion) motion_ = *doings.motion;
  if (doings.inverse_time) inverse_time_ = true;
  if (doings.per_minute) inverse_time_ = false;
  const bool moves = !doings.dwell && has_axis_words(block);
  if (moves && motion_ == Motion::arc && has_rotary_words(block))
    add(block, "arc_with_rotary_words", "a rotary word in an arc");
  if (moves && motion_ == Motion::cycle && tcp_)
    add(block, "cycle_with_tcp", "a drilling cycle with TCP on");
  if (inverse_time_ && (doings.dwell || (moves && motion_ == Motion::cycle)))
    add(block, "inverse_time_at_dwell", "inverse time is still on");
  if (moves)
    for (const LintWord& word : block.words())
      if (is_axis_word(word) && setup_.letters.find(word.letters[0]) == std::string::npos)
        add(block, "unknown_axis_word",
            "the machine has no axis " + std::string{word.letters.substr(0, 1)});
  if (doings.tcp_on) tcp_ = true;
  if (doings.length_on) length_ = true;
}

}  // namespace pentapost::nc::lint_rules
