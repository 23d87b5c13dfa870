#include "pentapost/nc/dialects/heidenhain_klartext.hpp"

#include "pentapost/nc/common_options.hpp"
#include "pentapost/nc/dialects/heidenhain_klartext_writer.hpp"
#include "pentapost/nc/options.hpp"
#include "pentapost/nc/program_text.hpp"
#include "pentapost/nc/walk.hpp"

#include <string>
#include <vector>

namespace pentapost::nc {
namespace {

/// TNC 640 user's manual, technical information: feed rates 0 to 99 999.999.
constexpr double largest_feed = 99'999.999;

CommonSettings default_settings() {
  CommonSettings defaults;
  defaults.block_numbers = {.on = true, .start = 1, .step = 1, .letter = false};
  defaults.feed_decimals = 3;
  defaults.end_lines = {"M30"};
  defaults.safe_retract = {"M140 MB MAX"};
  defaults.tool_change = {"TOOL CALL {tool} Z {speed}"};
  defaults.tcp_on = {"M128"};
  defaults.tcp_off = {"M129"};
  return defaults;
}

std::vector<OptionRow> all_rows() {
  using Lines = std::vector<std::string>;
  std::vector<OptionRow> rows = common_rows(default_settings());
  rows.insert(
      rows.end(),
      {{"program_name_length", 24.0, "most characters of a program name, 1 to 100"},
       {"blank_form", Lines{}, "blocks behind BEGIN PGM, such as BLK FORM 0.1 and BLK FORM 0.2"},
       {"speed_change", Lines{"TOOL CALL Z {speed}"},
        "blocks that change the spindle speed without a tool change; {speed} stands for the S "
        "word"},
       {"program_stop", Lines{"M0"},
        "blocks that stop the program; the spindle and the coolant are started again behind them"},
       {"modal_words", true, "leave out axis words that do not change"},
       {"native_cycles", true,
        "drill with CYCL DEF 200 to 207 where TCP is off and the tool is upright"},
       {"cycle_depth_reference", false,
        "write Q395 in cycles 200, 203 and 205 (TNC 640 and later; the iTNC 530 has it not)"},
       {"chip_break_mm", 0.2, "Q256: way back to break the chip, 0.1 or more"},
       {"advanced_stop_mm", 0.2, "Q258 and Q259: rapid back into a hole ends so far above its end"},
       {"retraction_feed_mm_min", 99'999.0, "Q208 of cycle 203: feed out of the hole"},
       {"arcs_with_tcp", false,
        "write arcs while TCP is on; not confirmed by a manual of the control"}});
  return rows;
}

const std::vector<OptionRow> rows = all_rows();

struct Options {
  KlartextSettings settings;
  bool native_cycles = true;
  bool arcs_with_tcp = false;
};

Result<Options> read(const machine::Options& given) {
  OptionReader reader{rows, given};
  Options options;
  KlartextSettings& settings = options.settings;
  settings.common = read_common(reader);
  settings.common.block_numbers.letter = false;
  settings.program_name_length =
      static_cast<std::size_t>(reader.whole("program_name_length", 1, 100));
  settings.blank_form = reader.lines("blank_form");
  settings.speed_change = reader.lines("speed_change", {"{speed}"});
  settings.program_stop = reader.lines("program_stop");
  settings.modal_words = reader.flag("modal_words");
  settings.depth_reference = reader.flag("cycle_depth_reference");
  settings.chip_break_mm = reader.number("chip_break_mm", 0.1, 99'999.0);
  settings.advanced_stop_mm = reader.number("advanced_stop_mm", 0.0, 99'999.0);
  settings.retraction_feed_mm_min = reader.number("retraction_feed_mm_min", 0.001, largest_feed);
  options.native_cycles = reader.flag("native_cycles");
  options.arcs_with_tcp = reader.flag("arcs_with_tcp");
  const BlockNumbers& numbers = settings.common.block_numbers;
  // The control numbers the blocks of a program one by one, BEGIN PGM with 0.
  if (numbers.start != 1) reader.refuse("block_number_start", "must be 1: BEGIN PGM is block 0");
  if (numbers.step != 1) reader.refuse("block_number_step", "must be 1: blocks count one by one");
  if (settings.speed_change.empty()) reader.refuse("speed_change", "must hold at least one block");
  if (settings.program_stop.empty()) reader.refuse("program_stop", "must hold at least one block");
  if (reader.problem()) return *reader.problem();
  return options;
}

Result<Abilities> abilities(const machine::Options& given) {
  const auto options = read(given);
  if (!options) return options.error();
  Abilities can = common_abilities(options->settings.common);
  can.largest_feed = largest_feed;
  can.helices = can.arcs;
  can.arcs_with_tcp = can.arcs && options->arcs_with_tcp;
  can.native_cycles = options->native_cycles;
  can.adds_length_always = true;
  can.retract_needs_tool = true;  // M140 goes along the tool axis that the tool call states
  return can;
}

Status write(const path::Motion& motion, const path::ProgramHeader& header,
             const machine::Options& given, std::string& out) {
  const auto options = read(given);
  if (!options) return options.error();
  constexpr std::size_t number_and_code = 12;
  reserve_text(out, motion, number_and_code);
  KlartextWriter writer{motion, options->settings, out};
  writer.start(header);
  if (!walk(motion, writer)) return *writer.problem();
  writer.finish();
  return ok();
}

}  // namespace

const Dialect heidenhain_klartext{
    .name = "heidenhain",
    .title = "Heidenhain TNC, conversational programs",
    .options = rows,
    .abilities = abilities,
    .write = write,
};

}  // namespace pentapost::nc
