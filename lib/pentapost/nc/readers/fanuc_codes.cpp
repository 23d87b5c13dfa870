#include "pentapost/nc/readers/fanuc_codes.hpp"

namespace pentapost::nc::readers::fanuc {
namespace {

std::optional<Group> group_of(int code) {
  switch (code) {
    case 0:
    case 10:
    case 20:
    case 30:
      return Group::motion;
    case 170:
    case 180:
    case 190:
      return Group::plane;
    case 900:
    case 910:
      return Group::distance;
    case 930:
    case 940:
    case 950:
      return Group::feed_mode;
    case 200:
    case 210:
      return Group::unit;
    case 430:
    case 434:
    case 490:
      return Group::length;
    case 730:
    case 740:
    case 760:
    case 800:
    case 810:
    case 820:
    case 830:
    case 840:
    case 850:
    case 860:
    case 880:
    case 890:
      return Group::cycle;
    case 980:
    case 990:
      return Group::return_level;
    case 540:
    case 541:
    case 550:
    case 560:
    case 570:
    case 580:
    case 590:
      return Group::work_offset;
    case 40:   // dwell
    case 50:   // high-speed machining, G05 P10000
    case 51:   // AI contour control, G05.1 Q1
    case 80:   // look-ahead, G08 P1
    case 280:  // reference return
    case 530:  // machine coordinates
      return Group::one_shot;
    case 90:   // exact stop
    case 131:  // polar interpolation off
    case 150:  // polar coordinates off
    case 230:  // stored stroke check off
    case 400:  // cutter compensation off
    case 500:  // scaling off
    case 501:  // mirror off
    case 610:  // exact stop mode
    case 640:  // cutting mode
    case 670:  // modal macro off
    case 690:  // rotation off
    case 970:  // constant surface speed off
      return Group::cancelled;
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<GCode> understood(int code) {
  const auto group = group_of(code);
  if (!group) return std::nullopt;
  return GCode{*group, code};
}

bool is_harmless_function(int m_code) {
  switch (m_code) {
    case 60:  // pallet change
    case 96:  // macro interrupt
    case 97:
    case 98:   // subprogram call
    case 99:   // subprogram end
    case 198:  // subprogram call from a device
      return false;
    default:
      return true;
  }
}

}  // namespace pentapost::nc::readers::fanuc
