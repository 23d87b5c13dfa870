#include "pentapost/nc/lint_rules/siemens_lint.hpp"

#include "pentapost/nc/lint_rules/lint_state.hpp"
#include "pentapost/nc/lint_rules/quiet_lines.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace pentapost::nc::lint_rules {
namespace {

using Motion = Doings::Motion;

constexpr std::string_view source =
    "SINUMERIK 840D sl, programming manuals fundamentals and job planning";
constexpr std::size_t longest_line = 512;

std::optional<Motion> motion_of(std::string_view g) {
  if (g == "0" || g == "00") return Motion::rapid;
  if (g == "1" || g == "01") return Motion::line;
  if (g == "2" || g == "02" || g == "3" || g == "03") return Motion::arc;
  return std::nullopt;
}

/// MCALL alone ends the modal call, MCALL CYCLE81(...) starts it.
std::optional<Motion> cycle_of(const LintBlock& block) {
  if (block.find("MCALL") == nullptr) return std::nullopt;
  return block.find("CYCLE") != nullptr ? Motion::cycle : Motion::none;
}

Doings doings_of(const LintBlock& block) {
  Doings doings;
  for (const LintWord& word : block.words()) {
    if (word.is("G")) {
      if (const auto motion = motion_of(word.number)) doings.motion = motion;
      doings.inverse_time = doings.inverse_time || word.number == "93";
      doings.per_minute = doings.per_minute || word.number == "94";
      doings.dwell = doings.dwell || word.number == "4" || word.number == "04";
      doings.machine_move = doings.machine_move || word.number == "153" || word.number == "74";
    }
    doings.machine_move = doings.machine_move || word.is("SUPA");
    doings.tcp_on = doings.tcp_on || word.is("TRAORI");
    doings.tcp_off = doings.tcp_off || word.is("TRAFOOF");
    doings.tool_change = doings.tool_change || word.is("M", "6") || word.is("M", "06");
    doings.ends = doings.ends || word.is("M", "30") || word.is("M", "2") || word.is("M", "02") ||
                  word.is("M", "17");
  }
  if (const auto cycle = cycle_of(block)) doings.motion = cycle;
  return doings;
}

/// CYCLE832(tolerance, mode, orientation tolerance).
bool lacks_orientation_tolerance(const LintBlock& block) {
  const LintWord* const cycle = block.find("CYCLE");
  if (cycle == nullptr || cycle->number != "832" || cycle->arguments.empty()) return false;
  const auto commas = std::count(cycle->arguments.begin(), cycle->arguments.end(), ',');
  return commas < 2 || cycle->arguments.back() == ',';
}

LintReport look(std::string_view text, const ReaderSetup& setup) {
  LintText blocks{text, {.round_comments = false, .semicolon_comments = true, .calls = true}};
  LintState state{setup, longest_line};
  const QuietLines quiet{setup.letters, {}};
  LintBlock block;
  while (blocks.next(block)) {
    if (block.text.starts_with('%') ||
        (state.goes_straight() && quiet.has(block.text, state.inverse_time())))
      continue;
    blocks.split(block);
    const Doings doings = doings_of(block);
    state.take(block, doings);
    if (lacks_orientation_tolerance(block))
      state.add(block, "smoothing_without_orientation",
                "CYCLE832 without an orientation tolerance");
    const bool moves = !doings.dwell && !doings.machine_move && state.has_axis_words(block) &&
                       (state.motion() == Motion::line || state.motion() == Motion::arc);
    if (moves && state.inverse_time() && !block.has('F'))
      state.add(block, "inverse_time_without_feed", "a block in inverse time without F");
  }
  return std::move(state).finish();
}

std::vector<LintRule> all_rules() {
  std::vector<LintRule> rules = common_rules(source);
  rules.push_back({"inverse_time_without_feed", "every block in inverse time has its F", source});
  rules.push_back({"smoothing_without_orientation",
                   "CYCLE832 has a tolerance of the orientation in five-axis programs", source});
  return rules;
}

const std::vector<LintRule> rules = all_rules();

}  // namespace

const Lint siemens_840d_lint{"siemens-840d", rules, look};

}  // namespace pentapost::nc::lint_rules
