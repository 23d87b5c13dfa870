#pragma once

#include "pentapost/nc/dialect.hpp"
#include "pentapost/nc/options.hpp"
#include "pentapost/path/tool_path.hpp"

#include <string>
#include <vector>

namespace pentapost::nc {

/// Numbers of the blocks of a program.
struct BlockNumbers {
  bool on = false;
  int start = 10;
  int step = 10;
  bool letter = true;  ///< "N10" rather than "10"
};

/// Codes that switch the coolant; empty: the control has none for it.
struct CoolantCodes {
  std::string flood = "M8";
  std::string mist = "M7";
  std::string through = {};
  std::string air = {};
  std::string off = "M9";
};

/// What shops change on every control: the options that all dialects share, read and checked.
/// A dialect states its defaults as a value of this type.
struct CommonSettings {
  int decimals_mm = 3;
  int decimals_deg = 3;
  int feed_decimals = 0;
  bool comments = true;
  BlockNumbers block_numbers;
  std::vector<std::string> start_lines;
  std::vector<std::string> end_lines;
  std::vector<std::string> safe_retract;
  std::vector<std::string> tool_change;
  std::vector<std::string> tcp_on;
  std::vector<std::string> tcp_off;
  std::vector<std::string> smoothing_on;
  std::vector<std::string> smoothing_off;
  CoolantCodes coolant;
  bool arcs = true;
  bool rapid_as_line = false;
  double rapid_feed_mm_min = 0.0;
  double rotary_feed_deg_min = 0.0;
  double retract_mm = 100.0;
  double plunge_feed_mm_min = 0.0;
};

/// The rows of the shared options, with a dialect's defaults.
std::vector<OptionRow> common_rows(const CommonSettings& defaults);

/// Reads the shared options; the reader keeps what is wrong with them.
CommonSettings read_common(OptionReader& reader);

/// The abilities that the shared options decide; what is left is the dialect's.
Abilities common_abilities(const CommonSettings& settings);

/// The code for a coolant state; nullptr: the control has none.
const std::string* coolant_code(const CoolantCodes& codes, path::Coolant::State state);

/// The option that holds the code for a coolant state, for messages.
std::string_view coolant_option(path::Coolant::State state);

}  // namespace pentapost::nc
