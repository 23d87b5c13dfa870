#include "pentapost/nc/refusals.hpp"

#include "pentapost/core/number_text.hpp"
#include "pentapost/nc/common_options.hpp"

#include <utility>

namespace pentapost::nc {

Problem refusal(Code code, std::string message, std::uint32_t cl_line) {
  Problem problem{.code = code, .message = std::move(message)};
  if (cl_line != 0) problem.cl_line = cl_line;
  return problem;
}

Problem unwritable(std::string_view what, double value, std::string_view unit,
                   std::uint32_t cl_line) {
  std::string message{what};
  message += " = " + number_text(value);
  if (!unit.empty()) message.append(" ").append(unit);
  return refusal(Code::out_of_domain, message + " cannot be written on this control", cl_line);
}

Problem uncallable(std::string_view words, std::uint32_t cl_line) {
  return refusal(Code::out_of_domain,
                 std::string{words} + " is not a tool that the control can call", cl_line);
}

Problem no_coolant_code(path::Coolant::State state, std::uint32_t cl_line) {
  return refusal(Code::not_in_dialect,
                 "the machine has no code for this coolant; " + std::string{coolant_option(state)} +
                     " in controller.options of its definition can give one",
                 cl_line);
}

}  // namespace pentapost::nc
