#include "pentapost/nc/readers/fanuc_program.hpp"

#include "pentapost/core/number_text.hpp"

#include <cmath>
#include <string>

namespace pentapost::nc::readers::fanuc {
namespace {

std::string code_text(char letter, int code, int tenths) {
  std::string text{letter};
  text += std::to_string(code);
  if (tenths != 0) text += '.' + std::to_string(tenths);
  return text;
}

std::string g_text(int code) { return code_text('G', code / 10, code % 10); }

}  // namespace

bool Program::execute(const Words& words) {
  words_.open(words);
  groups_ = 0;
  if (words.g_count != 0 && !(sort_codes() && set_modes())) return false;
  const auto special = asked(Group::one_shot);
  if (special != 40 && !set_feed()) return false;
  if (!before_motion()) return false;
  if (asked(Group::work_offset) && !set_work_offset()) return false;
  if ((asked(Group::length) || words.has('H')) && !set_length()) return false;
  const bool done = special ? one_shot(*special) : cycle_.code != 800 ? cycle_block() : move();
  return done && (words.m_count == 0 || after_motion()) && nothing_left();
}

bool Program::nothing_left() {
  words_.drop(letter_bit('D'));  // a radius register acts with G41 and G42 only
  return words_.nothing_left(items_);
}

bool Program::sort_codes() {
  for (std::size_t i = 0; i < words_->g_count; ++i) {
    const auto found = understood(words_->g[i]);
    if (!found)
      return items_.fail(Code::not_in_dialect,
                         g_text(words_->g[i]) + " is not understood; it may move the machine");
    const std::uint32_t bit = 1U << static_cast<unsigned>(found->group);
    if (found->group != Group::cancelled && (groups_ & bit) != 0)
      return items_.fail(Code::not_in_dialect, "a second G code of the same group, " +
                                                   g_text(found->code) + ", in one block");
    groups_ |= bit;
    asked_[static_cast<std::size_t>(found->group)] = found->code;
  }
  return true;
}

std::optional<int> Program::asked(Group group) const {
  if ((groups_ >> static_cast<unsigned>(group) & 1U) == 0) return std::nullopt;
  return asked_[static_cast<std::size_t>(group)];
}

bool Program::set_modes() {
  const auto cycle = asked(Group::cycle);
  const auto motion = asked(Group::motion);
  if (cycle && motion && *cycle != 800)
    return items_.fail(Code::not_in_dialect,
                       g_text(*cycle) + " and " + g_text(*motion) + " in one block");
  const bool in_cycle = cycle_.code != 800;
  if (in_cycle &&
      (asked(Group::unit) || asked(Group::plane) || asked(Group::feed_mode) ||
       asked(Group::work_offset) || asked(Group::length)) &&
      !(motion || cycle == 800))
    return items_.fail(Code::not_in_dialect, "a mode is changed within a canned cycle");
  if (const auto plane = asked(Group::plane)) modes_.plane = plane;
  if (const auto distance = asked(Group::distance)) modes_.distance = distance;
  if (const auto unit = asked(Group::unit)) {
    if (modes_.unit && modes_.unit != unit)
      return items_.fail(Code::not_in_dialect, "the unit is changed within the program");
    modes_.unit = unit;
  }
  if (const auto feed_mode = asked(Group::feed_mode)) {
    if (modes_.feed_mode && modes_.feed_mode != feed_mode) modes_.feed.reset();
    modes_.feed_mode = feed_mode;
  }
  if (const auto level = asked(Group::return_level)) modes_.return_to_initial = *level == 980;
  if (motion) modes_.motion = motion;
  if (motion || cycle == 800) cancel_cycle();
  if (cycle && *cycle != 800) {
    if (!in_cycle) {
      const std::size_t z = columns_.column_of('Z');
      if (z != columns_.size() && (columns_.known >> z & 1U) != 0)
        cycle_.initial_z = columns_.position[z];
    }
    cycle_.code = *cycle;
  }
  return true;
}

bool Program::set_feed() {
  // In G93 a feed holds for its own block only.
  if (modes_.feed_mode == 930) modes_.feed.reset();
  if (!words_.take('F')) return true;
  double feed = words_['F'];
  if (!modes_.feed_mode)
    return items_.fail(Code::not_in_dialect, "F before one of G93, G94 and G95");
  if (!modes_.unit) return items_.fail(Code::not_in_dialect, "F before G20 or G21");
  if (!(feed > 0.0)) return items_.fail(Code::no_feed, "F" + number_text(feed) + " is no feed");
  modes_.feed_is_inch = modes_.unit == 200 && modes_.feed_mode != 930;
  if (!words_.is_pointed('F')) {
    if (modes_.feed_is_inch || modes_.feed_mode == 950)
      return items_.fail(Code::not_in_dialect,
                         "F without a decimal point in G20 or G95 depends on parameters");
    if (modes_.feed_mode == 930) feed /= 1000.0;  // F1 is 0.001/min, operator's manual, G93
  }
  modes_.feed = feed;
  return true;
}

bool Program::set_work_offset() {
  int offset = *asked(Group::work_offset) / 10;
  std::optional<int> additional;
  if (!take_integer('P', additional)) return false;
  if (additional || asked(Group::work_offset) == 541) {
    if (offset != 54 || !additional || *additional < 1 || *additional > 300)
      return items_.fail(Code::not_in_dialect, "G54.1 takes P1 to P300");
    offset = 5400 + *additional;
  }
  if (offset == modes_.work_offset) return true;
  if (is_tcp()) return items_.fail(Code::not_in_dialect, "a new work offset while G43.4 is on");
  modes_.work_offset = offset;
  columns_.forget(columns_.all());
  return true;
}

bool Program::set_length() {
  std::optional<int> new_register;
  if (!take_integer('H', new_register)) return false;
  const int before = modes_.length;
  if (const auto length = asked(Group::length)) modes_.length = *length;
  if (cycle_.code != 800)
    return items_.fail(Code::not_in_dialect, "a length offset within a canned cycle");
  const bool any_axis_word = words_.any_left(columns_.letter_bits());
  if (before == 434 && modes_.length != 434 && any_axis_word && asked(Group::one_shot) != 530)
    return items_.fail(Code::not_in_dialect, "axis words where tool centre point control ends");
  const bool same_register = !new_register || new_register == modes_.length_register;
  if (new_register) modes_.length_register = new_register;
  if (modes_.length != 490 && modes_.length_register.value_or(0) == 0)
    return items_.fail(Code::not_in_dialect,
                       g_text(modes_.length) + " without a length register (H1 and up)");
  if (before == modes_.length && (same_register || modes_.length == 490)) return true;
  // The numbers change their meaning, and whether the tool moves depends on parameters.
  columns_.forget(before == 434 || modes_.length == 434 ? columns_.linear() : columns_.bit_of('Z'));
  return true;
}

bool Program::before_motion() {
  const bool new_speed = words_.take('S');
  if (new_speed) {
    const double speed = words_['S'];
    if (words_.is_pointed('S') || speed < 0.0)
      return items_.fail(Code::bad_number, "S" + number_text(speed) + " is not a speed");
    modes_.spindle.speed_rpm = speed;
  }
  std::optional<int> tool;
  if (!take_integer('T', tool)) return false;
  if (tool) modes_.tool = tool;
  bool spindle_said = false;
  for (std::size_t i = 0; i < words_->m_count; ++i) {
    const int code = words_->m[i];
    if (code == 6 && !change_tool()) return false;
    if (code == 3 || code == 4 || code == 13 || code == 14) {
      modes_.spindle.state = code == 3 || code == 13 ? ReadSpindle::State::clockwise
                                                     : ReadSpindle::State::counterclockwise;
      spindle_said = true;
    } else if (!is_harmless_function(code)) {
      return items_.fail(Code::not_in_dialect,
                         code_text('M', code, 0) + " is not understood; it may move the machine");
    }
  }
  if (!spindle_said && !(new_speed && modes_.spindle.state != ReadSpindle::State::off)) return true;
  return items_.send(modes_.spindle);
}

bool Program::change_tool() {
  if (!modes_.tool) return items_.fail(Code::not_in_dialect, "M6 before any T");
  if (is_tcp() || cycle_.code != 800)
    return items_.fail(Code::not_in_dialect, "M6 while G43.4 or a canned cycle is on");
  if (words_.any_left(columns_.letter_bits()))
    return items_.fail(Code::not_in_dialect, "M6 and axis words in one block");
  columns_.forget(columns_.linear());  // the change takes the tool to its own place
  return items_.send(ReadTool{*modes_.tool});
}

bool Program::after_motion() {
  for (std::size_t i = 0; i < words_->m_count; ++i) {
    const int code = words_->m[i];
    if (code == 5 || code == 19) {
      modes_.spindle.state = ReadSpindle::State::off;
      if (!items_.send(modes_.spindle)) return false;
    }
    if (code == 2 || code == 30) ended_ = true;
  }
  return !ended_ || items_.send(ReadEnd{});
}

bool Program::one_shot(int code) {
  if (cycle_.code != 800)
    return items_.fail(Code::not_in_dialect, g_text(code) + " within a canned cycle");
  switch (code) {
    case 280:
      return reference_return();
    case 530:
      return machine_move();
    case 40:
      // P counts milliseconds and X seconds: neither is a motion.
      if (words_.take('P') == words_.take('X'))
        return items_.fail(Code::not_in_dialect, "G4 takes one of P and X");
      return true;
    case 51:
      if (!words_.take('Q')) return items_.fail(Code::not_in_dialect, "G5.1 takes Q");
      words_.take('R');
      return true;
    default:  // G05, G08
      if (!words_.take('P')) return items_.fail(Code::not_in_dialect, g_text(code) + " takes P");
      if (code == 50 && words_['P'] != 0.0 && words_['P'] != 10000.0)
        return items_.fail(Code::not_in_dialect, "G5 takes P10000 or P0");
      return true;
  }
}

bool Program::take_integer(char letter, std::optional<int>& value) {
  if (!words_.take(letter)) return true;
  const double number = words_[letter];
  if (words_.is_pointed(letter) || number < 0.0 || number > 99'999'999.0)
    return items_.fail(Code::bad_number,
                       std::string{letter} + number_text(number) + " must be a plain integer");
  value = static_cast<int>(number);
  return true;
}

bool Program::length_of(char letter, double& length_mm) {
  if (!modes_.unit)
    return items_.fail(Code::not_in_dialect, std::string{letter} + " before G20 or G21");
  const bool inch = modes_.unit == 200;
  double length = words_[letter];
  if (!words_.is_pointed(letter)) length /= inch ? 10'000.0 : 1'000.0;
  if (inch) length *= mm_per_inch;
  constexpr double largest_mm = 999'999.999;  // nine digits of 0.001
  if (std::abs(length) > largest_mm)
    return items_.fail(Code::bad_number, std::string{letter} + number_text(length) +
                                             " mm is out of the control's range");
  length_mm = length;
  return true;
}

bool Program::angle_of(char letter, double& angle_deg) {
  angle_deg = words_[letter];
  if (!words_.is_pointed(letter)) angle_deg /= 1'000.0;
  constexpr double largest_deg = 999'999.999;
  if (std::abs(angle_deg) <= largest_deg) return true;
  return items_.fail(Code::bad_number, std::string{letter} + number_text(angle_deg) +
                                           " deg is out of the control's range");
}

}  // namespace pentapost::nc::readers::fanuc
