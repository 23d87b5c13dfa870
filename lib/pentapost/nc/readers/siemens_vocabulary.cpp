#include "pentapost/nc/readers/siemens_vocabulary.hpp"

#include <algorithm>
#include <array>

namespace pentapost::nc::readers::siemens {
namespace {

struct Row {
  std::string_view name;
  Meaning meaning;
};

/// Job planning, Tables, Operations: words that are not here are refused.
constexpr std::array vocabulary{
    Row{"ACC", Meaning::harmless_value},
    Row{"ACCLIMA", Meaning::harmless_value},
    Row{"ADIS", Meaning::harmless_value},
    Row{"ADISPOS", Meaning::harmless_value},
    Row{"AMIRROR", Meaning::bare_shift},
    Row{"AROT", Meaning::shift},
    Row{"ASCALE", Meaning::bare_shift},
    Row{"ATOL", Meaning::harmless_value},
    Row{"ATRANS", Meaning::shift},
    Row{"BRISK", Meaning::harmless},
    Row{"BRISKA", Meaning::harmless},
    Row{"CALL", Meaning::jump},
    Row{"CALLPATH", Meaning::jump},
    Row{"CASE", Meaning::jump},
    Row{"CDOF", Meaning::harmless},
    Row{"CFC", Meaning::harmless},
    Row{"CFIN", Meaning::harmless},
    Row{"CFTCP", Meaning::harmless},
    Row{"COMPCAD", Meaning::harmless},
    Row{"COMPCURV", Meaning::harmless},
    Row{"COMPOF", Meaning::harmless},
    Row{"COMPON", Meaning::harmless},
    Row{"COMPSURF", Meaning::harmless},
    Row{"CPRECOF", Meaning::harmless},
    Row{"CPRECON", Meaning::harmless},
    Row{"CR", Meaning::radius},
    Row{"CTOL", Meaning::harmless_value},
    Row{"CUT2D", Meaning::harmless},
    Row{"CUT2DF", Meaning::harmless},
    Row{"CUTCONOF", Meaning::harmless},
    Row{"CYCLE800", Meaning::swivel},
    Row{"CYCLE81", Meaning::drilling_cycle},
    Row{"CYCLE82", Meaning::drilling_cycle},
    Row{"CYCLE83", Meaning::drilling_cycle},
    Row{"CYCLE832", Meaning::high_speed_cycle},
    Row{"CYCLE84", Meaning::drilling_cycle},
    Row{"CYCLE85", Meaning::drilling_cycle},
    Row{"CYCLE86", Meaning::drilling_cycle},
    Row{"DEF", Meaning::variable},
    Row{"DEFINE", Meaning::variable},
    Row{"DIAMOF", Meaning::harmless},
    Row{"DO", Meaning::jump},
    Row{"DRIVE", Meaning::harmless},
    Row{"DRIVEA", Meaning::harmless},
    Row{"DYNFINISH", Meaning::harmless},
    Row{"DYNNORM", Meaning::harmless},
    Row{"DYNPOS", Meaning::harmless},
    Row{"DYNPREC", Meaning::harmless},
    Row{"DYNROUGH", Meaning::harmless},
    Row{"DYNSEMIFIN", Meaning::harmless},
    Row{"ELSE", Meaning::jump},
    Row{"ENDFOR", Meaning::jump},
    Row{"ENDIF", Meaning::jump},
    Row{"ENDLOOP", Meaning::jump},
    Row{"ENDWHILE", Meaning::jump},
    Row{"EVERY", Meaning::jump},
    Row{"EXTCALL", Meaning::jump},
    Row{"EXTERN", Meaning::variable},
    Row{"FENDNORM", Meaning::harmless},
    Row{"FFWOF", Meaning::harmless},
    Row{"FFWON", Meaning::harmless},
    Row{"FGREF", Meaning::harmless_value},
    Row{"FGROUP", Meaning::feed_group},
    Row{"FIFOCTRL", Meaning::harmless},
    Row{"FL", Meaning::harmless_value},
    Row{"FNORM", Meaning::harmless},
    Row{"FOR", Meaning::jump},
    Row{"GOTO", Meaning::jump},
    Row{"GOTOB", Meaning::jump},
    Row{"GOTOC", Meaning::jump},
    Row{"GOTOF", Meaning::jump},
    Row{"GOTOS", Meaning::jump},
    Row{"GROUP_ADDEND", Meaning::harmless_call},
    Row{"GROUP_BEGIN", Meaning::harmless_call},
    Row{"GROUP_END", Meaning::harmless_call},
    Row{"ID", Meaning::jump},
    Row{"IDS", Meaning::jump},
    Row{"IF", Meaning::jump},
    Row{"ISOCALL", Meaning::jump},
    Row{"JERKLIMA", Meaning::harmless_value},
    Row{"KONT", Meaning::harmless},
    Row{"LEAD", Meaning::vector},
    Row{"LOOP", Meaning::jump},
    Row{"MCALL", Meaning::modal_call},
    Row{"MIRROR", Meaning::bare_shift},
    Row{"MSG", Meaning::harmless_call},
    Row{"NORM", Meaning::harmless},
    Row{"ORIAXES", Meaning::harmless},
    Row{"ORIEULER", Meaning::harmless},
    Row{"ORIMACHAX", Meaning::harmless},
    Row{"ORIMKS", Meaning::harmless},
    Row{"ORIPLANE", Meaning::harmless},
    Row{"ORIRPY", Meaning::harmless},
    Row{"ORIRPY2", Meaning::harmless},
    Row{"ORISOF", Meaning::harmless},
    Row{"ORISON", Meaning::harmless},
    Row{"ORIVECT", Meaning::harmless},
    Row{"ORIVIRT1", Meaning::harmless},
    Row{"ORIVIRT2", Meaning::harmless},
    Row{"ORIVIRTAX", Meaning::harmless},
    Row{"ORIWKS", Meaning::harmless},
    Row{"OSC", Meaning::harmless},
    Row{"OSD", Meaning::harmless},
    Row{"OSOF", Meaning::harmless},
    Row{"OSS", Meaning::harmless},
    Row{"OSSE", Meaning::harmless},
    Row{"OST", Meaning::harmless},
    Row{"OTOL", Meaning::harmless_value},
    Row{"PAROTOF", Meaning::harmless},
    Row{"PCALL", Meaning::jump},
    Row{"PHI", Meaning::vector},
    Row{"PROC", Meaning::variable},
    Row{"PSI", Meaning::vector},
    Row{"REDEF", Meaning::variable},
    Row{"REPEAT", Meaning::jump},
    Row{"REPEATB", Meaning::jump},
    Row{"RET", Meaning::program_end},
    Row{"ROT", Meaning::shift},
    Row{"RTLIOF", Meaning::harmless},
    Row{"RTLION", Meaning::harmless},
    Row{"SBLOF", Meaning::harmless},
    Row{"SBLON", Meaning::harmless},
    Row{"SCALE", Meaning::bare_shift},
    Row{"SOFT", Meaning::harmless},
    Row{"SOFTA", Meaning::harmless},
    Row{"SPATH", Meaning::harmless},
    Row{"SPOS", Meaning::spindle_stop},
    Row{"SPOSA", Meaning::spindle_stop},
    Row{"STARTFIFO", Meaning::harmless},
    Row{"STOLF", Meaning::harmless_value},
    Row{"STOPFIFO", Meaning::harmless},
    Row{"STOPRE", Meaning::harmless},
    Row{"SUPA", Meaning::machine_frame},
    Row{"TCARR", Meaning::zero_value},
    Row{"TCOABS", Meaning::harmless},
    Row{"THETA", Meaning::vector},
    Row{"TILT", Meaning::vector},
    Row{"TOROTOF", Meaning::harmless},
    Row{"TOWBCS", Meaning::harmless},
    Row{"TOWKCS", Meaning::harmless},
    Row{"TOWMCS", Meaning::harmless},
    Row{"TOWSTD", Meaning::harmless},
    Row{"TOWTCS", Meaning::harmless},
    Row{"TOWWCS", Meaning::harmless},
    Row{"TRAFOOF", Meaning::orientation_off},
    Row{"TRANS", Meaning::shift},
    Row{"TRAORI", Meaning::orientation_on},
    Row{"TURN", Meaning::turns},
    Row{"UNTIL", Meaning::jump},
    Row{"UPATH", Meaning::harmless},
    Row{"WALIMOF", Meaning::harmless},
    Row{"WALIMON", Meaning::harmless},
    Row{"WHEN", Meaning::jump},
    Row{"WHENEVER", Meaning::jump},
    Row{"WHILE", Meaning::jump},
    Row{"WORKPIECE", Meaning::harmless_call},
};
static_assert(std::ranges::is_sorted(vocabulary, {}, &Row::name));

}  // namespace

Meaning meaning_of(std::string_view name) {
  const auto row = std::ranges::lower_bound(vocabulary, name, {}, &Row::name);
  return row != vocabulary.end() && row->name == name ? row->meaning : Meaning::unknown;
}

bool is_harmless_g(int code) {
  switch (code) {
    case 9:    // exact stop in this block
    case 40:   // cutter compensation off
    case 60:   // exact stop
    case 64:   // continuous path, with rounding from 641 on
    case 290:  // the control's own language
    case 450:  // corners of the cutter compensation
    case 451:
    case 601:  // exact stop criteria
    case 602:
    case 603:
    case 621:  // corner deceleration
    case 641:
    case 642:
    case 643:
    case 644:
    case 645:
      return true;
    default:
      return false;
  }
}

}  // namespace pentapost::nc::readers::siemens
