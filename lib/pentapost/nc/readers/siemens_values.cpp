#include "pentapost/nc/readers/siemens_text.hpp"

#include <string>

namespace pentapost::nc::readers::siemens {
namespace {

constexpr std::string_view with_value = "ABCDEFHIJKMSTUVWXYZ";
constexpr std::string_view with_dimension = "ABCIJKUVWXYZ";

bool is_one_of(char letter, std::string_view letters) {
  return letters.find(letter) != std::string_view::npos;
}

}  // namespace

/// "S1=3000", "M1=3": of spindle 1, which is the master spindle of a mill.
bool Text::indexed_address(Block& block, char letter, const Decimal& index) {
  if ((letter == 'S' || letter == 'M') && index.mantissa == 1) return value(block, letter);
  if (is_one_of(letter, "ABC") && index.mantissa >= 2 && index.mantissa <= 7)
    return fail("directions of the tool axis as vectors or angles are not read", word_begin_);
  return fail("an address with an index is not read", word_begin_);
}

/// What stands behind =, which is the next character.
bool Text::value(Block& block, char letter) {
  ++at_;
  skip_blanks();
  if (!is_one_of(letter, with_value)) return fail("a word that has no value by =", word_begin_);
  if (letter == 'T' && at_ != end_ && *at_ == '"') return tool_name(block);
  const std::string_view name = read_name();
  if (!name.empty()) return dimension(block, letter, name);
  if (at_ != end_ && *at_ == '$') return nothing_to_evaluate();
  Decimal number;
  return number_of(number) && nothing_to_evaluate() && store(block, letter, number);
}

/// Fundamentals, absolute and incremental dimensions: AC, IC; of rotary axes DC, ACP, ACN.
bool Text::dimension(Block& block, char letter, std::string_view name) {
  std::uint32_t* const letters = name == "AC"    ? &block.absolute
                                 : name == "IC"  ? &block.incremental
                                 : name == "DC"  ? &block.shortest
                                 : name == "ACP" ? &block.upward
                                 : name == "ACN" ? &block.downward
                                                 : nullptr;
  if (letters == nullptr || !is_one_of(letter, with_dimension))
    return fail("variables and expressions are not evaluated", word_begin_);
  const bool of_rotary_axes = name == "DC" || name == "ACP" || name == "ACN";
  if (of_rotary_axes && !is_one_of(letter, "ABC"))
    return fail("DC, ACP and ACN belong to rotary axes", word_begin_);
  skip_blanks();
  if (at_ == end_ || *at_ != '(') return fail("a dimension without brackets", word_begin_);
  ++at_;
  skip_blanks();
  Decimal number;
  if (!number_of(number)) return false;
  skip_blanks();
  if (at_ == end_ || *at_ != ')')
    return fail("variables and expressions are not evaluated", word_begin_);
  ++at_;
  *letters |= letter_bit(letter);
  return store(block, letter, number);
}

/// T="5": the name of the tool is its number.
bool Text::tool_name(Block& block) {
  ++at_;
  Decimal number;
  if (!read_decimal(at_, end_, number) || !number.is_plain_integer() || at_ == end_ || *at_ != '"')
    return fail("a tool that is called by a name instead of a number is not read", word_begin_);
  ++at_;
  return store(block, 'T', number);
}

bool Text::number_of(Decimal& number) {
  if (read_decimal(at_, end_, number)) return true;
  if (number.digits > Decimal::most_digits)
    return fail("a number of more than 15 digits", word_begin_, Code::bad_number);
  if (at_ != end_ && (*at_ == '(' || *at_ == '$' || *at_ == '='))
    return fail("variables and expressions are not evaluated", word_begin_);
  return fail("a word without a number", word_begin_, Code::bad_number);
}

/// False where an expression goes on.
bool Text::nothing_to_evaluate() {
  skip_blanks();
  if (at_ == end_ || !is_one_of(*at_, "+-*/([$<>=")) return true;
  return fail("variables and expressions are not evaluated", word_begin_);
}

}  // namespace pentapost::nc::readers::siemens
