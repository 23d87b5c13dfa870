#include "pentapost/core/number_text.hpp"
#include "pentapost/core/units.hpp"
#include "pentapost/nc/readers/klartext_program.hpp"

#include <cmath>

// User's manuals cycle programming: coordinate transformations, special functions.
namespace pentapost::nc::readers::klartext {
namespace {

constexpr int preset_cycle = 247;

}  // namespace

/// "CYCL DEF 9.1 DWELL 1.5" or "CYCL DEF 200 DRILLING ~ Q200=...".
bool Program::cycle_definition() {
  Scanner scanner{block_->rest};
  Decimal number;
  Decimal part;
  constexpr std::uint64_t largest_number = 999;
  // "9.1" would be a number with a point.
  if (scanner.word() != "DEF") return not_understood("CYCL is understood with DEF and CALL only");
  if (!scanner.integer(number) || number.mantissa > largest_number)
    return not_understood("CYCL DEF without the number of a cycle");
  const int cycle = static_cast<int>(number.mantissa);
  if (!scanner.take(".")) return long_definition(cycle, scanner);
  if (!scanner.integer(part) || part.mantissa > largest_number)
    return not_understood("CYCL DEF without the number of a cycle");
  return short_definition(cycle, static_cast<int>(part.mantissa), scanner);
}

bool Program::short_definition(int number, int part, Scanner& scanner) {
  const bool has_values = part > 0;
  switch (number) {
    case 7:
      return !has_values || shift_datum(scanner);
    case 8:
      if (!has_values || scanner.at_end()) return true;
      return not_understood("mirror images are not understood");
    case 9:   // dwell
    case 13:  // angle of the spindle for M19
    case 32:  // tolerance
      return true;
    case 10:
      return !has_values || last_number_is(scanner, 0.0, "rotations are not understood");
    case 11:
      return !has_values || last_number_is(scanner, 1.0, "scaling is not understood");
    case 19:
      return !has_values || tilt_is_zero(scanner);
    default:
      return not_understood("a cycle that is not understood; it may move the machine");
  }
}

/// CYCL DEF 7.1 X+10: the datum lies there, with I so far from where it lay. No axis moves; an axis
/// that is not stated keeps its shift.
bool Program::shift_datum(Scanner& scanner) {
  while (!scanner.at_end()) {
    const bool is_relative = scanner.take("I");
    const char letter = scanner.ahead();
    const std::size_t column = columns_.column_of(letter);
    Decimal number;
    if (column == columns_.size() || !scanner.take(std::string_view{&letter, 1}) ||
        !scanner.number(number))
      return not_understood("a datum shift that is not understood");
    double shift = number.value();
    if (columns_.is_linear(column) && is_inch_) shift *= mm_per_inch;
    if (!in_range(shift, std::string_view{&letter, 1})) return false;
    if (is_relative) shift += modes_.datum_shift[column];
    columns_.position[column] += modes_.datum_shift[column] - shift;
    modes_.datum_shift[column] = shift;
  }
  modes_.pole.reset();
  modes_.before_tcp_ended.reset();
  return true;
}

/// "CYCL DEF 10.1 ROT+0": the value that switches the transformation off.
bool Program::last_number_is(Scanner& scanner, double wanted, std::string_view what) {
  while (scanner.ahead() >= 'A' && scanner.ahead() <= 'Z') scanner.take_letter();
  Decimal number;
  if (scanner.at_end() || (scanner.number(number) && number.value() == wanted && scanner.at_end()))
    return true;
  return not_understood(what);
}

/// "CYCL DEF 19.1 A+0 B+0 C+0" and "CYCL DEF 19.1" switch the tilt off.
bool Program::tilt_is_zero(Scanner& scanner) {
  while (!scanner.at_end()) {
    Decimal number;
    const bool is_angle = scanner.take("A") || scanner.take("B") || scanner.take("C");
    if (!is_angle || !scanner.number(number) || number.mantissa != 0)
      return not_understood("tilted working planes are not understood");
  }
  return true;
}

bool Program::long_definition(int number, Scanner& scanner) {
  if (!is_drilling_cycle(number) && number != preset_cycle)
    return not_understood("a cycle that is not understood; it may move the machine");
  if (is_inch_) return not_understood("a cycle in a program in INCH");
  while (!scanner.at_end() && !scanner.is_parameter_next()) scanner.word();
  CycleParameters parameters;
  if (!parameters.read(scanner, items_)) return false;
  if (number != preset_cycle) {
    modes_.cycle = drilling_cycle(number, parameters, items_);
    return modes_.cycle.has_value();
  }
  constexpr double largest_preset = 9999.0;
  const double preset = parameters.value(339).value_or(-1.0);
  if (preset < 0.0 || preset > largest_preset || preset != std::floor(preset))
    return not_understood("a preset is a whole number Q339");
  modes_.preset = static_cast<int>(preset);
  columns_.forget(columns_.all());
  modes_.pole.reset();
  modes_.before_tcp_ended.reset();
  return true;
}

}  // namespace pentapost::nc::readers::klartext
