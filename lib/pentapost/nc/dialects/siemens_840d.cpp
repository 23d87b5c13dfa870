#include "pentapost/nc/dialects/siemens_840d.hpp"

#include "pentapost/nc/common_options.hpp"
#include "pentapost/nc/dialects/siemens_840d_writer.hpp"
#include "pentapost/nc/options.hpp"
#include "pentapost/nc/plain_text.hpp"
#include "pentapost/nc/program_text.hpp"
#include "pentapost/nc/walk.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace pentapost::nc {
namespace {

/// Fundamentals, names of programs: 24 characters, letters, digits and underscores.
constexpr std::size_t longest_name = 24;
constexpr int most_edges = 12;

CommonSettings default_settings() {
  CommonSettings defaults;
  defaults.feed_decimals = 3;
  defaults.start_lines = {"TRAFOOF", "G90 G94 G710 G17 G40 G64", "G54"};
  defaults.end_lines = {"M30"};
  defaults.safe_retract = {"G0 SUPA Z0 D0"};
  defaults.tool_change = {"T{tool}", "M6"};
  // Between two blocks the rotary axes run evenly from word to word: by ORIMKS or by ORIAXES, as
  // machine data 21104 has it (Advanced, reference of the orientation axes; function manual
  // 5-axis machining, orientation programming).
  defaults.tcp_on = {"TRAORI", "ORIMKS", "ORIAXES"};
  defaults.tcp_off = {"TRAFOOF"};
  return defaults;
}

std::vector<OptionRow> all_rows() {
  std::vector<OptionRow> rows = common_rows(default_settings());
  rows.insert(
      rows.end(),
      {{"program_lines", std::vector<std::string>{"; %_N_{name}_MPF"},
        "lines at the head of the program; {name} stands for its name"},
       {"modal_words", true, "leave out axis words that do not change"},
       {"messages", false, "show the comments of the path by MSG as well"},
       {"edge", 1.0,
        "D that holds a tool's length, 1 to 12; 0: flat D numbers, D bears the length register"},
       {"edge_after_tool_change", 0.0,
        "for reading: D that holds after a tool change without D (machine data 20270), 1 to 12; "
        "0: not known"},
       {"shortest_way_axes", std::string{},
        "letters of rotary axes that count from 0 to 360 and are prepositioned as C=DC(..)"},
       {"inverse_time_decimals", 3.0, "decimals of F in G93, 0 to 4; rounded down"},
       {"largest_inverse_time", 99'999.999,
        "largest F in G93, 1/min; not confirmed by a manual of the control"},
       {"native_cycles", true,
        "drill with MCALL CYCLE81 to CYCLE86 where TCP is off and the tool is upright"},
       {"arcs_with_tcp", false,
        "write arcs while TCP is on; not confirmed by a manual of the control"}});
  return rows;
}

const std::vector<OptionRow> rows = all_rows();

struct Options {
  SiemensSettings settings;
  bool native_cycles = true;
  bool arcs_with_tcp = false;
};

bool is_letter(char c) { return c >= 'A' && c <= 'Z'; }

Result<Options> read(const machine::Options& given) {
  OptionReader reader{rows, given};
  Options options;
  SiemensSettings& settings = options.settings;
  settings.common = read_common(reader);
  settings.program_lines = reader.lines("program_lines", {"{name}"});
  settings.modal_words = reader.flag("modal_words");
  settings.messages = reader.flag("messages");
  settings.edge = reader.whole("edge", 0, most_edges);
  reader.whole("edge_after_tool_change", 0, most_edges);
  settings.shortest_way_axes = reader.text("shortest_way_axes");
  if (!std::ranges::all_of(settings.shortest_way_axes, is_letter))
    reader.refuse("shortest_way_axes", "must be letters of axes, as in AC");
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
  can.native_cycles = options->native_cycles;
  return can;
}

/// Begins with two letters, as a program must that others call.
std::string program_name(std::string_view name) {
  std::string clean = clean_program_name(name, longest_name);
  std::ranges::replace(clean, '-', '_');
  const bool begins_well = clean.size() >= 2 && is_letter(clean[0]) && is_letter(clean[1]);
  if (!begins_well) clean.insert(0, "MPF_");
  clean.resize(std::min(clean.size(), longest_name));
  return clean;
}

Status write(const path::Motion& motion, const path::ProgramHeader& header,
             const machine::Options& given, std::string& out) {
  auto options = read(given);
  if (!options) return options.error();
  for (std::string& line : options->settings.program_lines)
    line = filled(line, "{name}", program_name(header.program_name));
  reserve_text(out, motion, options->settings.common.block_numbers.on ? 8 : 0);
  SiemensWriter writer{motion, options->settings, out};
  writer.start(header);
  if (!walk(motion, writer)) return *writer.problem();
  return ok();
}

}  // namespace

const Dialect siemens_840d{
    .name = "siemens-840d",
    .title = "Siemens SINUMERIK 840D sl, ONE",
    .options = rows,
    .abilities = abilities,
    .write = write,
};

}  // namespace pentapost::nc
