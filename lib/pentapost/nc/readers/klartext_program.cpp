#include "pentapost/nc/readers/klartext_program.hpp"

#include "pentapost/core/number_text.hpp"
#include "pentapost/nc/readers/heidenhain_functions.hpp"

// User's manuals conversational programming, miscellaneous functions: which of them act at the
// start and which at the end of their block.
namespace pentapost::nc::readers::klartext {

bool Program::execute(const Block& block) {
  block_ = &block;
  if (closed_) return items_.fail(Code::not_in_dialect, "a block behind END PGM");
  words_.open(block.words);
  if (block.kind == Block::Kind::statement) return statement();
  if (ended_) return items_.fail(Code::not_in_dialect, "a block behind the end of the program");
  return words();
}

bool Program::words() {
  using Kind = Block::Kind;
  machine_datum_ = 0;
  calls_cycle_ = block_->calls_cycle;
  const Kind kind = block_->kind;
  const bool turns =
      kind == Kind::circle || kind == Kind::circle_by_radius || kind == Kind::polar_circle;
  const bool is_polar = kind == Kind::polar_line || kind == Kind::polar_circle;
  if (block_->turning != Block::Turning::unsaid && !turns)
    return items_.fail(Code::not_in_dialect, "DR in a block that is no arc");
  if ((block_->polar_radius || block_->polar_angle_deg) && !is_polar)
    return items_.fail(Code::not_in_dialect, "polar coordinates in a block of L, C or CR");
  if (words_->m_count != 0 && !at_block_start()) return false;
  if (!set_feed()) return false;
  const bool moved = kind == Kind::centre     ? set_pole()
                     : block_->retracts_fully ? retract()
                                              : move();
  return moved && (words_->m_count == 0 || at_block_end()) && words_.nothing_left(items_);
}

bool Program::at_block_start() {
  for (std::size_t i = 0; i < words_->m_count; ++i)
    if (!start_function(words_->m[i])) return false;
  return true;
}

bool Program::start_function(int code) {
  switch (code) {
    case 3:
    case 4:
    case 13:
    case 14:
      modes_.spindle.state = code == 3 || code == 13 ? ReadSpindle::State::clockwise
                                                     : ReadSpindle::State::counterclockwise;
      modes_.spindle_was_coupled = false;
      return items_.send(modes_.spindle);
    case 91:
    case 92:
      if (machine_datum_ != 0) return items_.fail(Code::not_in_dialect, "M91 and M92 in one block");
      machine_datum_ = code;
      return true;
    case 94:
      forget_turns();
      return true;
    case 99:
      calls_cycle_ = true;
      return true;
    case 116:
      modes_.rotary_feed_in_mm = true;
      if (!modes_.tcp) return true;
      return items_.fail(Code::not_in_dialect, "M116 and M128 exclude each other");
    case 117:
      modes_.rotary_feed_in_mm = false;
      return true;
    case 126:
    case 127:
      modes_.shortest_way = code == 126;
      return true;
    case 128:
      return tcp_on();
    case 136:
    case 137:
      // The number of a feed before it would mean something else.
      if (modes_.feed_per_revolution != (code == 136)) modes_.feed.reset();
      modes_.feed_per_revolution = code == 136;
      return true;
    case 103:  // lower feed downwards; F stays the largest
    case 109:  // feed at the cutting edge, with radius compensation
    case 110:
    case 120:  // blocks read ahead, with radius compensation
    case 129:
    case 140:
      return true;
    default:
      if (is_harmless_heidenhain_function(code)) return true;
      return items_.fail(Code::not_in_dialect, "M" + std::to_string(code) +
                                                   " is not understood; it may move the machine");
  }
}

bool Program::tcp_on() {
  if (modes_.rotary_feed_in_mm)
    return items_.fail(Code::not_in_dialect, "M116 and M128 exclude each other");
  if (modes_.tcp) return true;
  columns_.forget(columns_.linear());
  if (modes_.before_tcp_ended) columns_ = *modes_.before_tcp_ended;
  modes_.tcp = true;
  return true;
}

void Program::tcp_off() {
  if (!modes_.tcp) return;
  modes_.before_tcp_ended = columns_;
  columns_.forget(columns_.linear());
  modes_.tcp = false;
}

bool Program::stop_spindle() {
  modes_.spindle_was_coupled = false;
  if (modes_.spindle.state == ReadSpindle::State::off) return true;
  modes_.spindle.state = ReadSpindle::State::off;
  return items_.send(modes_.spindle);
}

bool Program::at_block_end() {
  for (std::size_t i = 0; i < words_->m_count; ++i)
    if (!end_function(words_->m[i])) return false;
  return !ended_ || items_.send(ReadEnd{});
}

bool Program::end_function(int code) {
  switch (code) {
    case 0:  // the spindle stops with the program
      return stop_spindle();
    case 2:
    case 30:
      ended_ = true;
      return true;
    case 5:
    case 19:
      modes_.spindle.state = ReadSpindle::State::off;
      modes_.spindle_was_coupled = false;
      return items_.send(modes_.spindle);
    case 6:
      if (modes_.tcp) return items_.fail(Code::not_in_dialect, "M6 while M128 is on");
      modes_.before_tcp_ended.reset();
      columns_.forget(columns_.linear());
      return stop_spindle();
    case 129:
      tcp_off();
      return true;
    default:
      return true;
  }
}

/// M94 counts rotary axes below 360 deg from here on: none of them moves.
void Program::forget_turns() {
  modes_.before_tcp_ended.reset();
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    const bool named = block_->counted_below_a_turn == 0 ||
                       (block_->counted_below_a_turn & letter_bit(columns_.letter(column))) != 0;
    if (!columns_.is_linear(column) && named)
      columns_.forget(static_cast<std::uint8_t>(1U << column));
  }
}

/// FMAX holds for its block; the feed before it comes back behind it.
bool Program::set_feed() {
  if (block_->feed == Block::Feed::of_tool) {
    if (!modes_.tool_feed) return items_.fail(Code::no_feed, "FAUTO, but TOOL CALL has no feed");
    modes_.feed = modes_.tool_feed;
  }
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
  if (words_.any_left(columns_.letter_bits()) || calls_cycle_)
    return items_.fail(Code::not_in_dialect, "M140 and axis words or a cycle in one block");
  modes_.before_tcp_ended.reset();
  columns_.forget(columns_.linear());  // along the tool axis, wherever that points
  return items_.send(ReadSafeRetract{});
}

}  // namespace pentapost::nc::readers::klartext
