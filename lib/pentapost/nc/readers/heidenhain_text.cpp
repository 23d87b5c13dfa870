#include "pentapost/nc/readers/heidenhain_text.hpp"

#include <string>

namespace pentapost::nc::readers::heidenhain {
namespace {

constexpr std::uint16_t tolerance_cycle = 62;  ///< G62: its T and P are no tool and no axis words

bool is_blank(char c) { return c == ' ' || c == '\t'; }

}  // namespace

Text::Text(std::string_view text, ItemStream& items)
    : at_{text.data()}, line_begin_{at_}, end_{text.data() + text.size()}, items_{items} {}

bool Text::read_program_line() {
  while (at_ != end_ && (is_blank(*at_) || *at_ == '\r' || *at_ == '\n')) {
    if (*at_++ != '\n') continue;
    ++line_;
    line_begin_ = at_;
  }
  items_.set_line(line_);
  const char* const begin = at_;
  if (at_ == end_ || *at_ != '%')
    return fail("a program begins with %, its name and G70 or G71", begin);
  while (!at_line_end() && !is_blank(*at_)) ++at_;
  name_ = {begin + 1, static_cast<std::size_t>(at_ - begin - 1)};
  if (name_.empty()) return fail("the program has no name", begin);
  return unit_of_line();
}

bool Text::unit_of_line() {
  const char* const begin = at_;
  skip_blanks();
  Decimal number;
  if (at_ == end_ || *at_ != 'G' || !read_decimal(++at_, end_, number) ||
      !number.is_plain_integer() || (number.mantissa != 70 && number.mantissa != 71))
    return fail("the program line needs G70 or G71 behind the name", begin);
  is_inch_ = number.mantissa == 70;
  skip_blanks();
  if (at_ == end_ || *at_ != '*') return fail("the program line is not closed by *", begin);
  ++at_;
  return to_line_end() != Step::problem;
}

Text::Found Text::next(Block& block) {
  start_block(block);
  while (at_ != end_) {
    const Step step = one(block);
    if (step == Step::problem) return Found::problem;
    if (step == Step::go_on) continue;
    block.distance = distance_;
    if (!block.words.is_empty()) return Found::block;
    start_block(block);
  }
  if (!has_words_) return Found::end_of_text;
  fail("the last block is not closed by *: the text is cut off", end_);
  return Found::problem;
}

void Text::start_block(Block& block) {
  block.words.clear(line_);
  block.retracts_fully = false;
  items_.set_line(line_);
  line_started_ = has_words_ = after_m128_ = false;
}

Text::Step Text::one(Block& block) {
  const char c = *at_;
  if (c >= 'A' && c <= 'Z') return word(block);
  switch (c) {
    case ' ':
    case '\t':
      ++at_;
      return Step::go_on;
    case '*':
      ++at_;
      return block_end();
    case ';':
      while (!at_line_end()) ++at_;
      return block_end();
    case '\r':
      if (at_ + 1 != end_ && at_[1] == '\n') {
        ++at_;
        return Step::go_on;
      }
      break;
    case '\n':
      if (has_words_) break;
      return block_end();
    case '%':
      return program_mark();
    case '/':
      fail("a block skip depends on a switch of the machine", at_);
      return Step::problem;
    default:
      break;
  }
  fail(c == '\n' ? "a block is not closed by *" : "a character that no word begins with", at_);
  return Step::problem;
}

/// Behind the * of a block only a remark may follow; then the line ends.
Text::Step Text::block_end() {
  const Step step = to_line_end();
  return step == Step::problem ? step : Step::block_ends;
}

Text::Step Text::to_line_end() {
  skip_blanks();
  if (at_ != end_ && *at_ == ';')
    while (!at_line_end()) ++at_;
  if (at_ != end_ && *at_ == '\r') ++at_;
  if (!at_line_end()) {
    fail("words behind the end of a block", at_);
    return Step::problem;
  }
  if (at_ != end_) {
    ++at_;
    ++line_;
    line_begin_ = at_;
  }
  return Step::block_ends;
}

/// "% DATUM INPUT" is a remark; "%NAME" alone calls a program; "N99999999 %NAME G71 *" closes this
/// one.
Text::Step Text::program_mark() {
  const char* const begin = at_++;
  if (!line_started_ && (at_line_end() || is_blank(*at_))) {
    while (!at_line_end()) ++at_;
    return block_end();
  }
  while (!at_line_end() && !is_blank(*at_) && *at_ != '*') ++at_;
  const std::string_view name{begin + 1, static_cast<std::size_t>(at_ - begin - 1)};
  const bool was_inch = is_inch_;
  if (has_words_ || closed_ || name != name_ || !unit_of_line()) {
    fail("program calls are not understood", begin);
    return Step::problem;
  }
  if (is_inch_ != was_inch) {
    fail("the closing line states another unit than the program line", begin);
    return Step::problem;
  }
  closed_ = ended_ = true;
  return Step::block_ends;
}

Text::Step Text::word(Block& block) {
  const char* const begin = at_;
  if (ended_ && *at_ != 'N') {
    fail("words after the end of the program", begin);
    return Step::problem;
  }
  const char letter = *at_++;
  Decimal number;
  if (!number_of(number, begin)) return Step::problem;
  if (letter == 'N') {
    if (line_started_ || !number.is_plain_integer() || closed_) {
      fail("a block number is an integer at the start of its block", begin);
      return Step::problem;
    }
    line_started_ = true;
    return Step::go_on;
  }
  line_started_ = has_words_ = true;
  return store(block, letter, number, begin) ? Step::go_on : Step::problem;
}

bool Text::number_of(Decimal& number, const char* begin) {
  while (at_ != end_ && *at_ == ' ') ++at_;
  if (read_decimal(at_, end_, number)) return true;
  if (number.digits == 0 && at_ != end_ && *at_ == 'Q')
    return fail("Q parameters are not understood", begin);
  return fail("no number, or one of more than 15 digits", begin, Code::bad_number);
}

bool Text::store(Block& block, char letter, const Decimal& number, const char* begin) {
  if (letter == 'G' || letter == 'M') return store_code(block, letter, number, begin);
  if (letter == 'F' && after_m128_) {
    after_m128_ = false;
    return true;
  }
  Words& words = block.words;
  if (!words.add(letter, number)) return fail("an address stands twice in a block", begin);
  if (distance_ == 91) words.relative |= letter_bit(letter);
  return true;
}

bool Text::store_code(Block& block, char letter, const Decimal& number, const char* begin) {
  Words& words = block.words;
  auto& count = letter == 'G' ? words.g_count : words.m_count;
  if (!number.is_plain_integer() || number.mantissa > 999 || count == Words::most_codes)
    return fail("not a code of this control", begin);
  const auto code = static_cast<std::uint16_t>(number.mantissa);
  (letter == 'G' ? words.g : words.m)[count++] = code;
  if (letter == 'G') {
    if (code == 90 || code == 91) distance_ = code;
    return code != tolerance_cycle || tolerance_words();
  }
  after_m128_ = code == 128;
  return code != 140 || retract_words(block);
}

/// G62 T0.05 P01 1 P02 1.5: how far the control may round corners.
bool Text::tolerance_words() {
  const char* const begin = at_;
  Decimal number;
  for (skip_blanks(); at_ != end_ && (*at_ == 'T' || *at_ == 'P'); skip_blanks()) {
    const bool has_index = *at_++ == 'P';
    if (!number_of(number, begin)) return false;
    skip_blanks();
    if (has_index && !number_of(number, begin)) return false;
  }
  return true;
}

/// M140 MB MAX, with or without F for the retract.
bool Text::retract_words(Block& block) {
  const char* const begin = at_;
  skip_blanks();
  const auto read = [this](std::string_view what) {
    if (static_cast<std::size_t>(end_ - at_) < what.size() ||
        std::string_view{at_, what.size()} != what)
      return false;
    at_ += what.size();
    skip_blanks();
    return true;
  };
  if (!read("MB") || !read("MAX")) return fail("M140 is understood with MB MAX only", begin);
  block.retracts_fully = true;
  after_m128_ = true;
  return true;
}

void Text::skip_blanks() {
  while (at_ != end_ && is_blank(*at_)) ++at_;
}

bool Text::fail(std::string_view what, const char* at, Code code) {
  return items_.fail_at(code, what, line_begin_, at, end_);
}

}  // namespace pentapost::nc::readers::heidenhain
