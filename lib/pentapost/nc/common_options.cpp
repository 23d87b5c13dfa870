#include "pentapost/nc/common_options.hpp"

#include <stdexcept>

namespace pentapost::nc {
namespace {

constexpr int most_decimals = 6;
constexpr double largest_feed = 1e6;

double as_number(int whole) { return whole; }

}  // namespace

std::vector<OptionRow> common_rows(const CommonSettings& defaults) {
  const BlockNumbers& numbers = defaults.block_numbers;
  const CoolantCodes& coolant = defaults.coolant;
  return {
      {"decimals_mm", as_number(defaults.decimals_mm), "decimals of lengths, 0 to 6"},
      {"decimals_deg", as_number(defaults.decimals_deg), "decimals of angles, 0 to 6"},
      {"feed_decimals", as_number(defaults.feed_decimals),
       "decimals of feeds per minute, 0 to 3; feeds are rounded down"},
      {"comments", defaults.comments, "write comments"},
      {"block_numbers", numbers.on, "number the blocks"},
      {"block_number_start", as_number(numbers.start), "number of the first block, 1 or more"},
      {"block_number_step", as_number(numbers.step), "step from block to block, 1 or more"},
      {"start_lines", defaults.start_lines, "blocks at the start of the program"},
      {"end_lines", defaults.end_lines, "blocks at the end of the program, M30 included"},
      {"safe_retract", defaults.safe_retract,
       "blocks that take the tool to the safe end of its travel"},
      {"tool_change", defaults.tool_change,
       "blocks that change the tool; {tool} stands for its number, {speed} for the S word"},
      {"tcp_on", defaults.tcp_on,
       "blocks that switch TCP on; {register} stands for the tool's length register"},
      {"tcp_off", defaults.tcp_off, "blocks that switch TCP off"},
      {"smoothing_on", defaults.smoothing_on,
       "blocks before TCP or the tool length is switched on"},
      {"smoothing_off", defaults.smoothing_off,
       "blocks after TCP or the tool length is switched off"},
      {"coolant_flood", coolant.flood, "code for flood coolant; empty: the machine has none"},
      {"coolant_mist", coolant.mist, "code for mist coolant; empty: the machine has none"},
      {"coolant_through", coolant.through,
       "code for coolant through the spindle; empty: the machine has none"},
      {"coolant_air", coolant.air, "code for air; empty: the machine has none"},
      {"coolant_off", coolant.off, "code that switches all coolant off"},
      {"arcs", defaults.arcs, "write arcs as arcs where the rotary axes stand still"},
      {"rapid_as_line", defaults.rapid_as_line,
       "write rapids as straight moves at rapid_feed_mm_min"},
      {"rapid_feed_mm_min", defaults.rapid_feed_mm_min, "feed of rapids written as straight moves"},
      {"rotary_feed_deg_min", defaults.rotary_feed_deg_min,
       "feed for turning in place where no axis limit gives one; 0: none"},
      {"retract_mm", defaults.retract_mm,
       "retract along the tool axis before a repositioning where no travel bounds it"},
      {"plunge_feed_mm_min", defaults.plunge_feed_mm_min,
       "feed back to the point left by a repositioning; 0: the feed that is active"},
  };
}

CommonSettings read_common(OptionReader& reader) {
  CommonSettings settings;
  settings.decimals_mm = reader.whole("decimals_mm", 0, most_decimals);
  settings.decimals_deg = reader.whole("decimals_deg", 0, most_decimals);
  settings.feed_decimals = reader.whole("feed_decimals", 0, 3);
  settings.comments = reader.flag("comments");
  settings.block_numbers = {.on = reader.flag("block_numbers"),
                            .start = reader.whole("block_number_start", 1, 9999),
                            .step = reader.whole("block_number_step", 1, 1000)};
  settings.start_lines = reader.lines("start_lines");
  settings.end_lines = reader.lines("end_lines");
  settings.safe_retract = reader.lines("safe_retract");
  settings.tool_change = reader.lines("tool_change", {"{tool}", "{speed}"});
  settings.tcp_on = reader.lines("tcp_on", {"{register}"});
  settings.tcp_off = reader.lines("tcp_off");
  settings.smoothing_on = reader.lines("smoothing_on");
  settings.smoothing_off = reader.lines("smoothing_off");
  settings.coolant = {.flood = reader.text("coolant_flood"),
                      .mist = reader.text("coolant_mist"),
                      .through = reader.text("coolant_through"),
                      .air = reader.text("coolant_air"),
                      .off = reader.text("coolant_off")};
  settings.arcs = reader.flag("arcs");
  settings.rapid_as_line = reader.flag("rapid_as_line");
  settings.rapid_feed_mm_min = reader.number("rapid_feed_mm_min", 0.0, largest_feed);
  settings.rotary_feed_deg_min = reader.number("rotary_feed_deg_min", 0.0, largest_feed);
  settings.retract_mm = reader.number("retract_mm", 0.0, 10'000.0);
  settings.plunge_feed_mm_min = reader.number("plunge_feed_mm_min", 0.0, largest_feed);
  const auto need = [&reader](std::string_view name, const std::vector<std::string>& lines) {
    if (lines.empty()) reader.refuse(name, "must hold at least one block");
  };
  need("end_lines", settings.end_lines);
  need("safe_retract", settings.safe_retract);
  need("tool_change", settings.tool_change);
  need("tcp_on", settings.tcp_on);
  need("tcp_off", settings.tcp_off);
  if (settings.coolant.off.empty()) reader.refuse("coolant_off", "must not be empty");
  if (settings.rapid_as_line && settings.rapid_feed_mm_min <= 0.0)
    reader.refuse("rapid_feed_mm_min", "must be above 0 where rapid_as_line is true");
  return settings;
}

Abilities common_abilities(const CommonSettings& settings) {
  return {.decimals_mm = settings.decimals_mm,
          .decimals_deg = settings.decimals_deg,
          .feed_decimals = settings.feed_decimals,
          .arcs = settings.arcs,
          .rapid_is_straight = settings.rapid_as_line,
          .rapid_feed_mm_min = settings.rapid_feed_mm_min,
          .rotary_feed_deg_min = settings.rotary_feed_deg_min,
          .retract_mm = settings.retract_mm,
          .plunge_feed_mm_min = settings.plunge_feed_mm_min};
}

const std::string* coolant_code(const CoolantCodes& codes, path::Coolant::State state) {
  const std::string* code = nullptr;
  switch (state) {
    case path::Coolant::State::off:
      code = &codes.off;
      break;
    case path::Coolant::State::flood:
      code = &codes.flood;
      break;
    case path::Coolant::State::mist:
      code = &codes.mist;
      break;
    case path::Coolant::State::through:
      code = &codes.through;
      break;
    case path::Coolant::State::air:
      code = &codes.air;
      break;
  }
  return code == nullptr || code->empty() ? nullptr : code;
}

std::string_view coolant_option(path::Coolant::State state) {
  switch (state) {
    case path::Coolant::State::off:
      return "coolant_off";
    case path::Coolant::State::flood:
      return "coolant_flood";
    case path::Coolant::State::mist:
      return "coolant_mist";
    case path::Coolant::State::through:
      return "coolant_through";
    case path::Coolant::State::air:
      return "coolant_air";
  }
  throw std::logic_error{"coolant_option: no such state"};
}

}  // namespace pentapost::nc
