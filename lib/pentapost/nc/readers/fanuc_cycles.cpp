#include "pentapost/nc/readers/fanuc_program.hpp"

#include <string>
#include <string_view>

namespace pentapost::nc::readers::fanuc {
namespace {

std::string_view cycle_word(int code) {
  switch (code) {
    case 730:
      return "G73";
    case 740:
      return "G74";
    case 760:
      return "G76";
    case 810:
      return "G81";
    case 820:
      return "G82";
    case 830:
      return "G83";
    case 840:
      return "G84";
    case 850:
      return "G85";
    case 860:
      return "G86";
    case 880:
      return "G88";
    default:
      return "G89";
  }
}

ReadMotion::Hole hole_of(int code) {
  switch (code) {
    case 810:
    case 820:
      return ReadMotion::Hole::drill;
    case 830:
      return ReadMotion::Hole::deep;
    case 730:
      return ReadMotion::Hole::break_chip;
    case 840:
      return ReadMotion::Hole::tap;
    case 740:
      return ReadMotion::Hole::tap_left;
    case 850:
    case 890:
      return ReadMotion::Hole::feed_out;
    case 860:
      return ReadMotion::Hole::spindle_stop;
    default:
      return ReadMotion::Hole::other;
  }
}

bool is_pecking(int code) { return code == 730 || code == 830; }

bool dwells(int code) {
  return code == 740 || code == 760 || code == 820 || code == 840 || code == 880 || code == 890;
}

}  // namespace

bool Program::cycle_block() {
  const bool drills = words_.any_left(columns_.letter_bits() | letter_bit('R'));
  // Without a position the control does nothing; Q, P and K then stay unread and are refused.
  if (!drills) return true;
  if (modes_.plane != 170)
    return items_.fail(Code::bad_cycle, "a canned cycle outside of the plane G17");
  if (is_tcp()) return items_.fail(Code::bad_cycle, "a canned cycle while G43.4 is on");
  if (modes_.feed_mode == 930) return items_.fail(Code::bad_cycle, "a canned cycle in G93");
  if (columns_.bit_of('Z') == 0)
    return items_.fail(Code::bad_cycle, "a canned cycle on a machine without Z");
  return cycle_data() && cycle_levels() && hole();
}

bool Program::cycle_data() {
  std::optional<int> repeats;
  if (!take_integer('K', repeats) || (!repeats && !take_integer('L', repeats))) return false;
  if (repeats && *repeats != 1)
    return items_.fail(Code::bad_cycle, "repeats of a canned cycle are not understood");
  if (words_.take('Q') && !length_of('Q', cycle_.peck_mm)) return false;
  if (is_pecking(cycle_.code) && !(cycle_.peck_mm > 0.0))
    return items_.fail(Code::bad_cycle, "a pecking cycle without Q");
  std::optional<int> dwell_ms;
  if (!take_integer('P', dwell_ms)) return false;
  if (dwell_ms) cycle_.dwell_s = *dwell_ms / 1000.0;
  return true;
}

/// R and Z of the block: absolute in G90; in G91 R counts from the initial level and Z from R.
bool Program::cycle_levels() {
  if (!modes_.distance) return items_.fail(Code::not_in_dialect, "a cycle before G90 or G91");
  const bool absolute = modes_.distance == 900;
  if (words_.take('R')) {
    double level = 0.0;
    if (!length_of('R', level)) return false;
    if (!absolute && !cycle_.initial_z)
      return items_.fail(Code::bad_cycle, "R in G91 from a level that is not known");
    cycle_.clearance_z = absolute ? level : *cycle_.initial_z + level;
  }
  if (words_.take('Z')) {
    double level = 0.0;
    if (!length_of('Z', level)) return false;
    if (!absolute && !cycle_.clearance_z) return items_.fail(Code::bad_cycle, "Z in G91 without R");
    cycle_.bottom_z = absolute ? level : *cycle_.clearance_z + level;
  }
  if (!cycle_.clearance_z || !cycle_.bottom_z)
    return items_.fail(Code::bad_cycle, "a canned cycle needs R and Z");
  if (modes_.return_to_initial && !cycle_.initial_z)
    return items_.fail(Code::bad_cycle, "G98 from a level that is not known");
  return true;
}

/// The control moves across at the level where the tool is and only then along Z to R, up or down
/// (operator's manual, canned cycles for drilling, operations 1 and 2).
bool Program::hole() {
  ReadMotion motion = started_motion(ReadMotion::Kind::drill);
  const std::size_t z = columns_.column_of('Z');
  motion.stated = words_.take_columns(columns_);
  motion.position = columns_.position;
  for (std::size_t column = 0; column < columns_.size(); ++column)
    if ((motion.stated >> column & 1U) != 0 && !target(column, motion.position[column]))
      return false;
  motion.stated =
      static_cast<std::uint8_t>(motion.stated | (words_->has('Z') ? columns_.bit_of('Z') : 0U));
  motion.known = static_cast<std::uint8_t>(columns_.known | motion.stated | columns_.bit_of('Z'));
  columns_.position = motion.position;
  if ((columns_.known >> z & 1U) != 0) motion.travel_z_mm = columns_.position[z];
  motion.position[z] = *cycle_.bottom_z;
  motion.clearance_z_mm = *cycle_.clearance_z;
  motion.retract_z_mm = modes_.return_to_initial ? *cycle_.initial_z : *cycle_.clearance_z;
  if (is_pecking(cycle_.code)) motion.peck_mm = cycle_.peck_mm;
  if (dwells(cycle_.code)) motion.dwell_s = cycle_.dwell_s;
  motion.hole = hole_of(cycle_.code);
  motion.cycle = cycle_word(cycle_.code);
  ReadMotion along_z;
  along_z.stated = columns_.bit_of('Z');
  if (!fill_feed(along_z)) return false;
  motion.feed_mode = along_z.feed_mode;
  motion.feed = along_z.feed;
  columns_.known = motion.known;
  columns_.position[z] = motion.retract_z_mm;
  return items_.send(motion);
}

}  // namespace pentapost::nc::readers::fanuc
