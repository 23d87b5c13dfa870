#include "pentapost/nc/dialects/siemens_840d_writer.hpp"
#include "pentapost/nc/plain_text.hpp"
#include "pentapost/nc/refusals.hpp"

#include <algorithm>
#include <utility>

namespace pentapost::nc {
namespace {

constexpr std::size_t comment_width = 60;
/// Fundamentals, MSG: two lines of 62 characters.
constexpr std::size_t message_width = 124;
constexpr double longest_dwell_s = 99'999.999;
/// Fundamentals, tool selection: T0 to T32000; a tool has up to 12 edges, flat D numbers 5 digits.
constexpr int largest_tool = 32'000;

}  // namespace

bool SiemensWriter::act(const path::ToolCall& call, std::uint32_t cl_line) {
  const int length_register = call.length_register.value_or(call.number);
  if (call.number < 0 || length_register < 0 || call.number > largest_tool ||
      length_register > largest_tool)
    return refuse(uncallable(
        "T" + std::to_string(call.number) + " D" + std::to_string(length_register), cl_line));
  leave_inverse_time();
  comment(call.name);
  if (const auto speed_rpm = blocks_.change_tool(call)) spindle_.speed_rpm = speed_rpm;
  length_register_ = length_register;
  // Machine data 20270 decides which D a tool change selects.
  edge_ = Edge::unknown;
  forget();
  words_.lose_all();
  return true;
}

bool SiemensWriter::act(const path::Spindle& spindle, std::uint32_t cl_line) {
  const auto speed_rpm = spindle.speed_rpm ? spindle.speed_rpm : spindle_.speed_rpm;
  spindle_ = {spindle.state, speed_rpm};
  return done(blocks_.spindle(spindle, cl_line));
}

bool SiemensWriter::act(const path::Coolant& coolant, std::uint32_t cl_line) {
  return done(blocks_.coolant(coolant, cl_line));
}

/// F of a G4 block is the time in seconds and leaves the feed as it is (Fundamentals, dwell time).
bool SiemensWriter::act(const path::Dwell& dwell, std::uint32_t cl_line) {
  if (!(dwell.time_s > 0.0 && dwell.time_s <= longest_dwell_s))
    return refuse(unwritable("dwell", dwell.time_s, "s", cl_line));
  leave_inverse_time();
  const std::int64_t time_ms = std::max<std::int64_t>(*nearest_count(dwell.time_s, 3), 1);
  std::string& out = text_.begin_block();
  out += "G4 ";
  append_word(out, 'F', time_ms, 3, words_.style());
  text_.end_block();
  // Not every reader of the block keeps this F apart from the feed.
  forget();
  return true;
}

bool SiemensWriter::act(const path::Stop& stop, std::uint32_t) {
  leave_inverse_time();
  text_.block(stop.optional ? "M1" : "M0");
  // The operator may do anything before going on.
  forget();
  return true;
}

bool SiemensWriter::act(const path::Comment& said, std::uint32_t) {
  comment(said.text);
  message(said.text);
  return true;
}

bool SiemensWriter::act(const path::InsertedText& inserted, std::uint32_t) {
  leave_inverse_time();
  text_.line(printable_ascii(inserted.text));
  forget();
  feed_mode_ = FeedMode::unknown;
  return true;
}

bool SiemensWriter::act(const path::ArcCentre& centre, std::uint32_t) {
  centre_ = centre;
  return true;
}

/// TRAORI takes the length of the tool in use: D has to be back before it.
bool SiemensWriter::act(const path::TcpOn&, std::uint32_t) {
  leave_inverse_time();
  blocks_.smoothing_on();
  if (edge_ != Edge::on) text_.block(edge_word(Edge::on));
  edge_ = Edge::on;
  for (const std::string& line : settings_.common.tcp_on)
    text_.block(filled(line, "{register}", std::to_string(length_register_)));
  forget();
  words_.lose_linear();
  return true;
}

bool SiemensWriter::act(const path::TcpOff&, std::uint32_t) {
  leave_inverse_time();
  text_.blocks(settings_.common.tcp_off);
  blocks_.smoothing_off();
  forget();
  words_.lose_linear();
  return true;
}

bool SiemensWriter::act(const path::SafeRetract&, std::uint32_t) {
  leave_inverse_time();
  text_.blocks(settings_.common.safe_retract);
  if (motion_.output == Output::axes) blocks_.smoothing_off();
  // D0 of the retract holds until a D follows.
  edge_ = Edge::unknown;
  forget();
  words_.lose_linear();
  return true;
}

bool SiemensWriter::act(const path::ProgramEnd&, std::uint32_t) {
  leave_inverse_time();
  blocks_.smoothing_off();
  text_.blocks(settings_.common.end_lines);
  return true;
}

std::string SiemensWriter::edge_word(Edge edge) const {
  if (edge == Edge::off) return "D0";
  return "D" + std::to_string(settings_.edge == 0 ? length_register_ : settings_.edge);
}

void SiemensWriter::leave_inverse_time() {
  if (feed_mode_ != FeedMode::inverse_time) return;
  text_.block("G94");
  feed_mode_ = FeedMode::per_minute;
  feed_.restate();
}

void SiemensWriter::forget() {
  words_.restate_all();
  feed_.restate();
  motion_code_ = -1;
}

void SiemensWriter::comment(std::string_view text) {
  if (!settings_.common.comments) return;
  for (const std::string& line : comment_lines(text, "", comment_width)) text_.line("; " + line);
}

void SiemensWriter::message(std::string_view text) {
  if (!settings_.messages) return;
  const auto lines = comment_lines(text, "\"", message_width);
  if (!lines.empty()) text_.block("MSG(\"" + lines.front() + "\")");
}

bool SiemensWriter::done(std::optional<Problem> problem) {
  problem_ = std::move(problem);
  return !problem_;
}

bool SiemensWriter::refuse(Problem problem) {
  problem_ = std::move(problem);
  return false;
}

}  // namespace pentapost::nc
