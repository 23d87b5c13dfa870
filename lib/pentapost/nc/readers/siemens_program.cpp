#include "pentapost/nc/readers/siemens_program.hpp"

#include "pentapost/core/number_text.hpp"

#include <cmath>
#include <string>

namespace pentapost::nc::readers::siemens {
namespace {

/// Groups of G codes, of which a block may have one each (Fundamentals, G functions).
enum Group : std::uint32_t {
  motion_group = 1U << 0U,
  plane_group = 1U << 1U,
  offset_group = 1U << 2U,
  unit_group = 1U << 3U,
  distance_group = 1U << 4U,
  feed_group = 1U << 5U,
  one_shot_group = 1U << 6U,
};

constexpr int largest_edge = 32'000;
constexpr int largest_tool = 32'000;

/// M70 makes an axis of the spindle, M98 and M99 call programs on controls that speak ISO.
bool is_harmless_function(int code) { return code != 70 && code != 98 && code != 99; }

}  // namespace

bool Program::execute(const Block& block) {
  block_ = &block;
  words_.open(block.words);
  groups_ = 0;
  is_dwell_ = is_machine_frame_ = false;
  if (words_->g_count != 0 && !sort_codes()) return false;
  if (is_dwell_) return dwell() && words_.nothing_left(items_);
  if (words_->has('F') && !set_feed()) return false;
  if (!before_motion()) return false;
  is_machine_frame_ = is_machine_frame_ || block.machine_frame;
  bool done = false;
  if (block.has_statement && (block.orientation_on || block.orientation_off))
    done = orientation();
  else if (block.shift || block.bare_shift)
    done = shift();
  else if (block.modal_call || block.cycle)
    done = call_cycle();
  else if (is_machine_frame_)
    done = machine_move();
  else
    done = modal_cycle_ ? move_and_drill() : move();
  return done && after_motion() && words_.nothing_left(items_);
}

bool Program::sort_codes() {
  for (std::size_t i = 0; i < words_->g_count; ++i)
    if (!sort_code(words_->g[i])) return false;
  return true;
}

bool Program::state(std::uint32_t group, int code) {
  if ((groups_ & group) != 0)
    return items_.fail(Code::not_in_dialect, "a second G code of the same group, G" +
                                                 std::to_string(code) + ", in one block");
  groups_ |= group;
  return true;
}

bool Program::sort_code(int code) {
  switch (code) {
    case 0:
    case 1:
    case 2:
    case 3:
      modes_.motion = code;
      return state(motion_group, code);
    case 4:
      return is_dwell_ = state(one_shot_group, code);
    case 17:
    case 18:
    case 19:
      modes_.plane = code;
      return state(plane_group, code);
    case 53:
    case 153:
      return is_machine_frame_ = state(one_shot_group, code);
    case 70:
      return state(unit_group, code) && set_unit(Modes::Unit::inch_lengths);
    case 700:
      return state(unit_group, code) && set_unit(Modes::Unit::inch);
    case 71:
    case 710:
      return state(unit_group, code) && set_unit(Modes::Unit::metric);
    case 90:
    case 91:
      modes_.absolute = code == 90;
      return state(distance_group, code);
    case 93:
    case 94:
    case 95:
      if (modes_.feed_mode != code) modes_.feed.reset();
      modes_.feed_mode = code;
      return state(feed_group, code);
    default:
      break;
  }
  const bool is_offset = (code >= 54 && code <= 57) || code == 500 || (code >= 505 && code <= 599);
  if (is_offset) return state(offset_group, code) && set_work_offset(code);
  return is_harmless_g(code) ||
         items_.fail(Code::not_in_dialect,
                     "G" + std::to_string(code) + " is not understood; it may move the machine");
}

/// G70 and G71 leave the feed to the control's basic system, which is taken to be metric; G700 and
/// G710 include it (Fundamentals, inch or metric dimensions).
bool Program::set_unit(Modes::Unit unit) {
  if (modes_.unit && modes_.unit != unit)
    return items_.fail(Code::not_in_dialect, "the unit is changed within the program");
  modes_.unit = unit;
  return true;
}

bool Program::set_work_offset(int code) {
  const int offset = code == 500 ? 0 : code;
  if (offset == modes_.work_offset) return true;
  if (modes_.tcp) return items_.fail(Code::not_in_dialect, "a new work offset while TRAORI is on");
  modes_.work_offset = offset;
  columns_.forget(columns_.all());
  return true;
}

/// G4 F in seconds or S in turns of the spindle; neither is a feed or a speed then.
bool Program::dwell() {
  if (words_.take('F') == words_.take('S') || block_->has_statement || words_->m_count != 0)
    return items_.fail(Code::not_in_dialect, "G4 stands alone with one of F and S");
  return true;
}

bool Program::set_feed() {
  words_.take('F');
  const double feed = words_['F'];
  if (!modes_.feed_mode)
    return items_.fail(Code::not_in_dialect, "F before one of G93, G94 and G95");
  if (!modes_.unit) return items_.fail(Code::not_in_dialect, "F before G70 or G71");
  if (!(feed > 0.0)) return items_.fail(Code::no_feed, "F" + number_text(feed) + " is no feed");
  modes_.feed_is_inch = modes_.unit == Modes::Unit::inch && modes_.feed_mode != 93;
  modes_.feed = feed;
  return true;
}

bool Program::before_motion() {
  const bool new_speed = words_.take('S');
  if (new_speed) {
    const double speed = words_['S'];
    if (speed < 0.0)
      return items_.fail(Code::bad_number, "S" + number_text(speed) + " is not a speed");
    modes_.spindle.speed_rpm = speed;
  }
  if ((words_->has('T') || words_->has('D')) && !set_edge()) return false;
  const auto state = modes_.spindle.state;
  if (words_->m_count != 0 && !start_functions()) return false;
  if (!new_speed || state != modes_.spindle.state || state == ReadSpindle::State::off) return true;
  return items_.send(modes_.spindle);
}

bool Program::start_functions() {
  for (std::size_t i = 0; i < words_->m_count; ++i)
    if (!start_function(words_->m[i])) return false;
  return true;
}

bool Program::start_function(int code) {
  switch (code) {
    case 3:
      return turn_spindle(ReadSpindle::State::clockwise);
    case 4:
      return turn_spindle(ReadSpindle::State::counterclockwise);
    case 6:
      return change_tool();
    default:
      return is_harmless_function(code) ||
             items_.fail(Code::not_in_dialect, "M" + std::to_string(code) +
                                                   " is not understood; it may move the machine");
  }
}

bool Program::turn_spindle(ReadSpindle::State state) {
  modes_.spindle.state = state;
  return items_.send(modes_.spindle);
}

/// A new length acts with the next move of its axis and moves nothing itself. Beside a T the D is
/// that of the tool to come.
bool Program::set_edge() {
  std::optional<int> tool, edge;
  if (!take_integer('T', largest_tool, tool) || !take_integer('D', largest_edge, edge))
    return false;
  if (tool) {
    modes_.tool = tool;
    modes_.tool_edge = edge;
    if (edge && words_->m_count == 0) modes_.edge = {.number = {}, .is_open = true};
    if (edge) columns_.forget(modes_.tcp ? columns_.linear() : columns_.bit_of('Z'));
    return true;
  }
  modes_.tool_edge = edge;
  if (edge == modes_.edge.number) return true;
  modes_.edge = {.number = edge, .is_open = false};
  columns_.forget(modes_.tcp ? columns_.linear() : columns_.bit_of('Z'));
  return true;
}

bool Program::change_tool() {
  if (!modes_.tool) return items_.fail(Code::not_in_dialect, "M6 before any T");
  if (modes_.tcp || modal_cycle_)
    return items_.fail(Code::not_in_dialect, "M6 while TRAORI or a modal cycle is on");
  if (words_.any_left(columns_.letter_bits()))
    return items_.fail(Code::not_in_dialect, "M6 and axis words in one block");
  columns_.forget(columns_.linear());  // the change takes the tool to its own place
  const auto edge = modes_.tool_edge ? modes_.tool_edge : edge_after_change_;
  modes_.edge = {.number = edge, .is_open = !edge};
  modes_.tool_edge.reset();
  return items_.send(ReadTool{*modes_.tool});
}

bool Program::orientation() {
  if (words_.any_left(columns_.letter_bits()) || modal_cycle_ || is_machine_frame_ ||
      (block_->orientation_on && block_->orientation_off))
    return items_.fail(Code::not_in_dialect,
                       "TRAORI and TRAFOOF are understood without axis words and cycles");
  if (modes_.tcp || block_->orientation_on) columns_.forget(columns_.linear());
  modes_.tcp = block_->orientation_on;
  return true;
}

/// A block of TRANS, ROT, SCALE or MIRROR: alone it takes all such shifts back.
bool Program::shift() {
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    const char letter = columns_.letter(column);
    if (!words_.take(letter)) continue;
    if (block_->bare_shift || words_[letter] != 0.0)
      return items_.fail(Code::not_in_dialect,
                         "a shift, rotation, scale or mirror of the workpiece is not read");
  }
  return !has_arc_words() || items_.fail(Code::not_in_dialect, "a shift in a block with an arc");
}

bool Program::after_motion() {
  if (block_->spindle_stop && !turn_spindle(ReadSpindle::State::off)) return false;
  for (std::size_t i = 0; i < words_->m_count; ++i)
    if (!end_function(words_->m[i])) return false;
  ended_ = ended_ || block_->program_end;
  return !ended_ || items_.send(ReadEnd{});
}

bool Program::end_function(int code) {
  switch (code) {
    case 2:
    case 17:
    case 30:
      ended_ = true;
      return true;
    case 5:
    case 19:
      return turn_spindle(ReadSpindle::State::off);
    default:
      return true;
  }
}

bool Program::take_integer(char letter, int largest, std::optional<int>& number) {
  if (!words_.take(letter)) return true;
  const double given = words_[letter];
  if (!(given >= 0.0 && given <= largest) || given != std::floor(given))
    return items_.fail(Code::bad_number, std::string{letter} + number_text(given) +
                                             " is not a number that the control takes");
  number = static_cast<int>(given);
  return true;
}

}  // namespace pentapost::nc::readers::siemens
