#include "pentapost/core/number_text.hpp"
#include "pentapost/nc/readers/siemens_program.hpp"

#include <cmath>
#include <string>

// Programming Guide Cycles (PGZ) 11.02, 2.1 Drilling cycles, and Job planning, Programming cycles
// externally: order and meaning of the parameters.
namespace pentapost::nc::readers::siemens {
namespace {

using Hole = ReadMotion::Hole;
using State = ReadSpindle::State;

/// Levels that two parameters give, one absolute and one from the reference plane.
constexpr double same_level_mm = 1e-6;
constexpr double largest_level_mm = 999'999.999'9;

std::string_view cycle_word(int number) {
  switch (number) {
    case 81:
      return "CYCLE81";
    case 82:
      return "CYCLE82";
    case 83:
      return "CYCLE83";
    case 84:
      return "CYCLE84";
    case 85:
      return "CYCLE85";
    default:
      return "CYCLE86";
  }
}

/// 3, 4 and 5 as in M3, M4 and M5.
std::optional<State> spindle_state(double code) {
  if (code == 3.0) return State::clockwise;
  if (code == 4.0) return State::counterclockwise;
  if (code == 5.0) return State::off;
  return std::nullopt;
}

}  // namespace

bool Program::call_cycle() {
  if (words_.any_left(columns_.letter_bits()) || is_machine_frame_)
    return items_.fail(Code::not_in_dialect, "a cycle and axis words in one block");
  if (!block_->cycle) {
    modal_cycle_.reset();
    return true;
  }
  if (modes_.plane != 17)
    return items_.fail(Code::bad_cycle, "a drilling cycle outside of the plane G17");
  if (modes_.tcp) return items_.fail(Code::bad_cycle, "a drilling cycle while TRAORI is on");
  if (columns_.bit_of('Z') == 0)
    return items_.fail(Code::bad_cycle, "a drilling cycle on a machine without Z");
  if (modes_.unit != Modes::Unit::metric)
    return items_.fail(Code::bad_cycle, "a drilling cycle before G71 or G710");
  Drilling drilling;
  if (!read_cycle(*block_->cycle, drilling)) return false;
  if (!block_->modal_call) return drill(drilling);
  modal_cycle_ = drilling;
  return true;
}

bool Program::read_cycle(const CycleCall& call, Drilling& drilling) {
  drilling.cycle = cycle_word(call.number);
  if (!levels(call, drilling)) return false;
  switch (call.number) {
    case 83:
      return deep_hole(call, drilling);
    case 84:
      return tapping(call, drilling);
    case 85:
    case 86:
      return boring(call, drilling);
    default:
      drilling.dwell_s = call.parameter[5];
      return nothing_behind(call, 6);
  }
}

/// RTP, RFP, SDIS, DP and DPR. A depth of 0 is the same as none, for the cycle cannot tell them
/// apart.
bool Program::levels(const CycleCall& call, Drilling& drilling) {
  const double reference_z = call.parameter[1], safety_mm = call.parameter[2];
  const double depth_z = call.parameter[3], relative_depth_mm = call.parameter[4];
  for (std::size_t i = 0; i < 5; ++i)
    if (std::abs(call.parameter[i]) > largest_level_mm)
      return items_.fail(Code::bad_number, "a level of the cycle is out of the control's range");
  drilling.retraction_z = call.parameter[0];
  drilling.clearance_z = reference_z + safety_mm;
  drilling.bottom_z = depth_z;
  if (relative_depth_mm != 0.0) {
    drilling.bottom_z = reference_z - relative_depth_mm;
    if (depth_z != 0.0 && std::abs(depth_z - drilling.bottom_z) > same_level_mm)
      return items_.fail(Code::bad_cycle, "DP and DPR of the cycle are different depths");
  }
  if (safety_mm < 0.0 || relative_depth_mm < 0.0 || drilling.bottom_z > drilling.clearance_z ||
      drilling.retraction_z < reference_z)
    return items_.fail(Code::bad_cycle, "the levels of the cycle are not in their order");
  return true;
}

/// ... DTB, as of FDEP, FDPR, DAM, DTB, DTS, FRF, VARI, AXN, MDEP, VRT.
bool Program::deep_hole(const CycleCall& call, Drilling& drilling) {
  const double reference_z = call.parameter[1];
  const double first_z = call.parameter[5], first_mm = call.parameter[6];
  const double degression = call.parameter[7], first_feed_ratio = call.parameter[10];
  const double kind = call.parameter[11];
  drilling.peck_mm = first_mm != 0.0 ? first_mm : first_z != 0.0 ? reference_z - first_z : 0.0;
  if (first_mm != 0.0 && first_z != 0.0 &&
      std::abs(reference_z - first_z - first_mm) > same_level_mm)
    return items_.fail(Code::bad_cycle, "FDEP and FDPR of the cycle are different depths");
  if (!(drilling.peck_mm > 0.0))
    return items_.fail(Code::bad_cycle, "CYCLE83 without a first depth");
  if (kind != 0.0 && kind != 1.0)
    return items_.fail(Code::bad_cycle, "CYCLE83 with a VARI that is not understood");
  drilling.hole = kind == 1.0 ? Hole::deep : Hole::break_chip;
  const bool is_even = degression == 0.0 && call.parameter[9] == 0.0 &&
                       (first_feed_ratio == 0.0 || first_feed_ratio == 1.0);
  if (!is_even) drilling.hole = Hole::other;
  drilling.dwell_s = call.parameter[8];
  if (call.parameter[12] != 0.0 && call.parameter[12] != 3.0)
    return items_.fail(Code::bad_cycle, "CYCLE83 along another axis than Z");
  return nothing_behind(call, 15);
}

/// ... DTB, SDAC, MPIT, PIT, POSS, SST, SST1, AXN.
bool Program::tapping(const CycleCall& call, Drilling& drilling) {
  const double pitch_mm = call.parameter[8], speed_rpm = call.parameter[10];
  if (call.parameter[7] != 0.0)
    return items_.fail(Code::bad_cycle, "CYCLE84 with a thread size, MPIT, is not read");
  if (pitch_mm == 0.0 || !(std::abs(pitch_mm) <= largest_level_mm))
    return items_.fail(Code::bad_cycle, "CYCLE84 without a pitch");
  if (!(speed_rpm > 0.0)) return items_.fail(Code::bad_cycle, "CYCLE84 without a speed");
  drilling.hole = pitch_mm > 0.0 ? Hole::tap : Hole::tap_left;
  drilling.pitch_mm = std::abs(pitch_mm);
  drilling.feed_mm_min = drilling.pitch_mm * speed_rpm;
  drilling.dwell_s = call.parameter[5];
  drilling.spindle_after = spindle_state(call.parameter[6]);
  if (!drilling.spindle_after)
    return items_.fail(Code::bad_cycle, "CYCLE84 without a direction of the spindle, SDAC");
  if (call.parameter[12] != 0.0 && call.parameter[12] != 3.0)
    return items_.fail(Code::bad_cycle, "CYCLE84 along another axis than Z");
  return nothing_behind(call, 13);
}

/// CYCLE85: ... DTB, FFR, RFF. CYCLE86: ... DTB, SDIR, RPA, RPO, RPAP, POSS; the spindle stands at
/// the bottom, and behind the cycle.
bool Program::boring(const CycleCall& call, Drilling& drilling) {
  drilling.dwell_s = call.parameter[5];
  if (call.number == 85) {
    drilling.hole = Hole::feed_out;
    drilling.feed_mm_min = call.parameter[6];
    if (!(drilling.feed_mm_min > 0.0 && call.parameter[7] > 0.0))
      return items_.fail(Code::no_feed, "CYCLE85 without its feeds");
    return nothing_behind(call, 8);
  }
  const bool lifts_off =
      call.parameter[7] != 0.0 || call.parameter[8] != 0.0 || call.parameter[9] != 0.0;
  drilling.hole = lifts_off ? Hole::other : Hole::spindle_stop;
  drilling.spindle_before = spindle_state(call.parameter[6]);
  if (!drilling.spindle_before || drilling.spindle_before == State::off)
    return items_.fail(Code::bad_cycle, "CYCLE86 without a direction of the spindle, SDIR");
  drilling.spindle_after = State::off;
  return nothing_behind(call, 11);
}

bool Program::nothing_behind(const CycleCall& call, std::size_t count) {
  for (std::size_t i = count; i < call.parameter.size(); ++i)
    if (call.parameter[i] != 0.0)
      return items_.fail(Code::bad_cycle, "parameter " + std::to_string(i + 1) + " of " +
                                              std::string{cycle_word(call.number)} +
                                              " is not evaluated");
  return true;
}

/// MCALL drills where its block leads. A block that moves other axes than X and Y is a motion of
/// its own.
bool Program::move_and_drill() {
  if (!words_.any_left(columns_.letter_bits()) && !has_arc_words()) return true;
  const bool is_straight = !has_arc_words() && modes_.motion && *modes_.motion <= 1;
  if (!(is_straight && goes_across()) && !move()) return false;
  return drill(*modal_cycle_);
}

/// Whether the axes other than X and Y stay where they are.
bool Program::goes_across() const {
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    const char letter = columns_.letter(column);
    const std::uint32_t bit = letter_bit(letter);
    if (letter == 'X' || letter == 'Y' || !words_.any_left(bit)) continue;
    const bool is_plain = !columns_.is_linear(column) && modes_.absolute == true &&
                          (block_->incremental & bit) == 0 && (columns_.known >> column & 1U) != 0;
    if (!is_plain || words_[letter] != columns_.position[column]) return false;
  }
  return true;
}

/// The control moves across at the level where the tool is, by the block, and then along Z to the
/// clearance.
bool Program::drill(const Drilling& drilling) {
  ReadMotion motion = started_motion(ReadMotion::Kind::drill);
  const std::uint8_t z_bit = columns_.bit_of('Z');
  const std::size_t z = columns_.column_of('Z');
  if (modes_.feed_mode == 93) return items_.fail(Code::bad_cycle, "a drilling cycle in G93");
  if (!length_is_certain(z_bit)) return false;
  motion.stated = words_.take_columns(columns_);
  motion.position = columns_.position;
  if (!take_targets(motion.stated, motion)) return false;
  motion.known = static_cast<std::uint8_t>(columns_.known | motion.stated | z_bit);
  columns_.position = motion.position;
  if ((columns_.known & z_bit) != 0) motion.travel_z_mm = columns_.position[z];
  motion.position[z] = drilling.bottom_z;
  motion.clearance_z_mm = drilling.clearance_z;
  motion.retract_z_mm = drilling.retraction_z;
  motion.peck_mm = drilling.peck_mm;
  motion.dwell_s = drilling.dwell_s;
  motion.pitch_mm = drilling.pitch_mm;
  motion.hole = drilling.hole;
  motion.cycle = drilling.cycle;
  if (drilling.feed_mm_min > 0.0) {
    motion.feed_mode = ReadMotion::Feed::per_minute;
    motion.feed = drilling.feed_mm_min;
  } else {
    ReadMotion along_z;
    along_z.stated = z_bit;
    if (!fill_feed(along_z)) return false;
    motion.feed_mode = along_z.feed_mode;
    motion.feed = along_z.feed;
  }
  const auto turn = [this](const std::optional<State>& state) {
    return !state || *state == modes_.spindle.state || turn_spindle(*state);
  };
  if (!turn(drilling.spindle_before) || !items_.send(motion)) return false;
  columns_.known = motion.known;
  columns_.position[z] = drilling.retraction_z;
  return turn(drilling.spindle_after);
}

}  // namespace pentapost::nc::readers::siemens
