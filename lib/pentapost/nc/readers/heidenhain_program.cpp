#include "pentapost/nc/readers/heidenhain_program.hpp"

#include "pentapost/core/number_text.hpp"
#include "pentapost/nc/readers/heidenhain_functions.hpp"

#include <cmath>
#include <string>

namespace pentapost::nc::readers::heidenhain {
bool Program::execute(const Block& block) {
  block_ = &block;
  words_.open(block.words);
  preparation_ = -1;
  machine_datum_ = 0;
  new_speed_ = false;
  if (words_->g_count != 0 && !sort_codes()) return false;
  if ((words_->has('S') || words_->has('T')) && !call_tool()) return false;
  if ((words_->m_count != 0 || new_speed_) && !at_block_start()) return false;
  if (preparation_ >= 0) {
    if (!preparatory_block()) return false;
  } else {
    if (!set_feed() || !set_pole()) return false;
    if (!(block.retracts_fully ? retract() : move())) return false;
  }
  return (words_->m_count == 0 || at_block_end()) && words_.nothing_left(items_);
}

bool Program::sort_codes() {
  bool motion_stated = false;
  for (std::size_t i = 0; i < words_->g_count; ++i) {
    const int code = words_->g[i];
    if (code > 3 && !sort_code(code)) return false;
    if (code > 3) continue;
    if (motion_stated) return items_.fail(Code::not_in_dialect, "two motion codes in one block");
    motion_stated = true;
    modes_.motion = code;
  }
  if (motion_stated && preparation_ >= 0)
    return items_.fail(Code::not_in_dialect,
                       "G" + std::to_string(preparation_) + " and a motion code in one block");
  return true;
}

bool Program::sort_code(int code) {
  switch (code) {
    case 17:
    case 18:
    case 19:
      modes_.plane = code;
      return true;
    case 40:  // radius compensation off
    case 90:  // read word by word
    case 91:
      return true;
    case 70:
    case 71:
      if ((code == 70) == is_inch_) return true;
      return items_.fail(Code::not_in_dialect, "the unit is changed within the program");
    case 4:   // dwell
    case 30:  // blank form
    case 31:
    case 38:  // program stop
    case 51:  // next tool
    case 54:  // datum shift
    case 62:  // tolerance
    case 99:  // tool definition
      if (preparation_ >= 0)
        return items_.fail(Code::not_in_dialect, "two functions in one block, G" +
                                                     std::to_string(preparation_) + " and G" +
                                                     std::to_string(code));
      preparation_ = code;
      return true;
    default:
      return items_.fail(Code::not_in_dialect, "G" + std::to_string(code) +
                                                   " is not understood; it may move the machine");
  }
}

bool Program::preparatory_block() {
  switch (preparation_) {
    case 4:
      if (!words_.take('F')) return items_.fail(Code::not_in_dialect, "G4 takes the time as F");
      return true;
    case 30:
    case 31:
      words_.drop(columns_.letter_bits());
      return true;
    case 51:
      words_.take('T');
      return true;
    case 54:
      return shift_datum();
    case 99:
      words_.take('T');
      words_.take('L');
      words_.take('R');
      return true;
    default:
      return true;
  }
}

bool Program::at_block_start() {
  for (std::size_t i = 0; i < words_->m_count; ++i)
    if (!start_function(words_->m[i])) return false;
  if (!new_speed_ || modes_.spindle.state == ReadSpindle::State::off) return true;
  return items_.send(modes_.spindle);
}

bool Program::start_function(int code) {
  switch (code) {
    case 3:
    case 4:
    case 13:
    case 14:
      modes_.spindle.state = code == 3 || code == 13 ? ReadSpindle::State::clockwise
                                                     : ReadSpindle::State::counterclockwise;
      new_speed_ = false;
      return items_.send(modes_.spindle);
    case 91:
    case 92:
      if (machine_datum_ != 0) return items_.fail(Code::not_in_dialect, "M91 and M92 in one block");
      machine_datum_ = code;
      return true;
    case 116:
      modes_.rotary_feed_in_mm = true;
      break;
    case 117:
      modes_.rotary_feed_in_mm = false;
      return true;
    case 126:
      modes_.shortest_way = true;
      return true;
    case 127:
      modes_.shortest_way = false;
      return true;
    case 128:
      if (!modes_.tcp) columns_.forget(columns_.linear());
      modes_.tcp = true;
      break;
    case 129:
    case 140:
      return true;
    default:
      if (is_harmless_heidenhain_function(code)) return true;
      return items_.fail(Code::not_in_dialect, "M" + std::to_string(code) +
                                                   " is not understood; it may move the machine");
  }
  if (modes_.tcp && modes_.rotary_feed_in_mm)
    return items_.fail(Code::not_in_dialect, "M116 and M128 exclude each other");
  return true;
}

bool Program::at_block_end() {
  for (std::size_t i = 0; i < words_->m_count; ++i)
    if (!end_function(words_->m[i])) return false;
  return !ended_ || items_.send(ReadEnd{});
}

bool Program::end_function(int code) {
  switch (code) {
    case 2:
    case 30:
      ended_ = true;
      return true;
    case 5:
    case 19:
      modes_.spindle.state = ReadSpindle::State::off;
      return items_.send(modes_.spindle);
    case 6:
      if (modes_.tcp) return items_.fail(Code::not_in_dialect, "M6 while M128 is on");
      columns_.forget(columns_.linear());
      return true;
    case 129:
      if (modes_.tcp) columns_.forget(columns_.linear());
      modes_.tcp = false;
      return true;
    default:
      return true;
  }
}

bool Program::call_tool() {
  if (words_.take('S')) {
    const double speed = words_['S'];
    if (speed < 0.0)
      return items_.fail(Code::bad_number, "S" + number_text(speed) + " is not a speed");
    modes_.spindle.speed_rpm = speed;
    new_speed_ = true;
  }
  // With G51 and G99 the number only names a tool.
  if (preparation_ >= 0 || !words_.take('T')) return true;
  const double number = words_['T'];
  constexpr double largest_number = 32767.0;
  if (number < 0.0 || number > largest_number || number != std::floor(number))
    return items_.fail(Code::bad_number, "T" + number_text(number) + " is not a tool number");
  if (modes_.tcp) return items_.fail(Code::not_in_dialect, "a tool call while M128 is on");
  if (words_.any_left(columns_.letter_bits()))
    return items_.fail(Code::not_in_dialect, "a tool call and axis words in one block");
  modes_.tool = static_cast<int>(number);
  columns_.forget(columns_.linear());  // the change takes the tool to its own place
  return items_.send(ReadTool{modes_.tool});
}

/// G54 with axis words: the datum lies there, in G91 so far from where it lay. No axis moves; an
/// axis that is not stated keeps its shift.
bool Program::shift_datum() {
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    const char letter = columns_.letter(column);
    if (!words_.take(letter)) continue;
    double shift = 0.0;
    if (!block_->distance)
      return items_.fail(Code::not_in_dialect, std::string{letter} + " before G90 or G91");
    if (!value_of(letter, columns_.is_linear(column), shift)) return false;
    if (is_relative(letter)) shift += modes_.datum_shift[column];
    columns_.position[column] += modes_.datum_shift[column] - shift;
    modes_.datum_shift[column] = shift;
  }
  modes_.pole_x_mm.reset();
  modes_.pole_y_mm.reset();
  return true;
}

bool Program::set_feed() {
  if (!words_.take('F')) return true;
  const double feed = words_['F'];
  constexpr double largest_feed = 99'999.999;
  if (feed < 0.0 || feed > largest_feed)
    return items_.fail(Code::bad_number,
                       "F" + number_text(feed) + " is out of the control's range");
  if (feed == 0.0) return items_.fail(Code::no_feed, "F0 is no feed");
  modes_.feed = feed;
  return true;
}

bool Program::retract() {
  if (words_.any_left(columns_.letter_bits()))
    return items_.fail(Code::not_in_dialect, "M140 and axis words in one block");
  columns_.forget(columns_.linear());  // along the tool axis, wherever that points
  return items_.send(ReadSafeRetract{});
}

}  // namespace pentapost::nc::readers::heidenhain
