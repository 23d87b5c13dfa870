#pragma once

#include <cstdint>
#include <optional>

namespace pentapost::nc::readers::fanuc {

/// G codes of one group exclude each other in a block.
enum class Group : std::uint8_t {
  motion,        ///< 01: G00 G01 G02 G03
  plane,         ///< 02
  distance,      ///< 03: G90 G91
  feed_mode,     ///< 05: G93 G94 G95
  unit,          ///< 06
  length,        ///< 08: G43 G43.4 G49
  cycle,         ///< 09
  return_level,  ///< 10: G98 G99
  work_offset,   ///< 14
  one_shot,      ///< 00, not modal
  cancelled,  ///< cancels a mode that is refused when switched on, or path smoothing: moves nothing
};

/// What a G code is; `code` in tenths (434 is G43.4).
struct GCode {
  Group group;
  int code;
};

/// nullopt: the reader does not model this code, so that a program with it must be refused.
std::optional<GCode> understood(int code);

/// False for the M codes that call programs or move axes; M00 to M06, M19 and M30 are modelled.
bool is_harmless_function(int m_code);

}  // namespace pentapost::nc::readers::fanuc
