#include "pentapost/nc/dialects/heidenhain_klartext_writer.hpp"

#include "pentapost/nc/plain_text.hpp"
#include "pentapost/nc/program_header.hpp"
#include "pentapost/nc/refusals.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

// TNC 640 user's manual conversational programming: straight line L, rapid traverse FMAX,
// "Input format and unit of TNC functions".
namespace pentapost::nc {
namespace {

constexpr int whole_digits = 5;  ///< the control counts to 99 999.9999 mm and degrees
constexpr double largest_feed = 99'999.999;
constexpr double most_held_feed = 999'999'999.0;  ///< more is refused rather than held
constexpr std::int64_t largest_block_number = 999'999'999;

BlockNumbers numbers_from_0(BlockNumbers numbers) {
  numbers.start = 0;
  return numbers;
}

}  // namespace

KlartextWriter::KlartextWriter(const path::Motion& motion, const KlartextSettings& settings,
                               std::string& out)
    : motion_{motion},
      settings_{settings},
      words_{motion, whole_digits, {.plus_sign = true}},
      feed_{settings.common.feed_decimals},
      text_{out, numbers_from_0(settings.common.block_numbers), largest_block_number, ""},
      blocks_{settings.common, text_} {}

void KlartextWriter::start(const path::ProgramHeader& header) {
  name_ = clean_program_name(header.program_name, settings_.program_name_length) + " MM";
  text_.block("BEGIN PGM " + name_);
  text_.blocks(settings_.blank_form);
  for (const std::string& line : header_comments(header, motion_)) comment(line);
  text_.blocks(settings_.common.start_lines);
}

void KlartextWriter::finish() { text_.block("END PGM " + name_); }

bool KlartextWriter::write(const path::Block& block) {
  using Kind = path::Block::Kind;
  if (auto misfit = words_.misfit(block)) return refuse(std::move(*misfit));
  if (block.feed_mode == path::Block::Feed::inverse_time)
    throw std::logic_error{"heidenhain has no inverse time"};
  switch (block.kind) {
    case Kind::rapid:
      if (!settings_.common.rapid_as_line) return write_rapid(block);
      return write_line(block, settings_.common.rapid_feed_mm_min);
    case Kind::line:
      if (block.feed_mode == path::Block::Feed::none)
        throw std::logic_error{"heidenhain: a line without feed"};
      return write_line(block, block.feed);
    case Kind::arc_clockwise:
    case Kind::arc_counterclockwise:
      return write_arc(block);
    case Kind::drill:
      return write_hole(block);
  }
  throw std::logic_error{"heidenhain: no such block"};
}

/// FMAX holds for its block alone; the feed before it stays in force.
bool KlartextWriter::write_rapid(const path::Block& block) {
  start_smoothing(block);
  std::string& out = text_.begin_block();
  out += "L ";
  words_.append(out, block, words_of(block));
  out += "R0 FMAX ";
  text_.end_block();
  compensation_is_off_ = true;
  behind_helix_.reset();
  words_.place(block);
  return true;
}

bool KlartextWriter::write_line(const path::Block& block, double feed_mm_min) {
  start_smoothing(block);
  std::string& out = text_.begin_block();
  out += "L ";
  words_.append(out, block, words_of(block));
  if (!write_feed(out, feed_mm_min, block.cl_line)) return false;
  text_.end_block();
  behind_helix_.reset();
  words_.place(block);
  return true;
}

std::uint8_t KlartextWriter::words_of(const path::Block& block) const {
  return settings_.modal_words ? words_.changed(block) : block.stated;
}

/// Without TCP smoothing starts where the tool goes to the part: at its first linear move.
void KlartextWriter::start_smoothing(const path::Block& block) {
  constexpr unsigned linear = 0x7;
  if (motion_.output == Output::axes && (block.stated & linear) != 0) blocks_.smoothing_on();
}

bool KlartextWriter::write_feed(std::string& out, double feed_mm_min, std::uint32_t cl_line) {
  if (!compensation_is_off_) out += "R0 ";
  compensation_is_off_ = true;
  const double held =
      feed_mm_min <= most_held_feed ? std::min(feed_mm_min, largest_feed) : feed_mm_min;
  if (feed_.append(out, held, {})) return true;
  return refuse(unwritable("F", feed_mm_min, "mm/min", cl_line));
}

}  // namespace pentapost::nc
