#include "pentapost/nc/readers/siemens_text.hpp"

#include <string>

namespace pentapost::nc::readers::siemens {
namespace {

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return c >= 'A' && c <= 'Z'; }

}  // namespace

/// The name at the place in upper case, empty where there is none; "?" for one too long to be
/// known.
std::string_view Text::read_name() {
  std::size_t length = 0;
  for (; at_ != end_; ++at_, ++length) {
    const char c = upper(*at_);
    const bool is_part = is_letter(c) || c == '_' || (length > 0 && is_digit(c));
    if (!is_part) break;
    if (length < longest_name) name_[length] = c;
  }
  if (length > longest_name) return "?";
  return {name_.data(), length};
}

bool Text::name(Block& block) {
  const std::string_view name = read_name();
  const Meaning meaning = meaning_of(name);
  if (meaning == Meaning::unknown && label()) return true;
  line_started_ = started_ = true;
  return statement(block, meaning, name);
}

/// "NAME:" at the start of a block is where jumps lead, and does nothing itself.
bool Text::label() {
  if (line_started_ || at_ == end_ || *at_ != ':') return false;
  ++at_;
  line_started_ = true;
  return true;
}

bool Text::statement(Block& block, Meaning meaning, std::string_view name) {
  const auto flag = [&block](bool& what) { return what = block.has_statement = true; };
  switch (meaning) {
    case Meaning::harmless:
      return no_call();
    case Meaning::harmless_call:
      return skip_call();
    case Meaning::harmless_value:
      return skip_value();
    case Meaning::zero_value:
      return zero_behind();
    case Meaning::orientation_on:
      return orientation_on(block);
    case Meaning::orientation_off:
      return no_call() && flag(block.orientation_off);
    case Meaning::machine_frame:
      return flag(block.machine_frame);
    case Meaning::modal_call:
      return flag(block.modal_call);
    case Meaning::drilling_cycle:
      return cycle(block, name);
    case Meaning::high_speed_cycle:
      return high_speed_cycle();
    case Meaning::feed_group:
      return feed_group();
    case Meaning::shift:
      return flag(block.shift);
    case Meaning::bare_shift:
      return flag(block.bare_shift);
    case Meaning::radius:
      block.has_statement = true;
      return number_behind(block.radius);
    case Meaning::turns:
      block.has_statement = true;
      return number_behind(block.turns);
    case Meaning::spindle_stop:
      return skip_value() && flag(block.spindle_stop);
    case Meaning::program_end:
      return no_call() && flag(block.program_end);
    case Meaning::vector:
      return fail("directions of the tool axis as vectors or angles are not read", word_begin_);
    case Meaning::jump:
      return fail("jumps, loops and sub-programs are not evaluated", word_begin_);
    case Meaning::variable:
      return fail("variables are not evaluated", word_begin_);
    case Meaning::swivel:
      return fail("a swivelled plane, CYCLE800, is not read", word_begin_);
    case Meaning::unknown:
      break;
  }
  return fail(
      "a word that is not understood; it may be a variable or a sub-program that moves the "
      "machine",
      word_begin_);
}

/// TRAORI, TRAORI() and TRAORI(1): which transformation another number selects, the machine's
/// builder says.
bool Text::orientation_on(Block& block) {
  block.orientation_on = block.has_statement = true;
  skip_blanks();
  if (at_ == end_ || *at_ != '(') return true;
  ++at_;
  Decimal number;
  skip_blanks();
  if (at_ != end_ && *at_ != ')' && (!number_of(number) || number.value() != 1.0))
    return fail("TRAORI is understood without a number and with 1 only", word_begin_);
  skip_blanks();
  if (at_ == end_ || *at_ != ')')
    return fail("TRAORI is understood without a number and with 1 only", word_begin_);
  ++at_;
  return true;
}

bool Text::cycle(Block& block, std::string_view name) {
  CycleCall call;
  constexpr int first_cycle = 80;
  call.number = first_cycle + (name.back() - '0');
  block.has_statement = true;
  skip_blanks();
  if (at_ == end_ || *at_ != '(') return fail("a cycle without parameters", word_begin_);
  ++at_;
  for (std::size_t i = 0; i < CycleCall::most_parameters; ++i) {
    skip_blanks();
    if (at_ != end_ && *at_ != ',' && *at_ != ')') {
      Decimal number;
      if (!read_decimal(at_, end_, number))
        return fail("a parameter of the cycle is not a number; variables are not evaluated",
                    word_begin_);
      call.parameter[i] = number.value();
      skip_blanks();
    }
    if (at_ == end_ || (*at_ != ',' && *at_ != ')')) break;
    if (*at_++ == ',') continue;
    block.cycle = call;
    return true;
  }
  return fail("the parameters of the cycle are not understood", word_begin_);
}

/// Its old form CYCLE832(tolerance, mode of six digits) may switch TRAORI too.
bool Text::high_speed_cycle() {
  skip_blanks();
  if (at_ == end_ || *at_ != '(') return true;
  const char* look = at_ + 1;
  while (look != end_ && *look != ',' && *look != ')' && *look != '\n') ++look;
  std::ptrdiff_t digits = 0;
  if (look != end_ && *look == ',')
    for (++look; look != end_ && (is_digit(*look) || *look == ' '); ++look)
      digits += is_digit(*look) ? 1 : 0;
  constexpr std::ptrdiff_t most_digits_of_a_kind = 2;
  if (digits > most_digits_of_a_kind)
    return fail("CYCLE832 with a mode of several digits is not evaluated", word_begin_);
  return skip_call();
}

/// FGROUP(X,Y,Z): F is the speed of the tool. With rotary axes in it F is another feed.
bool Text::feed_group() {
  skip_blanks();
  if (at_ == end_ || *at_ != '(') return fail("FGROUP without brackets", word_begin_);
  for (++at_; at_ != end_ && *at_ != ')'; ++at_) {
    const char c = upper(*at_);
    if (c == 'X' || c == 'Y' || c == 'Z' || c == ',' || c == ' ') continue;
    return fail("FGROUP is understood for X, Y and Z only", word_begin_);
  }
  if (at_ == end_) return fail("FGROUP without brackets", word_begin_);
  ++at_;
  return true;
}

bool Text::number_behind(std::optional<double>& number) {
  skip_blanks();
  if (at_ == end_ || *at_ != '=') return fail("a word without its value", word_begin_);
  if (number) return fail("an address stands twice in a block", word_begin_);
  ++at_;
  skip_blanks();
  Decimal decimal;
  if (!number_of(decimal) || !nothing_to_evaluate()) return false;
  number = decimal.value();
  return true;
}

bool Text::zero_behind() {
  std::optional<double> number;
  if (!number_behind(number)) return false;
  return number == 0.0 || fail("it is understood with the value 0 only", word_begin_);
}

/// "ADIS=0.5", "FGREF[A]=10", "SPOS=0", "SPOS[1]=DC(90)".
bool Text::skip_value() {
  skip_blanks();
  if (at_ != end_ && *at_ == '[') {
    while (at_ != end_ && *at_ != ']' && *at_ != '\n') ++at_;
    if (at_ == end_ || *at_ != ']') return fail("a bracket is not closed", word_begin_);
    ++at_;
    skip_blanks();
  }
  if (at_ == end_ || *at_ != '=') return fail("a word without its value", word_begin_);
  ++at_;
  skip_blanks();
  if (!read_name().empty()) return skip_call();
  Decimal number;
  return number_of(number) && nothing_to_evaluate();
}

/// Brackets behind a name, with texts in them, if there are any.
bool Text::skip_call() {
  skip_blanks();
  if (at_ == end_ || *at_ != '(') return true;
  int depth = 0;
  bool in_text = false;
  for (; at_ != end_ && *at_ != '\n'; ++at_) {
    if (*at_ == '"') in_text = !in_text;
    if (in_text) continue;
    if (*at_ == '(') ++depth;
    if (*at_ == ')' && --depth == 0) {
      ++at_;
      return true;
    }
  }
  return fail("a bracket is not closed", word_begin_);
}

bool Text::no_call() {
  skip_blanks();
  if (at_ == end_ || (*at_ != '(' && *at_ != '=' && *at_ != '[')) return true;
  return fail("a word that is understood without a value only", word_begin_);
}

}  // namespace pentapost::nc::readers::siemens
