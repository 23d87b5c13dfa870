#include "pentapost/nc/readers/heidenhain_functions.hpp"

namespace pentapost::nc::readers {

/// M functions from 89 to 150 belong to the control, the others to the machine.
bool is_harmless_heidenhain_function(int code) {
  if (code < 89) return true;
  if (code > 150) return true;
  switch (code) {
    case 90:   // constant speed at corners
    case 102:  // M101 off
    case 105:  // servo gains
    case 106:
    case 107:  // tool messages off
    case 108:
    case 111:  // M109 and M110 off
    case 113:  // M112 off
    case 115:  // M114 off
    case 134:  // exact stop of rotary axes
    case 135:
    case 137:  // feed per revolution off
    case 145:  // M144 off
    case 148:  // lift-off at a stop
    case 149:
      return true;
    default:
      return false;
  }
}

}  // namespace pentapost::nc::readers
