#pragma once

#include <cstdint>
#include <string_view>

namespace pentapost::nc::readers::siemens {

/// What the reader does with a word of more than one letter.
enum class Meaning : std::uint8_t {
  harmless,          ///< moves nothing and changes no word's meaning
  harmless_call,     ///< the same, with (...) behind it
  harmless_value,    ///< the same, with [...] or = or both behind it
  zero_value,        ///< harmless where its value is 0
  orientation_on,    ///< TRAORI
  orientation_off,   ///< TRAFOOF
  machine_frame,     ///< SUPA
  modal_call,        ///< MCALL
  drilling_cycle,    ///< CYCLE81 to CYCLE86
  high_speed_cycle,  ///< CYCLE832
  feed_group,        ///< FGROUP
  shift,             ///< TRANS and others that are nothing with zeros
  bare_shift,        ///< SCALE and MIRROR: nothing only where no axis follows
  radius,            ///< CR=
  turns,             ///< TURN=
  spindle_stop,      ///< SPOS=: the spindle stands then
  program_end,       ///< RET
  vector,            ///< directions of the tool axis
  jump,              ///< jumps, loops, calls of sub-programs
  variable,          ///< definitions and calculations
  swivel,            ///< CYCLE800
  unknown,
};

/// @param name  in upper case.
Meaning meaning_of(std::string_view name);

/// Whether G<code> moves nothing and changes no word's meaning.
bool is_harmless_g(int code);

}  // namespace pentapost::nc::readers::siemens
