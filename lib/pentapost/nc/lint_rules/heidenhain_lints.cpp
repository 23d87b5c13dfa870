#include "pentapost/nc/lint_rules/heidenhain_lints.hpp"

#include "pentapost/nc/lint_rules/lint_state.hpp"
#include "pentapost/nc/lint_rules/quiet_lines.hpp"

#include <string>
#include <vector>

namespace pentapost::nc::lint_rules {
namespace {

using Motion = Doings::Motion;

constexpr std::string_view source = "HEIDENHAIN TNC 640 user's manuals, M functions and TCPM";
constexpr std::size_t longest_iso_line = 0, longest_line = 255;

void take_functions(const LintBlock& block, Doings& doings) {
  doings.tcp_on = block.has("M", "128");
  doings.tcp_off = block.has("M", "129");
  doings.machine_move = block.has("M", "91") || block.has("M", "92");
  doings.ends = block.has("M", "30") || block.has("M", "2") || block.has("M", "02");
}

/// Words of an axis must say their sign.
void check_signs(const LintBlock& block, LintState& state) {
  constexpr std::string_view signed_letters = "XYZABCUVW";
  for (const LintWord& word : block.words())
    if (word.letters.size() == 1 &&
        signed_letters.find(word.letters[0]) != std::string_view::npos && !word.number.empty() &&
        word.number[0] != '+' && word.number[0] != '-')
      state.add(block, "number_without_sign",
                std::string{word.letters} + std::string{word.number} + " has no sign");
}

LintReport look_iso(std::string_view text, const ReaderSetup& setup) {
  LintText blocks{text, {.round_comments = false, .semicolon_comments = true, .calls = false}};
  LintState state{setup, longest_iso_line};
  const QuietLines quiet{setup.letters, {.needs_signs = true}};
  LintBlock block;
  while (blocks.next(block)) {
    if (block.text.starts_with('%') || (state.goes_straight() && quiet.has(block.text, false)))
      continue;
    blocks.split(block);
    Doings doings;
    take_functions(block, doings);
    for (const LintWord& word : block.words()) {
      if (!word.is("G")) continue;
      if (word.number == "00" || word.number == "0") doings.motion = Motion::rapid;
      if (word.number == "01" || word.number == "1") doings.motion = Motion::line;
      if (word.number == "02" || word.number == "2" || word.number == "03" || word.number == "3")
        doings.motion = Motion::arc;
      doings.dwell = doings.dwell || word.number == "04" || word.number == "4";
    }
    doings.tool_change = block.has('T') && !block.has("G", "51");
    state.take(block, doings);
    check_signs(block, state);
  }
  return std::move(state).finish();
}

LintReport look_conversational(std::string_view text, const ReaderSetup& setup) {
  LintText blocks{text, {.round_comments = false, .semicolon_comments = true, .calls = false}};
  LintState state{setup, longest_line};
  const QuietLines quiet{setup.letters, {.needs_signs = true, .needs_line_word = true}};
  LintBlock block;
  while (blocks.next(block)) {
    if (quiet.has(block.text, false)) continue;
    blocks.split(block);
    const auto words = block.words();
    const bool is_function = block.find("FUNCTION") != nullptr && block.find("TCPM") != nullptr;
    const bool is_reset = block.find("RESET") != nullptr;
    Doings doings;
    take_functions(block, doings);
    doings.tcp_on = doings.tcp_on || (is_function && !is_reset);
    doings.tcp_off = doings.tcp_off || (is_function && is_reset);
    doings.tool_change = block.find("TOOL") != nullptr && block.find("CALL") != nullptr;
    doings.ends = doings.ends || (block.find("END") != nullptr && block.find("PGM") != nullptr);
    const std::string_view first = words.empty() ? std::string_view{} : words.front().letters;
    const bool is_path = first == "L" || first == "LN" || first == "LP";
    const bool is_arc = first == "C" || first == "CR" || first == "CT" || first == "CP";
    doings.motion = is_arc                 ? Motion::arc
                    : block.has("M", "99") ? Motion::cycle
                    : is_path              ? Motion::line
                                           : Motion::none;
    state.take(block, doings);
    if (is_path || is_arc || first == "CC") check_signs(block, state);
  }
  return std::move(state).finish();
}

std::vector<LintRule> all_rules() {
  std::vector<LintRule> rules = common_rules(source);
  rules.push_back({"number_without_sign", "coordinates have their sign", source});
  return rules;
}

const std::vector<LintRule> rules = all_rules();

}  // namespace

const Lint heidenhain_lint{"heidenhain", rules, look_conversational};
const Lint heidenhain_iso_lint{"heidenhain-iso", rules, look_iso};

}  // namespace pentapost::nc::lint_rules
