#include "pentapost/nc/lint_rules/fanuc_lints.hpp"

#include "pentapost/nc/lint_rules/lint_state.hpp"
#include "pentapost/nc/lint_rules/quiet_lines.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace pentapost::nc::lint_rules {
namespace {

using Motion = Doings::Motion;

/// What the controls of this family differ in.
struct Control {
  std::string_view tcp_on = {};  ///< number of the G code; empty: an M code below
  std::string_view tcp_on_m = {}, tcp_off_m = {};
  std::size_t longest_line = 0;
  /// A return to the reference point takes the length offset away by itself (FANUC operator's
  /// manual, tool length offset, G53, G28 and G30): G49 before it may let the tool down.
  bool returns_with_tcp = false;
  bool needs_points = false;
  bool has_smoothing = false;    ///< G05.1 Q1
  bool tcp_needs_rapid = false;  ///< G234 in G0 alone
};

constexpr std::string_view fanuc_source = "FANUC Series 30i operator's manual, five-axis functions";
constexpr std::string_view haas_source = "Haas mill operator's manual, NGC";
constexpr std::string_view linuxcnc_source = "LinuxCNC, G code reference";

std::optional<Motion> motion_of(std::string_view g) {
  if (g == "0" || g == "00") return Motion::rapid;
  if (g == "1" || g == "01") return Motion::line;
  if (g == "2" || g == "02" || g == "3" || g == "03") return Motion::arc;
  if (g == "80") return Motion::none;
  constexpr std::array cycles{"73", "74", "76", "81", "82", "83",
                              "84", "85", "86", "87", "88", "89"};
  if (std::find(cycles.begin(), cycles.end(), g) != cycles.end()) return Motion::cycle;
  return std::nullopt;
}

Doings doings_of(const LintBlock& block, const Control& control) {
  Doings doings;
  for (const LintWord& word : block.words()) {
    if (word.is("G")) {
      const std::string_view g = word.number;
      if (const auto motion = motion_of(g)) doings.motion = motion;
      doings.tcp_on = doings.tcp_on || (!control.tcp_on.empty() && g == control.tcp_on) ||
                      (control.tcp_on == "43.4" && g == "43.5");
      const bool ends_length = g == "49";
      doings.tcp_off = doings.tcp_off || (ends_length && !control.tcp_on.empty());
      doings.length_off = doings.length_off || ends_length;
      doings.length_on = doings.length_on || g == "43" || g == control.tcp_on;
      const bool returns = g == "28" || g == "30";
      doings.machine_move =
          doings.machine_move || g == "53" || (returns && !control.returns_with_tcp);
      doings.inverse_time = doings.inverse_time || g == "93";
      doings.per_minute = doings.per_minute || g == "94";
      doings.dwell = doings.dwell || g == "4" || g == "04";
    } else if (word.is("M")) {
      const std::string_view m = word.number;
      doings.tcp_on = doings.tcp_on || (!control.tcp_on_m.empty() && m == control.tcp_on_m);
      doings.tcp_off = doings.tcp_off || (!control.tcp_off_m.empty() && m == control.tcp_off_m);
      doings.tool_change = doings.tool_change || m == "6" || m == "06";
      doings.ends = doings.ends || m == "2" || m == "02" || m == "30";
    }
  }
  doings.smoothing_on = control.has_smoothing && block.has("Q", "1") &&
                        (block.has("G", "05.1") || block.has("G", "5.1"));
  return doings;
}

/// Words whose number means thousandths without a point.
void check_points(const LintBlock& block, LintState& state) {
  constexpr std::string_view lengths = "XYZABCUVWIJKR";
  for (const LintWord& word : block.words()) {
    if (word.letters.size() != 1 || lengths.find(word.letters[0]) == std::string_view::npos)
      continue;
    if (!word.number.empty() && word.number.find('.') == std::string_view::npos)
      state.add(block, "number_without_point",
                std::string{word.letters} + std::string{word.number} + " has no decimal point");
  }
}

LintReport look(std::string_view text, const ReaderSetup& setup, const Control& control) {
  LintText blocks{text, {.round_comments = true, .semicolon_comments = false, .calls = false}};
  LintState state{setup, control.longest_line};
  const QuietLines quiet{setup.letters, {.needs_points = control.needs_points}};
  LintBlock block;
  while (blocks.next(block)) {
    if (state.goes_straight() && quiet.has(block.text, state.inverse_time())) continue;
    blocks.split(block);
    const Doings doings = doings_of(block, control);
    const bool has_length = state.length();
    state.take(block, doings);
    if (control.needs_points && !doings.dwell) check_points(block, state);
    if (doings.smoothing_on && has_length)
      state.add(block, "smoothing_after_length", "G05.1 Q1 behind the length offset");
    if (control.tcp_needs_rapid && doings.tcp_on && state.motion() != Motion::rapid)
      state.add(block, "tcp_without_rapid", "G234 where G0 is not active");
    const bool moves = !doings.dwell && !doings.machine_move && state.has_axis_words(block) &&
                       (state.motion() == Motion::line || state.motion() == Motion::arc);
    if (moves && state.inverse_time() && !block.has('F'))
      state.add(block, "inverse_time_without_feed", "a block in inverse time without F");
  }
  return std::move(state).finish();
}

std::vector<LintRule> rules_of(std::string_view source, const Control& control) {
  std::vector<LintRule> rules = common_rules(source);
  rules.push_back({"inverse_time_without_feed", "every block in inverse time has its F", source});
  if (control.needs_points)
    rules.push_back({"number_without_point", "lengths and angles have a decimal point", source});
  if (control.has_smoothing)
    rules.push_back({"smoothing_after_length",
                     "contour control is switched on before the length offset", source});
  if (control.tcp_needs_rapid)
    rules.push_back({"tcp_without_rapid", "G234 stands where G0 is active", source});
  return rules;
}

constexpr Control fanuc{
    .tcp_on = "43.4", .returns_with_tcp = true, .needs_points = true, .has_smoothing = true};
constexpr Control haas{.tcp_on = "234", .needs_points = true, .tcp_needs_rapid = true};
constexpr Control linuxcnc{.tcp_on_m = "428", .tcp_off_m = "429", .longest_line = 255};

const std::vector<LintRule> fanuc_rules = rules_of(fanuc_source, fanuc);
const std::vector<LintRule> haas_rules = rules_of(haas_source, haas);
const std::vector<LintRule> linuxcnc_rules = rules_of(linuxcnc_source, linuxcnc);

LintReport look_fanuc(std::string_view text, const ReaderSetup& setup) {
  return look(text, setup, fanuc);
}
LintReport look_haas(std::string_view text, const ReaderSetup& setup) {
  return look(text, setup, haas);
}
LintReport look_linuxcnc(std::string_view text, const ReaderSetup& setup) {
  return look(text, setup, linuxcnc);
}

}  // namespace

const Lint fanuc_30i_lint{"fanuc-30i", fanuc_rules, look_fanuc};
const Lint haas_ngc_lint{"haas-ngc", haas_rules, look_haas};
const Lint linuxcnc_lint{"linuxcnc", linuxcnc_rules, look_linuxcnc};

}  // namespace pentapost::nc::lint_rules
