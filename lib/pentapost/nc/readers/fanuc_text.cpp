#include "pentapost/nc/readers/fanuc_text.hpp"

#include "pentapost/nc/readers/decimal.hpp"

#include <string>

namespace pentapost::nc::readers {

FanucText::FanucText(std::string_view text, ItemStream& items)
    : at_{text.data()}, line_begin_{at_}, end_{text.data() + text.size()}, items_{items} {}

FanucText::Found FanucText::next(Words& words) {
  words.clear(line_);
  items_.set_line(line_);
  block_started_ = false;
  while (at_ != end_) {
    const Step step = one(words);
    if (step == Step::problem) return Found::problem;
    if (step == Step::go_on) continue;
    if (block_started_ && !words.is_empty()) return Found::block;
    words.clear(line_);
    items_.set_line(line_);
    block_started_ = false;
  }
  if (!words.is_empty()) {
    fail("the last block has no end: the text is cut off", end_);
    return Found::problem;
  }
  return Found::end_of_text;
}

FanucText::Step FanucText::one(Words& words) {
  const char c = *at_;
  if (c >= 'A' && c <= 'Z') return c == 'O' ? program_number() : word(words);
  switch (c) {
    case ' ':
    case '\t':
      ++at_;
      return Step::go_on;
    case '\r':
      if (at_ + 1 != end_ && at_[1] == '\n') {
        ++at_;
        return Step::go_on;
      }
      break;
    case '\n':
      line_feed();
      return Step::block_ends;
    case ';':  // how the control shows an end of block
      ++at_;
      return Step::block_ends;
    case '(':
      return comment();
    case '%':
      return tape_mark();
    case '/':
      fail("a block skip depends on a switch of the machine", at_);
      return Step::problem;
    case '#':
    case '[':
    case '=':
      fail("macro statements are not understood", at_);
      return Step::problem;
    default:
      break;
  }
  fail("a character that no word begins with", at_);
  return Step::problem;
}

FanucText::Step FanucText::word(Words& words) {
  const char* const begin = at_;
  if (ended_ || tape_ended_) {
    fail("words after the end of the program", begin);
    return Step::problem;
  }
  const char letter = *at_++;
  while (at_ != end_ && *at_ == ' ') ++at_;
  if (!store(words, letter, begin)) return Step::problem;
  block_started_ = started_ = true;
  return Step::go_on;
}

bool FanucText::store(Words& words, char letter, const char* begin) {
  Decimal number;
  if (!read_decimal(at_, end_, number)) {
    if (number.digits == 0 && at_ != end_ && (*at_ == '#' || *at_ == '['))
      return fail("macro variables are not understood", begin);
    return fail("no number, or one of more than 15 digits", begin, Code::bad_number);
  }
  if (letter == 'N') {
    if (block_started_ || !number.is_plain_integer())
      return fail("a sequence number is an integer at the start of its block", begin);
    return true;
  }
  if (letter == 'G' || letter == 'M') return store_code(words, letter, number, begin);
  return words.add(letter, number) || fail("an address stands twice in a block", begin);
}

bool FanucText::store_code(Words& words, char letter, const Decimal& number, const char* begin) {
  const bool is_g = letter == 'G';
  auto& count = is_g ? words.g_count : words.m_count;
  const bool has_tenths = is_g && number.decimals == 1;
  const std::uint64_t largest = has_tenths ? 9999 : 999;
  if (number.has_sign || number.has_point != has_tenths || number.mantissa > largest ||
      count == Words::most_codes)
    return fail("not a code of this control", begin);
  const auto code = static_cast<std::uint16_t>(number.mantissa * (is_g && !has_tenths ? 10 : 1));
  (is_g ? words.g : words.m)[count++] = code;
  return true;
}

FanucText::Step FanucText::comment() {
  const char* const begin = at_;
  while (at_ != end_ && *at_ != ')' && *at_ != '\n') ++at_;
  if (at_ == end_ || *at_ == '\n') {
    fail("a comment is not closed", begin);
    return Step::problem;
  }
  ++at_;
  return Step::go_on;
}

FanucText::Step FanucText::program_number() {
  const char* const begin = at_++;
  Decimal number;
  if (started_ || !read_decimal(at_, end_, number) || !number.is_plain_integer()) {
    fail("a program number is an integer at the start of the program", begin);
    return Step::problem;
  }
  started_ = true;
  return Step::go_on;
}

FanucText::Step FanucText::tape_mark() {
  if (block_started_ || tape_ended_ || (started_ && !ended_)) {
    fail(block_started_ || tape_ended_ ? "a tape mark is not expected here"
                                       : "the program has no M30 or M02 before the tape ends",
         at_);
    return Step::problem;
  }
  ++at_;
  if (!started_ && marked_) {
    fail("the program is empty", at_);
    return Step::problem;
  }
  (started_ ? tape_ended_ : marked_) = true;
  return Step::go_on;
}

void FanucText::line_feed() {
  ++at_;
  ++line_;
  line_begin_ = at_;
}

bool FanucText::fail(std::string_view what, const char* at, Code code) {
  return items_.fail_at(code, what, line_begin_, at, end_);
}

}  // namespace pentapost::nc::readers
