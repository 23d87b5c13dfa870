#include "pentapost/nc/readers/klartext_text.hpp"

#include <algorithm>

namespace pentapost::nc::readers::klartext {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }
bool is_letter(char c) { return c >= 'A' && c <= 'Z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Where the line that begins at `at` ends.
const char* line_end(const char* at, const char* end) { return std::find(at, end, '\n'); }

/// Whether the text up to `end` of a line joins the next line to it.
bool is_continued(const char* begin, const char* end) {
  while (end != begin && (is_blank(end[-1]) || end[-1] == '\r')) --end;
  return end != begin && end[-1] == '~';
}

}  // namespace

Text::Text(std::string_view text, ItemStream& items)
    : at_{text.data()}, line_begin_{at_}, end_{text.data() + text.size()}, items_{items} {}

bool Text::read_program_line() {
  Block block;
  const Found found = next(block);
  if (found == Found::problem) return false;
  const bool is_head =
      found == Found::block && block.kind == Block::Kind::statement && block.keyword == "BEGIN";
  std::string_view rest = is_head ? block.rest : std::string_view{};
  const auto trim = [&rest] {
    while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
    while (!rest.empty() && (is_blank(rest.back()) || rest.back() == '\r')) rest.remove_suffix(1);
  };
  rest = rest.substr(0, rest.find_first_of(";\n"));
  trim();
  if (!rest.starts_with("PGM ")) {
    at_ = line_begin_ = end_;
    return fail("a program begins with BEGIN PGM, its name and MM or INCH", end_);
  }
  rest.remove_prefix(3);
  trim();
  is_inch_ = rest.ends_with(" INCH");
  if (is_inch_ || rest.ends_with(" MM")) return true;
  return items_.fail(Code::not_in_dialect, "BEGIN PGM needs a name and MM or INCH behind it");
}

Text::Found Text::next(Block& block) {
  while (at_ != end_) {
    switch (line(block)) {
      case Step::block_found:
        return Found::block;
      case Step::problem:
        return Found::problem;
      case Step::go_on:
        break;
    }
  }
  return Found::end_of_text;
}

Text::Step Text::line(Block& block) {
  items_.set_line(line_);
  skip_blanks();
  if (at_ != end_ && is_digit(*at_) && !block_number()) return Step::problem;
  if (at_line_end() || *at_ == ';' || *at_ == '*') {  // "* - text" heads a section
    skip_line();
    return Step::go_on;
  }
  if (is_letter(*at_)) return keyword(block);
  fail(*at_ == '/' ? "a block skip depends on a switch of the machine"
                   : "a character that no block begins with",
       at_);
  return Step::problem;
}

bool Text::block_number() {
  const char* const begin = at_;
  while (at_ != end_ && is_digit(*at_)) ++at_;
  if (!at_line_end() && !is_blank(*at_) && *at_ != ';')
    return fail("a block number is an integer with a blank behind it", begin);
  skip_blanks();
  return true;
}

std::string_view Text::letters() {
  const char* const begin = at_;
  while (at_ != end_ && is_letter(*at_)) ++at_;
  return {begin, static_cast<std::size_t>(at_ - begin)};
}

Text::Step Text::keyword(Block& block) {
  using Kind = Block::Kind;
  const char* const begin = at_;
  const std::string_view name = letters();
  if (name == "L") return words(block, Kind::line);
  const bool is_number_next = at_ != end_ && (is_digit(*at_) || *at_ == '+' || *at_ == '-');
  if (name == "C" && !is_number_next) return words(block, Kind::circle);
  if (name == "CC") return words(block, Kind::centre);
  if (name == "CR") return words(block, Kind::circle_by_radius);
  if (name == "CP") return words(block, Kind::polar_circle);
  if (name == "LP") return words(block, Kind::polar_line);
  if (name == "STOP") return words(block, Kind::line);
  if (name == "CYCL" && takes_call()) {
    const Step step = words(block, Kind::line);
    block.calls_cycle = true;
    return step;
  }
  constexpr std::string_view axes = "XYZABCUVW";
  const bool is_word = (name.size() == 1 && (name == "M" || axes.find(name[0]) != axes.npos)) ||
                       (name.size() == 2 && name[0] == 'I' && axes.find(name[1]) != axes.npos);
  if (is_word) {
    at_ = begin;
    return words(block, Kind::line);
  }
  block.kind = Kind::statement;
  block.words.clear(line_);
  block.keyword = name;
  return statement(block) ? Step::block_found : Step::problem;
}

bool Text::takes_call() {
  skip_blanks();
  return take("CALL");
}

/// ~ at the end of a line joins the next one to it.
bool Text::statement(Block& block) {
  const char* const begin = at_;
  for (;;) {
    const char* const end = line_end(at_, end_);
    const bool goes_on = is_continued(at_, end);
    at_ = end;
    if (!goes_on) break;
    if (at_ == end_) return fail("the last block goes on behind ~: the text is cut off", begin);
    ++at_;
    ++line_;
  }
  block.rest = {begin, static_cast<std::size_t>(at_ - begin)};
  skip_line();
  return true;
}

Text::Step Text::words(Block& block, Block::Kind kind) {
  block.kind = kind;
  block.words.clear(line_);
  block.feed = Block::Feed::unsaid;
  block.turning = Block::Turning::unsaid;
  block.polar_radius.reset();
  block.polar_angle_deg.reset();
  block.retracts_fully = block.calls_cycle = false;
  block.counted_below_a_turn = 0;
  feed_is_of_function_ = false;
  for (;;) {
    skip_blanks();
    if (at_line_end() || *at_ == ';') break;
    if (!word(block)) return Step::problem;
  }
  skip_line();
  return Step::block_found;
}

bool Text::word(Block& block) {
  const char* const begin = at_;
  const std::string_view name = letters();
  if (name.size() == 1) {
    switch (name[0]) {
      case 'F':
        return feed_word(block, begin);
      case 'M':
        return function_word(block, begin);
      case 'R':
        return compensation_or_radius(block, begin);
      case 'A':
      case 'B':
      case 'C':
      case 'U':
      case 'V':
      case 'W':
      case 'X':
      case 'Y':
      case 'Z':
        return axis_word(block, name[0], false, begin);
      default:
        break;
    }
  }
  return long_word(block, name, begin);
}

bool Text::long_word(Block& block, std::string_view name, const char* begin) {
  constexpr std::string_view axes = "XYZABCUVW";
  if (name.size() == 2 && name[0] == 'I' && axes.find(name[1]) != axes.npos)
    return axis_word(block, name[1], true, begin);
  if (name == "DR") return turning_word(block, begin);
  if (name == "PR" || name == "PA" || name == "IPA") return polar_word(block, name, begin);
  if (name == "FMAX" || name == "FAUTO") {
    at_ = begin + 1;
    return feed_word(block, begin);
  }
  if (name == "RL" || name == "RR") return fail("radius compensation is not understood", begin);
  if (name.find('Q') != std::string_view::npos)
    return fail("Q parameters are not evaluated", begin);
  return fail("a word that is not understood", begin);
}

bool Text::polar_word(Block& block, std::string_view name, const char* begin) {
  Decimal number;
  if (!number_of(number, begin)) return false;
  std::optional<double>& place = name == "PR" ? block.polar_radius : block.polar_angle_deg;
  if (place) return fail("an address stands twice in a block", begin);
  place = number.value();
  if (name != "PR") block.polar_angle_is_relative = name == "IPA";
  return true;
}

/// F 500, FMAX, F MAX, FAUTO.
bool Text::feed_word(Block& block, const char* begin) {
  skip_blanks();
  Block::Feed feed = Block::Feed::number;
  Decimal number;
  if (take("MAX"))
    feed = Block::Feed::rapid;
  else if (take("AUTO"))
    feed = Block::Feed::of_tool;
  else if (!number_of(number, begin))
    return false;
  if (feed_is_of_function_) {
    feed_is_of_function_ = false;
    return true;
  }
  if (block.feed != Block::Feed::unsaid) return fail("an address stands twice in a block", begin);
  block.feed = feed;
  return feed != Block::Feed::number || block.words.add('F', number);
}

/// R0: the tool's centre runs on the path. In CR every other number is the radius.
bool Text::compensation_or_radius(Block& block, const char* begin) {
  if (at_ != end_ && (*at_ == '+' || *at_ == '-') &&
      (at_ + 1 == end_ || (!is_digit(at_[1]) && at_[1] != '.' && at_[1] != 'Q')))
    return fail("radius compensation is not understood", begin);
  Decimal number;
  if (!number_of(number, begin)) return false;
  if (number.is_plain_integer() && number.mantissa == 0) return true;
  if (block.kind != Block::Kind::circle_by_radius)
    return fail("a radius is understood in CR only", begin);
  return block.words.add('R', number) || fail("an address stands twice in a block", begin);
}

bool Text::turning_word(Block& block, const char* begin) {
  if (block.turning != Block::Turning::unsaid)
    return fail("an address stands twice in a block", begin);
  skip_blanks();
  if (take("+"))
    block.turning = Block::Turning::counterclockwise;
  else if (take("-"))
    block.turning = Block::Turning::clockwise;
  else
    return fail("DR is DR+ or DR-", begin);
  return true;
}

bool Text::function_word(Block& block, const char* begin) {
  Decimal number;
  if (!number_of(number, begin)) return false;
  Words& words = block.words;
  constexpr std::uint64_t largest = 999;
  if (!number.is_plain_integer() || number.mantissa > largest || words.m_count == Words::most_codes)
    return fail("not a code of this control", begin);
  const auto code = static_cast<std::uint16_t>(number.mantissa);
  words.m[words.m_count++] = code;
  feed_is_of_function_ = code == 103 || code == 128;
  if (code == 94) letters_of_m94(block);
  if (code == 140) return retract_words(block, begin);
  if (code != 120) return true;
  skip_blanks();
  return !take("LA") || number_of(number, begin);
}

/// M94 C: of this axis; M94 alone: of all rotary axes.
void Text::letters_of_m94(Block& block) {
  for (skip_blanks(); at_ != end_ && *at_ >= 'A' && *at_ <= 'C'; skip_blanks()) {
    if (at_ + 1 != end_ && !is_blank(at_[1]) && at_[1] != '\r' && at_[1] != '\n') return;
    block.counted_below_a_turn |= letter_bit(*at_++);
  }
}

/// M140 MB MAX, with or without F for the retract.
bool Text::retract_words(Block& block, const char* begin) {
  skip_blanks();
  if (!take("MB")) return fail("M140 is understood with MB MAX only", begin);
  skip_blanks();
  if (!take("MAX")) return fail("M140 is understood with MB MAX only", begin);
  block.retracts_fully = true;
  feed_is_of_function_ = true;
  return true;
}

bool Text::axis_word(Block& block, char letter, bool is_relative, const char* begin) {
  Decimal number;
  if (!number_of(number, begin)) return false;
  if (!block.words.add(letter, number)) return fail("an address stands twice in a block", begin);
  if (is_relative) block.words.relative |= letter_bit(letter);
  return true;
}

bool Text::number_of(Decimal& number, const char* begin) {
  skip_blanks();
  if (read_decimal(at_, end_, number)) return true;
  if (number.digits == 0 && at_ != end_ && *at_ == 'Q')
    return fail("Q parameters are not evaluated", begin);
  return fail("no number, or one of more than 15 digits", begin, Code::bad_number);
}

bool Text::take(std::string_view what) {
  if (static_cast<std::size_t>(end_ - at_) < what.size() ||
      std::string_view{at_, what.size()} != what)
    return false;
  at_ += what.size();
  return true;
}

void Text::skip_blanks() {
  while (at_ != end_ && is_blank(*at_)) ++at_;
}

void Text::skip_line() {
  at_ = line_end(at_, end_);
  if (at_ != end_) ++at_;
  ++line_;
  line_begin_ = at_;
}

bool Text::fail(std::string_view what, const char* at, Code code) {
  return items_.fail_at(code, what, line_begin_, at, end_);
}

}  // namespace pentapost::nc::readers::klartext
