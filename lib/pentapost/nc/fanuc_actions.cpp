#include "pentapost/nc/fanuc_writer.hpp"
#include "pentapost/nc/plain_text.hpp"
#include "pentapost/nc/refusals.hpp"

#include <algorithm>
#include <stdexcept>

namespace pentapost::nc {
namespace {

constexpr std::size_t comment_width = 60;
constexpr double longest_dwell_s = 99'999.999;
constexpr int largest_register = 99'999'999;
/// F and S of a tap must give its pitch: rounded to the nearest thousandth instead of down.
constexpr int tapping_feed_decimals = 3;

bool is_tapping(path::CycleStart::Kind kind) {
  return kind == path::CycleStart::Kind::tap || kind == path::CycleStart::Kind::tap_left;
}

int cycle_code(const path::NativeCycle& cycle) {
  using Kind = path::CycleStart::Kind;
  const int drilling = cycle.dwell_s > 0.0 ? 82 : 81;
  const int boring = cycle.dwell_s > 0.0 ? 89 : 85;
  switch (cycle.kind) {
    case Kind::drill:
    case Kind::face:
      return drilling;
    case Kind::deep:
      return cycle.peck > 0 ? 83 : drilling;
    case Kind::break_chip:
      return cycle.peck > 0 ? 73 : drilling;
    case Kind::tap:
      return 84;
    case Kind::tap_left:
      return 74;
    case Kind::bore:
    case Kind::ream:
      return boring;
    case Kind::bore_drag:
      return 86;
  }
  throw std::logic_error{"cycle_code: no such cycle"};
}

}  // namespace

std::string fanuc_comment(std::string_view text) {
  std::string all;
  for (const std::string& line : comment_lines(text, "()%", comment_width)) {
    if (!all.empty()) all += ' ';
    all += upper_case(line);
  }
  return all;
}

void FanucWriter::comment(std::string_view text) {
  if (!settings_.common.comments) return;
  for (const std::string& line : comment_lines(text, "()%", comment_width))
    text_.line(std::string{"("} + upper_case(line) + ")");
}

bool FanucWriter::act(const path::ToolCall& call, std::uint32_t cl_line) {
  const int length_register = call.length_register.value_or(call.number);
  if (call.number < 0 || length_register < 0 || call.number > largest_register ||
      length_register > largest_register)
    return refuse(uncallable(
        "T" + std::to_string(call.number) + " H" + std::to_string(length_register), cl_line));
  leave_inverse_time();
  comment(call.name);
  blocks_.change_tool(call);
  length_register_ = length_register;
  forget();
  words_.lose_all();
  approached_ = false;
  return true;
}

bool FanucWriter::act(const path::Spindle& spindle, std::uint32_t cl_line) {
  if (spindle.speed_rpm) speed_rpm_ = spindle.speed_rpm;
  return done(blocks_.spindle(spindle, cl_line));
}

bool FanucWriter::act(const path::Coolant& coolant, std::uint32_t cl_line) {
  return done(blocks_.coolant(coolant, cl_line));
}

bool FanucWriter::act(const path::Dwell& dwell, std::uint32_t cl_line) {
  if (!(dwell.time_s > 0.0 && dwell.time_s <= longest_dwell_s))
    return refuse(unwritable("dwell", dwell.time_s, "s", cl_line));
  leave_inverse_time();
  const std::int64_t time_ms = std::max<std::int64_t>(*nearest_count(dwell.time_s, 3), 1);
  std::string& out = text_.begin_block();
  out += "G4 ";
  switch (settings_.dwell) {
    case FanucSettings::Dwell::p_milliseconds:
      append_whole_word(out, 'P', time_ms);
      break;
    case FanucSettings::Dwell::x_seconds:
      append_word(out, 'X', time_ms, 3, words_.style());
      break;
  }
  text_.end_block();
  return true;
}

bool FanucWriter::act(const path::Stop& stop, std::uint32_t) {
  leave_inverse_time();
  text_.block(stop.optional ? "M1" : "M0");
  // The operator may do anything before going on.
  forget();
  return true;
}

bool FanucWriter::act(const path::Comment& said, std::uint32_t) {
  comment(said.text);
  return true;
}

bool FanucWriter::act(const path::InsertedText& inserted, std::uint32_t) {
  leave_inverse_time();
  text_.line(printable_ascii(inserted.text));
  forget();
  feed_mode_ = FeedMode::unknown;
  return true;
}

bool FanucWriter::act(const path::ArcCentre& centre, std::uint32_t) {
  centre_ = centre;
  return true;
}

bool FanucWriter::act(const path::TcpOn&, std::uint32_t) {
  leave_inverse_time();
  blocks_.smoothing_on();
  for (const std::string& line : settings_.common.tcp_on)
    text_.block(filled(line, "{register}", std::to_string(length_register_)));
  forget();
  words_.lose_linear();
  return true;
}

bool FanucWriter::act(const path::TcpOff&, std::uint32_t) {
  leave_inverse_time();
  text_.blocks(settings_.common.tcp_off);
  blocks_.smoothing_off();
  forget();
  words_.lose_linear();
  return true;
}

bool FanucWriter::act(const path::SafeRetract&, std::uint32_t) {
  leave_inverse_time();
  text_.blocks(settings_.common.safe_retract);
  // G49 before the retract would let the tool down by its length.
  if (length_on_) text_.block("G49");
  if (motion_.output == Output::axes) blocks_.smoothing_off();
  length_on_ = false;
  approached_ = false;
  forget();
  words_.lose_linear();
  return true;
}

bool FanucWriter::act(const path::NativeCycle& cycle, std::uint32_t) {
  if (!(cycle.feed_mm_min > 0.0)) throw std::logic_error{"FanucWriter: a cycle without feed"};
  leave_inverse_time();
  if (cycle_state_ == CycleState::written) end_cycle();
  cycle_ = cycle;
  cycle_state_ = CycleState::ordered;
  return true;
}

void FanucWriter::write_cycle_code(std::string& out) const {
  out += cycle_.retract_to_clearance ? "G99 " : "G98 ";
  append_whole_word(out, 'G', cycle_code(cycle_));
}

/// Else a parameter decides whether G84 couples feed and spindle (bit G84 of parameter 5200).
void FanucWriter::write_rigid_tapping() {
  if (!is_tapping(cycle_.kind)) return;
  const auto speed = speed_rpm_ ? nearest_count(*speed_rpm_, 0) : std::nullopt;
  const std::string speed_word = speed ? "S" + std::to_string(*speed) : std::string{};
  for (const std::string& line : settings_.rigid_tapping)
    text_.block(filled(line, "{speed}", speed_word));
}

bool FanucWriter::write_cycle_parameters(std::string& out, std::uint32_t cl_line) {
  const std::size_t z = words_.z();
  const int decimals = words_.columns().decimals(z);
  if (!words_.columns().fits(z, cycle_.clearance_z) || !words_.columns().fits(z, cycle_.peck) ||
      !(cycle_.dwell_s >= 0.0 && cycle_.dwell_s <= longest_dwell_s))
    return refuse(
        refusal(Code::out_of_domain, "a number of the cycle has too many digits", cl_line));
  append_word(out, 'R', cycle_.clearance_z, decimals, words_.style());
  const int code = cycle_code(cycle_);
  if (code == 83 || code == 73) append_word(out, 'Q', cycle_.peck, decimals, words_.style());
  if (cycle_.dwell_s > 0.0) append_whole_word(out, 'P', *nearest_count(cycle_.dwell_s, 3));
  feed_.restate();
  if (!is_tapping(cycle_.kind))
    return write_feed(out, path::Block::Feed::per_minute, cycle_.feed_mm_min, cl_line);
  const auto feed = nearest_count(cycle_.feed_mm_min, tapping_feed_decimals);
  if (!feed || *feed == 0) return refuse(unwritable("F", cycle_.feed_mm_min, "mm/min", cl_line));
  append_word(out, 'F', *feed, tapping_feed_decimals, words_.style());
  return true;
}

bool FanucWriter::act(const path::NativeCycleEnd&, std::uint32_t) {
  if (cycle_state_ == CycleState::written) end_cycle();
  cycle_state_ = CycleState::off;
  return true;
}

bool FanucWriter::act(const path::ProgramEnd&, std::uint32_t) {
  leave_inverse_time();
  blocks_.smoothing_off();
  text_.blocks(settings_.common.end_lines);
  return true;
}

}  // namespace pentapost::nc
