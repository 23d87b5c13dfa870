#include "pentapost/nc/dialects/heidenhain_iso.hpp"

#include "pentapost/nc/axis_words.hpp"
#include "pentapost/nc/common_blocks.hpp"
#include "pentapost/nc/common_options.hpp"
#include "pentapost/nc/options.hpp"
#include "pentapost/nc/plain_text.hpp"
#include "pentapost/nc/program_header.hpp"
#include "pentapost/nc/program_text.hpp"
#include "pentapost/nc/refusals.hpp"
#include "pentapost/nc/walk.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace pentapost::nc {
namespace {

constexpr int whole_digits = 5;  ///< the control counts to 99999 mm and degrees
constexpr double largest_feed = 99'999.999;
constexpr double most_held_feed = 999'999'999.0;  ///< more is refused rather than held
constexpr double longest_dwell_s = 3600.0;
constexpr int largest_tool = 32'767;
constexpr std::size_t comment_width = 60;

CommonSettings default_settings() {
  CommonSettings defaults;
  defaults.block_numbers.on = true;
  defaults.feed_decimals = 3;
  defaults.start_lines = {"G90"};
  defaults.end_lines = {"M30"};
  defaults.safe_retract = {"M140 MB MAX"};
  defaults.tool_change = {"T{tool} G17 {speed}"};
  defaults.tcp_on = {"M128"};
  defaults.tcp_off = {"M129"};
  return defaults;
}

std::vector<OptionRow> all_rows() {
  std::vector<OptionRow> rows = common_rows(default_settings());
  rows.insert(rows.end(),
              {{"closing_number", 99'999'999.0, "number of the last block, 100 to 99999999"},
               {"program_name_length", 16.0, "most characters of a program name, 1 to 24"},
               {"arcs_with_tcp", false,
                "write arcs while TCP is on; not confirmed by a manual of the control"}});
  return rows;
}

const std::vector<OptionRow> rows = all_rows();

struct Settings {
  CommonSettings common;
  int closing_number = 0;
  std::size_t program_name_length = 0;
  bool arcs_with_tcp = false;
};

Result<Settings> read(const machine::Options& given) {
  OptionReader reader{rows, given};
  Settings settings{
      .common = read_common(reader),
      .closing_number = reader.whole("closing_number", 100, 99'999'999),
      .program_name_length = static_cast<std::size_t>(reader.whole("program_name_length", 1, 24)),
      .arcs_with_tcp = reader.flag("arcs_with_tcp")};
  if (settings.common.block_numbers.start >= settings.closing_number)
    reader.refuse("block_number_start", "must be below closing_number");
  if (reader.problem()) return *reader.problem();
  return settings;
}

Result<Abilities> abilities(const machine::Options& given) {
  const auto settings = read(given);
  if (!settings) return settings.error();
  Abilities can = common_abilities(settings->common);
  can.largest_feed = largest_feed;
  can.arcs_with_tcp = can.arcs && settings->arcs_with_tcp;
  can.adds_length_always = true;
  can.retract_needs_tool = true;  // M140 goes along the tool axis that the tool call states
  return can;
}

/// Writes one program; what the control holds modal at each block is kept here.
class Writer {
 public:
  Writer(const path::Motion& motion, const Settings& settings, std::string& out)
      : motion_{motion},
        settings_{settings},
        words_{motion, whole_digits, {.plus_sign = true}},
        feed_{settings.common.feed_decimals},
        text_{out, settings.common.block_numbers, settings.closing_number - 1, "*"},
        blocks_{settings.common, text_} {}

  void start(const path::ProgramHeader& header) {
    title_ = std::string{"%"} +
             clean_program_name(header.program_name, settings_.program_name_length) + " G71 *";
    text_.line(title_);
    text_.blocks(settings_.common.start_lines);
    for (const std::string& line : header_comments(header, motion_)) comment(line);
  }
  void finish() {
    text_.line(std::string{"N"} + std::to_string(settings_.closing_number) + " " + title_);
  }

  bool write(const path::Block& block);
  bool act(const path::ToolCall& call, std::uint32_t cl_line);
  bool act(const path::Spindle& spindle, std::uint32_t cl_line);
  bool act(const path::Coolant& coolant, std::uint32_t cl_line);
  bool act(const path::Dwell& dwell, std::uint32_t cl_line);

  bool act(const path::Stop& stop, std::uint32_t) {
    text_.block(stop.optional ? "M01" : "M00");
    // The operator may do anything before going on.
    forget();
    speed_rpm_.reset();
    return true;
  }
  bool act(const path::Comment& said, std::uint32_t) {
    comment(said.text);
    return true;
  }
  bool act(const path::InsertedText& inserted, std::uint32_t) {
    // A block of this control ends with *; text that has it already is left as it stands.
    const std::string text = printable_ascii(inserted.text);
    if (text.ends_with('*'))
      text_.line(text);
    else
      text_.block(text);
    forget();
    speed_rpm_.reset();
    return true;
  }
  bool act(const path::ArcCentre& centre, std::uint32_t) {
    centre_ = centre;
    return true;
  }
  bool act(const path::TcpOn&, std::uint32_t) {
    blocks_.smoothing_on();
    text_.blocks(settings_.common.tcp_on);
    lose_linear_position();
    return true;
  }
  bool act(const path::TcpOff&, std::uint32_t) {
    text_.blocks(settings_.common.tcp_off);
    blocks_.smoothing_off();
    lose_linear_position();
    return true;
  }
  bool act(const path::SafeRetract&, std::uint32_t) {
    text_.blocks(settings_.common.safe_retract);
    if (motion_.output == Output::axes) blocks_.smoothing_off();
    lose_linear_position();
    return true;
  }
  bool act(const path::NativeCycle&, std::uint32_t) {
    throw std::logic_error{"heidenhain-iso has no native cycles"};
  }
  bool act(const path::NativeCycleEnd&, std::uint32_t) { return true; }
  bool act(const path::ProgramEnd&, std::uint32_t) {
    blocks_.smoothing_off();
    text_.blocks(settings_.common.end_lines);
    return true;
  }

  const std::optional<Problem>& problem() const noexcept { return problem_; }

 private:
  enum class MotionCode : std::uint8_t { unknown, g00, g01, g02, g03 };

  bool write_straight(const path::Block& block, MotionCode code, double feed_mm_min);
  bool write_arc(const path::Block& block);
  /// Held to what the control takes.
  bool write_feed(std::string& out, double feed_mm_min, std::uint32_t cl_line);
  void write_code(std::string& out, MotionCode code);
  void comment(std::string_view said);

  /// Whether there is no Problem; keeps one.
  bool done(std::optional<Problem> problem) {
    problem_ = std::move(problem);
    return !problem_;
  }
  bool refuse(Problem problem) {
    problem_ = std::move(problem);
    return false;
  }
  void forget() {
    code_ = MotionCode::unknown;
    feed_.restate();
  }
  void lose_linear_position() {
    forget();
    words_.lose_linear();
  }

  const path::Motion& motion_;
  const Settings& settings_;
  AxisWords words_;
  FeedWord feed_;
  ProgramText text_;
  CommonBlocks blocks_;
  std::optional<Problem> problem_;
  std::string title_;  ///< "%NAME G71 *", first and last line
  MotionCode code_ = MotionCode::unknown;
  std::optional<double> speed_rpm_;  ///< that the control holds
  std::optional<path::ArcCentre> centre_;
};

bool Writer::write(const path::Block& block) {
  using Kind = path::Block::Kind;
  if (auto misfit = words_.misfit(block)) return refuse(std::move(*misfit));
  if (block.feed_mode == path::Block::Feed::inverse_time)
    throw std::logic_error{"heidenhain-iso has no inverse time"};
  switch (block.kind) {
    case Kind::rapid:
      if (!settings_.common.rapid_as_line) return write_straight(block, MotionCode::g00, 0.0);
      return write_straight(block, MotionCode::g01, settings_.common.rapid_feed_mm_min);
    case Kind::line:
      if (block.feed_mode == path::Block::Feed::none)
        throw std::logic_error{"heidenhain-iso: a line without feed"};
      return write_straight(block, MotionCode::g01, block.feed);
    case Kind::arc_clockwise:
    case Kind::arc_counterclockwise:
      return write_arc(block);
    case Kind::drill:
      throw std::logic_error{"heidenhain-iso has no native cycles"};
  }
  throw std::logic_error{"heidenhain-iso: no such block"};
}

/// @param feed_mm_min  0 for G00, which has none.
bool Writer::write_straight(const path::Block& block, MotionCode code, double feed_mm_min) {
  // Without TCP smoothing starts where the tool goes to the part: at its first linear move.
  if (motion_.output == Output::axes && (block.stated & 0x7U) != 0) blocks_.smoothing_on();
  std::string& out = text_.begin_block();
  write_code(out, code);
  words_.append(out, block, block.stated);
  if (code != MotionCode::g00 && !write_feed(out, feed_mm_min, block.cl_line)) return false;
  text_.end_block();
  words_.place(block);
  return true;
}

/// The pole is a block of its own, in absolute coordinates (iTNC 530 ISO programming, "Circle
/// center I, J"); the arc's block has the end point in the plane alone.
bool Writer::write_arc(const path::Block& block) {
  if (!centre_) throw std::logic_error{"heidenhain-iso: an arc without a centre"};
  if (auto misfit = words_.arc_misfit(block, 0)) return refuse(std::move(*misfit));
  const WordColumns& columns = words_.columns();
  const std::size_t x = words_.x();
  const std::size_t y = words_.y();
  const std::int64_t i = words_.at(x) + centre_->i;
  const std::int64_t j = words_.at(y) + centre_->j;
  if (!columns.fits(x, i) || !columns.fits(y, j))
    return refuse(
        refusal(Code::out_of_domain, "the centre of an arc has too many digits", block.cl_line));
  std::string& pole = text_.begin_block();
  append_word(pole, 'I', i, columns.decimals(x), words_.style());
  append_word(pole, 'J', j, columns.decimals(y), words_.style());
  text_.end_block();

  const bool clockwise = block.kind == path::Block::Kind::arc_clockwise;
  std::string& out = text_.begin_block();
  write_code(out, clockwise ? MotionCode::g02 : MotionCode::g03);
  words_.append(out, block, static_cast<std::uint8_t>(bit(x) | bit(y)));
  if (!write_feed(out, block.feed, block.cl_line)) return false;
  text_.end_block();
  centre_.reset();
  words_.place(block);
  return true;
}

void Writer::write_code(std::string& out, MotionCode code) {
  if (code == code_) return;
  code_ = code;
  switch (code) {
    case MotionCode::g00:
      out += "G00 ";
      return;
    case MotionCode::g01:
      out += "G01 ";
      return;
    case MotionCode::g02:
      out += "G02 ";
      return;
    case MotionCode::g03:
      out += "G03 ";
      return;
    case MotionCode::unknown:
      break;
  }
  throw std::logic_error{"heidenhain-iso: no such motion code"};
}

bool Writer::write_feed(std::string& out, double feed_mm_min, std::uint32_t cl_line) {
  const double held =
      feed_mm_min <= most_held_feed ? std::min(feed_mm_min, largest_feed) : feed_mm_min;
  if (feed_.append(out, held, {})) return true;
  return refuse(unwritable("F", feed_mm_min, "mm/min", cl_line));
}

bool Writer::act(const path::ToolCall& call, std::uint32_t cl_line) {
  if (call.number < 0 || call.number > largest_tool)
    return refuse(uncallable("T" + std::to_string(call.number), cl_line));
  comment(call.name);
  speed_rpm_ = blocks_.change_tool(call);
  forget();
  words_.lose_all();
  return true;
}

bool Writer::act(const path::Spindle& spindle, std::uint32_t cl_line) {
  path::Spindle unsaid = spindle;
  if (spindle.speed_rpm == speed_rpm_)
    unsaid.speed_rpm.reset();
  else if (spindle.speed_rpm && spindle.state != path::Spindle::State::off)
    speed_rpm_ = spindle.speed_rpm;
  return done(blocks_.spindle(unsaid, cl_line));
}

bool Writer::act(const path::Coolant& coolant, std::uint32_t cl_line) {
  return done(blocks_.coolant(coolant, cl_line));
}

bool Writer::act(const path::Dwell& dwell, std::uint32_t cl_line) {
  if (!(dwell.time_s > 0.0 && dwell.time_s <= longest_dwell_s))
    return refuse(unwritable("dwell", dwell.time_s, "s", cl_line));
  const std::int64_t time_ms = std::max<std::int64_t>(*nearest_count(dwell.time_s, 3), 1);
  std::string& out = text_.begin_block();
  out += "G04 ";
  append_word(out, 'F', time_ms, 3, {});
  text_.end_block();
  // Not every reader of the block keeps this F apart from the feed.
  forget();
  return true;
}

void Writer::comment(std::string_view said) {
  if (!settings_.common.comments) return;
  for (const std::string& line : comment_lines(said, "*%", comment_width))
    text_.block(std::string{"; "} + line);
}

Status write(const path::Motion& motion, const path::ProgramHeader& header,
             const machine::Options& given, std::string& out) {
  const auto settings = read(given);
  if (!settings) return settings.error();
  reserve_text(out, motion, 12);
  Writer writer{motion, *settings, out};
  writer.start(header);
  if (!walk(motion, writer)) return *writer.problem();
  writer.finish();
  return ok();
}

}  // namespace

const Dialect heidenhain_iso{
    .name = "heidenhain-iso",
    .title = "Heidenhain TNC, DIN/ISO programs",
    .options = rows,
    .abilities = abilities,
    .write = write,
};

}  // namespace pentapost::nc
