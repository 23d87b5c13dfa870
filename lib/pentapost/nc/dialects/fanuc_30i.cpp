#include "pentapost/nc/dialects/fanuc_30i.hpp"

#include "pentapost/nc/common_options.hpp"
#include "pentapost/nc/fanuc_family.hpp"
#include "pentapost/nc/options.hpp"

#include <charconv>
#include <optional>
#include <string>
#include <vector>

namespace pentapost::nc {
namespace {

/// Largest F in G93, 1/min (FANUC Series 16/18 operator's manual B-62764EN, 5. Feed functions).
constexpr double largest_inverse_time = 9999.999;
constexpr std::size_t longest_name = 30;
constexpr std::size_t number_digits = 4;
/// O9000 and up are the machine builder's, locked against change (bit NE9 of parameter 3202).
constexpr int largest_free_number = 8999;

CommonSettings default_settings() {
  CommonSettings defaults;
  defaults.feed_decimals = 3;
  defaults.start_lines = {"G90 G94 G17 G21 G49 G40 G80", "G54"};
  defaults.end_lines = {"M30"};
  defaults.safe_retract = {"G91 G28 Z0.", "G90"};
  defaults.tool_change = {"T{tool} M6"};
  defaults.tcp_on = {"G43.4 H{register}"};
  defaults.tcp_off = {"G49"};
  return defaults;
}

std::vector<OptionRow> all_rows() {
  std::vector<OptionRow> rows = common_rows(default_settings());
  rows.insert(
      rows.end(),
      {{"program_number", 1.0,
        "number of a program whose name is no number from 1 to 8999, O0001 to O9999"},
       {"modal_words", true, "leave out axis words that do not change"},
       {"rigid_tapping", std::vector<std::string>{"M29 {speed}"},
        "blocks before a tapping cycle that couple feed and spindle; {speed} stands for the S "
        "word; empty: the control does so by itself"},
       {"dwell_word", std::string{"P"}, "dwell: P in milliseconds or X in seconds"},
       {"inverse_time_decimals", 3.0, "decimals of F in G93, 0 to 4; rounded down"},
       {"largest_inverse_time", largest_inverse_time, "largest F in G93, 1/min"},
       {"native_cycles", true, "drill with G81 to G89 where TCP is off and the tool is upright"},
       {"arcs_with_tcp", false,
        "write arcs while TCP is on; with turned tables the control may refuse them"}});
  return rows;
}

const std::vector<OptionRow> rows = all_rows();

struct Options {
  FanucSettings settings;
  int program_number = 1;
  bool native_cycles = true;
  bool arcs_with_tcp = false;
};

Result<Options> read(const machine::Options& given) {
  OptionReader reader{rows, given};
  Options options;
  FanucSettings& settings = options.settings;
  settings.common = read_common(reader);
  options.program_number = reader.whole("program_number", 1, 9999);
  settings.modal_words = reader.flag("modal_words");
  settings.rigid_tapping = reader.lines("rigid_tapping", {"{speed}"});
  const std::string dwell = reader.text("dwell_word");
  if (dwell != "P" && dwell != "X") reader.refuse("dwell_word", "must be P or X");
  settings.dwell =
      dwell == "X" ? FanucSettings::Dwell::x_seconds : FanucSettings::Dwell::p_milliseconds;
  settings.inverse_time_decimals = reader.whole("inverse_time_decimals", 0, 4);
  settings.largest_inverse_time = reader.number("largest_inverse_time", 1.0, 999'999.0);
  options.native_cycles = reader.flag("native_cycles");
  options.arcs_with_tcp = reader.flag("arcs_with_tcp");
  if (reader.problem()) return *reader.problem();
  return options;
}

Result<Abilities> abilities(const machine::Options& given) {
  const auto options = read(given);
  if (!options) return options.error();
  Abilities can = common_abilities(options->settings.common);
  can.inverse_time = true;
  can.largest_inverse_time = options->settings.largest_inverse_time;
  can.helices = can.arcs;
  can.arcs_with_tcp = can.arcs && options->arcs_with_tcp;
  can.retracts_with_tcp = true;  // by a parameter G49 moves the axes by the tool length
  can.native_cycles = options->native_cycles;
  return can;
}

/// The program number that a name like "1001" or "O1001" is; nullopt: it is a name.
std::optional<int> number_of(std::string_view name) {
  if (name.starts_with('O') || name.starts_with('o')) name.remove_prefix(1);
  int number = 0;
  const char* const end = name.data() + name.size();
  const auto [stop, error] = std::from_chars(name.data(), end, number);
  if (error != std::errc{} || stop != end || name.size() > number_digits || number < 1 ||
      number > largest_free_number)
    return std::nullopt;
  return number;
}

/// @param otherwise  number of a program whose name is none; the name is a comment then.
std::string program_line(int otherwise, std::string_view name) {
  const auto number = number_of(name);
  const std::string digits = std::to_string(number.value_or(otherwise));
  std::string line{"O"};
  line.append(number_digits - digits.size(), '0').append(digits);
  if (number) return line;
  const std::string title = fanuc_comment(name).substr(0, longest_name);
  if (!title.empty()) line.append(" (").append(title).append(")");
  return line;
}

Status write(const path::Motion& motion, const path::ProgramHeader& header,
             const machine::Options& given, std::string& out) {
  auto options = read(given);
  if (!options) return options.error();
  options->settings.program_line = program_line(options->program_number, header.program_name);
  return write_fanuc_family(motion, header, options->settings, out);
}

}  // namespace

const Dialect fanuc_30i{
    .name = "fanuc-30i",
    .title = "Fanuc 30i, 31i",
    .options = rows,
    .abilities = abilities,
    .write = write,
};

}  // namespace pentapost::nc
