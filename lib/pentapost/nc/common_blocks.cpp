#include "pentapost/nc/common_blocks.hpp"

#include "pentapost/nc/plain_text.hpp"
#include "pentapost/nc/refusals.hpp"
#include "pentapost/nc/words.hpp"

#include <string>

namespace pentapost::nc {

std::optional<double> CommonBlocks::change_tool(const path::ToolCall& call) {
  const auto speed = call.speed_rpm ? nearest_count(*call.speed_rpm, 0) : std::nullopt;
  const std::string speed_word = speed ? std::string{"S"} + std::to_string(*speed) : std::string{};
  bool states_speed = false;
  for (const std::string& line : settings_.tool_change) {
    states_speed = states_speed || line.find("{speed}") != std::string::npos;
    text_.block(filled(filled(line, "{tool}", std::to_string(call.number)), "{speed}", speed_word));
  }
  return speed && states_speed ? call.speed_rpm : std::nullopt;
}

std::optional<Problem> CommonBlocks::spindle(const path::Spindle& spindle, std::uint32_t cl_line) {
  using State = path::Spindle::State;
  if (spindle.state == State::off) {
    text_.block("M5");
    return std::nullopt;
  }
  std::string& out = text_.begin_block();
  if (spindle.speed_rpm) {
    const auto speed = nearest_count(*spindle.speed_rpm, 0);
    if (!speed) return unwritable("S", *spindle.speed_rpm, "rpm", cl_line);
    append_whole_word(out, 'S', *speed);
  }
  out += spindle.state == State::clockwise ? "M3 " : "M4 ";
  text_.end_block();
  return std::nullopt;
}

std::optional<Problem> CommonBlocks::coolant(const path::Coolant& coolant, std::uint32_t cl_line) {
  const std::string* const code = coolant_code(settings_.coolant, coolant.state);
  if (code == nullptr) return no_coolant_code(coolant.state, cl_line);
  text_.block(*code);
  return std::nullopt;
}

void CommonBlocks::smoothing_on() {
  if (!smoothing_is_on_) text_.blocks(settings_.smoothing_on);
  smoothing_is_on_ = true;
}

void CommonBlocks::smoothing_off() {
  if (smoothing_is_on_) text_.blocks(settings_.smoothing_off);
  smoothing_is_on_ = false;
}

}  // namespace pentapost::nc
