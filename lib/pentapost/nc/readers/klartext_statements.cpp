#include "pentapost/core/number_text.hpp"
#include "pentapost/nc/readers/klartext_program.hpp"

// User's manuals conversational programming: tools, program frame, FUNCTION TCPM, PLANE.
namespace pentapost::nc::readers::klartext {

bool Program::not_understood(std::string_view what) {
  const std::string_view keyword = block_->keyword;
  return items_.fail_at(Code::not_in_dialect, what, keyword.data(), keyword.data(),
                        block_->rest.data() + block_->rest.size());
}

bool Program::statement() {
  const std::string_view keyword = block_->keyword;
  if (keyword == "END") return end_program();
  if (ended_) return items_.fail(Code::not_in_dialect, "a block behind the end of the program");
  if (keyword == "TOOL") return tool();
  if (keyword == "CYCL") return cycle_definition();
  if (keyword == "FUNCTION") return function();
  if (keyword == "PLANE") return plane();
  if (keyword == "BLK") return true;
  if (keyword == "LBL" || keyword == "CALL" || keyword == "SEL" || keyword == "BEGIN")
    return not_understood("labels, jumps and program calls are not evaluated");
  if (keyword == "FN" || keyword.starts_with('Q') || keyword == "IF")
    return not_understood("Q parameters are not evaluated");
  if (keyword == "LN") return not_understood("LN: vectors of surface and tool are not understood");
  return not_understood("a block that is not understood; it may move the machine");
}

bool Program::end_program() {
  Scanner scanner{block_->rest};
  if (scanner.word() != "PGM") return not_understood("END is understood as END PGM only");
  closed_ = true;
  if (ended_) return true;
  ended_ = true;
  return items_.send(ReadEnd{});
}

bool Program::tool() {
  Scanner scanner{block_->rest};
  const std::string_view what = scanner.word();
  if (what == "DEF") return true;  // the next tool is made ready
  if (what != "CALL") return not_understood("TOOL is understood with CALL and DEF only");
  return call_tool(scanner);
}

/// TOOL CALL 5 Z S12000 F500 DL+0: without a number the spindle speed and the feed alone change.
bool Program::call_tool(Scanner& scanner) {
  std::optional<int> number;
  const double speed_before = modes_.spindle.speed_rpm;
  while (!scanner.at_end())
    if (!tool_word(scanner, number)) return false;
  if (number) {
    if (modes_.tcp) return items_.fail(Code::not_in_dialect, "a tool call while M128 is on");
    modes_.tool = *number;
    modes_.before_tcp_ended.reset();
    columns_.forget(columns_.linear());  // the change takes the tool to its own place
    if (!items_.send(ReadTool{*number})) return false;
  }
  const bool turns = modes_.spindle.state != ReadSpindle::State::off;
  return !turns || modes_.spindle.speed_rpm == speed_before || items_.send(modes_.spindle);
}

bool Program::tool_word(Scanner& scanner, std::optional<int>& number) {
  Decimal value;
  const char first = scanner.ahead();
  if (first == '"') return not_understood("names of tools are not understood");
  if (first >= '0' && first <= '9') return tool_number(scanner, number);
  if (scanner.take("DL")) {
    if (scanner.number(value) && value.mantissa == 0) return true;
    return not_understood("DL changes the length of the tool; it is understood as 0 only");
  }
  if (scanner.take("DR2") || scanner.take("DR"))  // radii matter to compensation alone
    return scanner.number(value) || not_understood("DR without a number");
  if (scanner.take("S")) {
    if (!scanner.number(value) || value.negative)
      return not_understood("S is not followed by a speed");
    modes_.spindle.speed_rpm = value.value();
    return true;
  }
  if (scanner.take("F")) {
    if (!scanner.number(value) || value.negative || value.mantissa == 0)
      return not_understood("F is not followed by a feed");
    modes_.feed = modes_.tool_feed = value.value();
    return true;
  }
  if (scanner.word() != "Z") return not_understood("a word of TOOL CALL that is not understood");
  modes_.tool_axis_is_z = true;
  return true;
}

bool Program::tool_number(Scanner& scanner, std::optional<int>& number) {
  Decimal value;
  constexpr std::uint64_t largest_number = 32'767;
  if (number || !scanner.number(value) || !value.is_plain_integer() ||
      value.mantissa > largest_number)
    return not_understood("a tool is called by one whole number");
  number = static_cast<int>(value.mantissa);
  return true;
}

bool Program::function() {
  Scanner scanner{block_->rest};
  const std::string_view name = scanner.word();
  if (name == "TCPM") return function_tcpm(scanner);
  const std::string_view second = scanner.word();
  if (name == "RESET" && second == "TCPM" && scanner.at_end()) {
    tcp_off();
    return true;
  }
  if (name == "MODE" && second == "MILL" && scanner.at_end()) return true;
  return not_understood("a FUNCTION that is not understood; it may move the machine");
}

/// Only where F is the speed of the tool's tip, the words are axis positions and the axes run
/// evenly between them.
bool Program::function_tcpm(Scanner& scanner) {
  bool tip_feed = false;
  bool axis_positions = false;
  bool axis_path = false;
  while (!scanner.at_end()) {
    const std::string_view name = scanner.word();
    if (name.size() > 1 && name[0] == 'F' && name[1] >= '0' && name[1] <= '9')
      continue;  // largest feed of the compensating movements
    const std::string_view value = scanner.word();
    tip_feed = tip_feed || (name == "F" && value == "TCP");
    axis_positions = axis_positions || (name == "AXIS" && value == "POS");
    axis_path = axis_path || (name == "PATHCTRL" && value == "AXIS");
    const bool is_known = (name == "F" && value == "TCP") || (name == "AXIS" && value == "POS") ||
                          (name == "PATHCTRL" && value == "AXIS") ||
                          (name == "REFPNT" && value == "TIP-TIP");
    if (!is_known) return not_understood("a word of FUNCTION TCPM that is not understood");
  }
  if (!tip_feed || !axis_positions || !axis_path)
    return not_understood("FUNCTION TCPM is understood with F TCP AXIS POS PATHCTRL AXIS");
  return tcp_on();
}

bool Program::plane() {
  Scanner scanner{block_->rest};
  if (scanner.word() == "RESET" && scanner.word() == "STAY" && scanner.at_end()) return true;
  return not_understood("PLANE is understood as PLANE RESET STAY only");
}

}  // namespace pentapost::nc::readers::klartext
