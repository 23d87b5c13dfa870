#include "pentapost/nc/dialects/heidenhain_klartext_writer.hpp"
#include "pentapost/nc/plain_text.hpp"
#include "pentapost/nc/refusals.hpp"

#include <algorithm>
#include <utility>

// TNC 640 user's manual conversational programming: TOOL CALL, miscellaneous functions M; Cycle
// programming: cycle 9 dwell time.
namespace pentapost::nc {
namespace {

using State = path::Spindle::State;

constexpr double longest_dwell_s = 3600.0;
constexpr int largest_tool = 32'767;
constexpr std::size_t comment_width = 60;

}  // namespace

bool KlartextWriter::act(const path::ToolCall& call, std::uint32_t cl_line) {
  if (call.number < 0 || call.number > largest_tool)
    return refuse(uncallable("T" + std::to_string(call.number), cl_line));
  comment(call.name);
  speed_rpm_ = blocks_.change_tool(call);
  if (speed_rpm_) spindle_.speed_rpm = speed_rpm_;
  forget();
  words_.lose_all();
  return true;
}

/// The speed belongs to TOOL CALL; the M functions only start and stop the spindle.
bool KlartextWriter::act(const path::Spindle& spindle, std::uint32_t cl_line) {
  if (spindle.state != State::off && spindle.speed_rpm && spindle.speed_rpm != speed_rpm_ &&
      !change_speed(*spindle.speed_rpm, cl_line))
    return false;
  if (spindle.speed_rpm) spindle_.speed_rpm = spindle.speed_rpm;
  spindle_.state = spindle.state;
  return done(blocks_.spindle({.state = spindle.state, .speed_rpm = {}}, cl_line));
}

/// "Before a TOOL CALL block, reset M128": between two blocks that moves nothing.
bool KlartextWriter::change_speed(double speed_rpm, std::uint32_t cl_line) {
  const auto speed = nearest_count(speed_rpm, 0);
  if (!speed) return refuse(unwritable("S", speed_rpm, "rpm", cl_line));
  if (tcp_is_on_) text_.blocks(settings_.common.tcp_off);
  for (const std::string& line : settings_.speed_change)
    text_.block(filled(line, "{speed}", "S" + std::to_string(*speed)));
  speed_rpm_ = speed_rpm;
  if (tcp_is_on_) {
    text_.blocks(settings_.common.tcp_on);
    words_.restate_all();
  }
  // A tool call may bring a feed of its own.
  feed_.restate();
  return true;
}

bool KlartextWriter::act(const path::Coolant& coolant, std::uint32_t cl_line) {
  coolant_ = coolant;
  return done(blocks_.coolant(coolant, cl_line));
}

bool KlartextWriter::act(const path::Dwell& dwell, std::uint32_t cl_line) {
  if (!(dwell.time_s > 0.0 && dwell.time_s <= longest_dwell_s))
    return refuse(unwritable("dwell", dwell.time_s, "s", cl_line));
  const std::int64_t time_ms = std::max<std::int64_t>(*nearest_count(dwell.time_s, 3), 1);
  text_.block("CYCL DEF 9.0 DWELL TIME");
  std::string& out = text_.begin_block();
  out += "CYCL DEF 9.1 DWELL ";
  append_decimal(out, time_ms, 3, {});
  out += ' ';
  text_.end_block();
  return true;
}

/// M0 and M1 stop the spindle and the coolant too ("Miscellaneous functions for program run
/// control").
bool KlartextWriter::act(const path::Stop& stop, std::uint32_t) {
  if (stop.optional)
    text_.block("M1");
  else
    text_.blocks(settings_.program_stop);
  // The operator may do anything before going on.
  forget();
  words_.restate_all();
  restart_spindle();
  restart_coolant();
  return true;
}

void KlartextWriter::restart_spindle() {
  if (spindle_.state != State::off) text_.block(spindle_.state == State::clockwise ? "M3" : "M4");
}

void KlartextWriter::restart_coolant() {
  if (coolant_.state != path::Coolant::State::off)
    text_.block(*coolant_code(settings_.common.coolant, coolant_.state));
}

bool KlartextWriter::act(const path::Comment& said, std::uint32_t) {
  comment(said.text);
  return true;
}

bool KlartextWriter::act(const path::InsertedText& inserted, std::uint32_t) {
  const std::string text = printable_ascii(inserted.text);
  if (inserted_goes_on_)
    text_.line(text);
  else
    text_.block(text);
  inserted_goes_on_ = text.ends_with('~');
  forget();
  words_.restate_all();
  speed_rpm_.reset();
  return true;
}

bool KlartextWriter::act(const path::ArcCentre& centre, std::uint32_t) {
  centre_ = centre;
  return true;
}

bool KlartextWriter::act(const path::TcpOn&, std::uint32_t) {
  blocks_.smoothing_on();
  text_.blocks(settings_.common.tcp_on);
  tcp_is_on_ = true;
  lose_linear_position();
  return true;
}

bool KlartextWriter::act(const path::TcpOff&, std::uint32_t) {
  text_.blocks(settings_.common.tcp_off);
  blocks_.smoothing_off();
  tcp_is_on_ = false;
  lose_linear_position();
  return true;
}

bool KlartextWriter::act(const path::SafeRetract&, std::uint32_t) {
  text_.blocks(settings_.common.safe_retract);
  if (motion_.output == Output::axes) blocks_.smoothing_off();
  lose_linear_position();
  return true;
}

bool KlartextWriter::act(const path::ProgramEnd&, std::uint32_t) {
  blocks_.smoothing_off();
  text_.blocks(settings_.common.end_lines);
  return true;
}

/// A ~ at the end of a line continues the block.
void KlartextWriter::comment(std::string_view said) {
  if (!settings_.common.comments) return;
  for (const std::string& line : comment_lines(said, "~", comment_width))
    text_.block(std::string{"; "} + line);
}

void KlartextWriter::forget() {
  feed_.restate();
  compensation_is_off_ = false;
  behind_helix_.reset();
}

void KlartextWriter::lose_linear_position() {
  forget();
  words_.lose_linear();
}

bool KlartextWriter::refuse(Problem problem) {
  problem_ = std::move(problem);
  return false;
}

bool KlartextWriter::done(std::optional<Problem> problem) {
  problem_ = std::move(problem);
  return !problem_;
}

}  // namespace pentapost::nc
