#include "pentapost/nc/readers/siemens_text.hpp"

#include <string>

namespace pentapost::nc::readers::siemens {
namespace {

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
bool is_letter(char c) { return c >= 'A' && c <= 'Z'; }
bool is_blank(char c) { return c == ' ' || c == '\t'; }

}  // namespace

void Block::clear(std::uint32_t text_line) {
  words.clear(text_line);
  absolute = incremental = shortest = upward = downward = 0;
  if (!has_statement) return;
  radius.reset();
  turns.reset();
  cycle.reset();
  orientation_on = orientation_off = machine_frame = modal_call = false;
  shift = bare_shift = spindle_stop = program_end = has_statement = false;
}

Text::Text(std::string_view text, ItemStream& items)
    : at_{text.data()},
      line_begin_{at_},
      word_begin_{at_},
      end_{text.data() + text.size()},
      items_{items} {}

Text::Found Text::next(Block& block) {
  block.clear(line_);
  items_.set_line(line_);
  while (at_ != end_) {
    const Step step = one(block);
    if (step == Step::problem) return Found::problem;
    if (step == Step::go_on) continue;
    line_started_ = numbered_ = false;
    if (!block.is_empty()) return Found::block;
    block.clear(line_);
    items_.set_line(line_);
  }
  // A program may end without a line feed; what is cut off has no end of the program.
  return block.is_empty() ? Found::end_of_text : Found::block;
}

Text::Step Text::one(Block& block) {
  const char c = *at_;
  if (is_letter(upper(c)) || c == '_') return word(block) ? Step::go_on : Step::problem;
  switch (c) {
    case ' ':
    case '\t':
      ++at_;
      return Step::go_on;
    case '\r':
      if (at_ + 1 != end_ && at_[1] != '\n') break;
      ++at_;
      return Step::go_on;
    case '\n':
      line_feed();
      return Step::line_ends;
    case ';':
      while (at_ != end_ && *at_ != '\n') ++at_;
      return Step::go_on;
    case '%':
      return program_mark() ? Step::go_on : Step::problem;
    case ':': {  // number of a main block
      word_begin_ = at_++;
      Decimal number;
      if (read_decimal(at_, end_, number) && block_number(number)) return Step::go_on;
      if (number.digits == 0) fail("a block number is an integer at the start of its block", at_);
      return Step::problem;
    }
    case '/':
      fail("a block skip depends on a switch of the machine", at_);
      return Step::problem;
    case '$':
      fail("system variables are not evaluated", at_);
      return Step::problem;
    default:
      fail("a character that no word begins with", at_);
      return Step::problem;
  }
  fail("a character that no word begins with", at_);
  return Step::problem;
}

bool Text::word(Block& block) {
  word_begin_ = at_;
  if (ended_) return fail("words after the end of the program", at_);
  const char letter = upper(*at_);
  const char next = at_ + 1 == end_ ? '\n' : upper(at_[1]);
  if (letter == '_' || is_letter(next) || next == '_') return name(block);
  ++at_;
  return address(block, letter);
}

bool Text::address(Block& block, char letter) {
  skip_blanks();
  if (letter == 'R') return fail("R parameters are not evaluated", word_begin_);
  if (letter == 'L') return fail("sub-programs are not evaluated", word_begin_);
  if (at_ != end_ && *at_ == '=') return value(block, letter);
  Decimal number;
  if (!number_of(number)) return false;
  if (at_ != end_ && (*at_ == '=' || is_blank(*at_)) && number.is_plain_integer()) {
    const char* const behind = at_;
    skip_blanks();
    if (at_ != end_ && *at_ == '=') return indexed_address(block, letter, number);
    at_ = behind;
  }
  if (letter == 'N') return block_number(number);
  return store(block, letter, number);
}

bool Text::store(Block& block, char letter, const Decimal& number) {
  line_started_ = started_ = true;
  if (letter == 'G' || letter == 'M') return store_code(block, letter, number);
  return block.words.add(letter, number) || fail("an address stands twice in a block", word_begin_);
}

bool Text::store_code(Block& block, char letter, const Decimal& number) {
  Words& words = block.words;
  auto& count = letter == 'G' ? words.g_count : words.m_count;
  if (!number.is_plain_integer() || number.mantissa > 999 || count == Words::most_codes)
    return fail("not a code of this control", word_begin_);
  (letter == 'G' ? words.g : words.m)[count++] = static_cast<std::uint16_t>(number.mantissa);
  return true;
}

bool Text::block_number(const Decimal& number) {
  if (line_started_ || numbered_ || !number.is_plain_integer())
    return fail("a block number is an integer at the start of its block", word_begin_);
  numbered_ = true;
  return true;
}

/// "%_N_NAME_MPF", what archives have before a program.
bool Text::program_mark() {
  if (started_ || line_started_ || numbered_) return fail("a second program begins here", at_);
  started_ = true;
  while (at_ != end_ && *at_ != '\n') ++at_;
  return true;
}

void Text::line_feed() {
  ++at_;
  ++line_;
  line_begin_ = at_;
}

void Text::skip_blanks() {
  while (at_ != end_ && is_blank(*at_)) ++at_;
}

bool Text::fail(std::string_view what, const char* at, Code code) {
  return items_.fail_at(code, what, line_begin_, at, end_);
}

}  // namespace pentapost::nc::readers::siemens
