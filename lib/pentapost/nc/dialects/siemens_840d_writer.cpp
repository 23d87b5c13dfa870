#include "pentapost/nc/dialects/siemens_840d_writer.hpp"

#include "pentapost/nc/program_header.hpp"
#include "pentapost/nc/refusals.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace pentapost::nc {
namespace {

/// SINUMERIK 840D sl, Fundamentals, addresses: axis positions up to 99999.9999, N up to 8 digits.
constexpr int whole_digits = 5;
constexpr std::int64_t largest_block_number = 99'999'999;

}  // namespace

SiemensWriter::SiemensWriter(const path::Motion& motion, const SiemensSettings& settings,
                             std::string& out)
    : motion_{motion},
      settings_{settings},
      words_{motion, whole_digits, {}},
      feed_{settings.common.feed_decimals},
      text_{out, settings.common.block_numbers, largest_block_number, ""},
      blocks_{settings.common, text_} {}

void SiemensWriter::start(const path::ProgramHeader& header) {
  for (const std::string& line : settings_.program_lines) text_.line(line);
  for (const std::string& line : header_comments(header, motion_)) comment(line);
  text_.blocks(settings_.common.start_lines);
}

bool SiemensWriter::write(const path::Block& block) {
  using Kind = path::Block::Kind;
  using Feed = path::Block::Feed;
  if (auto misfit = words_.misfit(block)) return refuse(std::move(*misfit));
  if (block.kind == Kind::drill) return write_hole(block);
  if (cycle_state_ == CycleState::written) end_cycle();
  switch (block.kind) {
    case Kind::rapid:
      if (settings_.common.rapid_as_line)
        return write_straight(block, 1, Feed::per_minute, settings_.common.rapid_feed_mm_min);
      return write_straight(block, 0, Feed::none, 0.0);
    case Kind::line:
      if (block.feed_mode == Feed::none)
        throw std::logic_error{"SiemensWriter: a line without feed"};
      return write_straight(block, 1, block.feed_mode, block.feed);
    case Kind::arc_clockwise:
    case Kind::arc_counterclockwise:
      return write_arc(block);
    case Kind::drill:
      break;
  }
  throw std::logic_error{"SiemensWriter: no such block"};
}

bool SiemensWriter::write_straight(const path::Block& block, int code, path::Block::Feed mode,
                                   double feed) {
  start_smoothing(block);
  const std::uint8_t words = settings_.modal_words ? words_.changed(block) : block.stated;
  std::string& out = text_.begin_block();
  write_mode(out, mode);
  write_motion_code(out, code);
  if (code == 0 && !block.on_path && !settings_.shortest_way_axes.empty())
    write_prepositioning(out, block, words);
  else
    words_.append(out, block, words);
  approach(out, block);
  if (mode != path::Block::Feed::none && !write_feed(out, mode, feed, block.cl_line)) return false;
  text_.end_block();
  words_.place(block);
  return true;
}

/// I and J count from the start point unless AC() says otherwise (Fundamentals, circular
/// interpolation with centre and end point). An arc of a block turns less than a full circle.
bool SiemensWriter::write_arc(const path::Block& block) {
  if (!centre_) throw std::logic_error{"SiemensWriter: an arc without a centre"};
  const std::size_t z = words_.z();
  const std::uint8_t helix = z == WordColumns::none ? 0 : bit(z);
  if (auto misfit = words_.arc_misfit(block, helix)) return refuse(std::move(*misfit));
  const WordColumns& columns = words_.columns();
  if (!columns.fits(words_.x(), centre_->i) || !columns.fits(words_.y(), centre_->j))
    return refuse(
        refusal(Code::out_of_domain, "the centre of an arc has too many digits", block.cl_line));
  auto words = static_cast<std::uint8_t>(bit(words_.x()) | bit(words_.y()));
  if (helix != 0 && words_.moves(block, z)) words |= helix;
  std::string& out = text_.begin_block();
  write_mode(out, block.feed_mode);
  write_motion_code(out, block.kind == path::Block::Kind::arc_clockwise ? 2 : 3);
  words_.append(out, block, words);
  append_word(out, 'I', centre_->i, columns.decimals(words_.x()), words_.style());
  append_word(out, 'J', centre_->j, columns.decimals(words_.y()), words_.style());
  if (!write_feed(out, block.feed_mode, block.feed, block.cl_line)) return false;
  text_.end_block();
  centre_.reset();
  // Words that the arc left out stay as certain as they were.
  path::Block arc = block;
  arc.stated = words;
  words_.place(arc);
  return true;
}

/// DC takes positions from 0 to below 360 deg (Fundamentals, absolute dimension of rotary axes).
bool SiemensWriter::goes_the_shortest_way(const path::Block& block, std::size_t column) const {
  const WordColumns& columns = words_.columns();
  if (settings_.shortest_way_axes.find(columns.letter(column)) == std::string::npos ||
      columns.is_linear(column))
    return false;
  std::int64_t turn = 360;
  for (int i = 0; i < columns.decimals(column); ++i) turn *= 10;
  return block.word[column] >= 0 && block.word[column] < turn;
}

void SiemensWriter::write_prepositioning(std::string& out, const path::Block& block,
                                         std::uint8_t words) const {
  const WordColumns& columns = words_.columns();
  for (const std::size_t column : columns) {
    if ((words & bit(column)) == 0) continue;
    if (!goes_the_shortest_way(block, column)) {
      words_.append(out, block, bit(column));
      continue;
    }
    out += columns.letter(column);
    out += "=DC(";
    append_decimal(out, block.word[column], columns.decimals(column), words_.style());
    out += ") ";
  }
}

/// Without TCP smoothing starts where the tool goes to the part: at its first move of Z.
void SiemensWriter::start_smoothing(const path::Block& block) {
  const std::size_t z = words_.z();
  if (motion_.output == Output::axes && z != WordColumns::none && (block.stated & bit(z)) != 0)
    blocks_.smoothing_on();
}

/// The length of D acts with the next move of its axis (Fundamentals, tool offset call D), so that
/// D stands where Z does.
void SiemensWriter::approach(std::string& out, const path::Block& block) {
  const std::size_t z = words_.z();
  const Edge wanted = motion_.length_offset ? Edge::on : Edge::off;
  if (motion_.output == Output::tcp || edge_ == wanted || z == WordColumns::none ||
      (block.stated & bit(z)) == 0)
    return;
  out.append(edge_word(wanted)).push_back(' ');
  edge_ = wanted;
}

void SiemensWriter::write_motion_code(std::string& out, int code) {
  if (code == motion_code_) return;
  append_whole_word(out, 'G', code);
  motion_code_ = code;
}

void SiemensWriter::write_mode(std::string& out, path::Block::Feed mode) {
  if (mode == path::Block::Feed::none) return;
  const FeedMode wanted =
      mode == path::Block::Feed::inverse_time ? FeedMode::inverse_time : FeedMode::per_minute;
  if (wanted == feed_mode_) return;
  out += wanted == FeedMode::inverse_time ? "G93 " : "G94 ";
  feed_mode_ = wanted;
  feed_.restate();
}

bool SiemensWriter::write_feed(std::string& out, path::Block::Feed mode, double feed,
                               std::uint32_t cl_line) {
  if (mode == path::Block::Feed::per_minute) {
    if (feed_.append(out, feed, words_.style())) return true;
    return refuse(unwritable("F", feed, "mm/min", cl_line));
  }
  // The time of a block is its own: F stands in every one.
  const int decimals = settings_.inverse_time_decimals;
  const auto count = feed_count(std::min(feed, settings_.largest_inverse_time), decimals);
  if (!count) return refuse(unwritable("F", feed, "1/min", cl_line));
  append_word(out, 'F', *count, decimals, words_.style());
  return true;
}

}  // namespace pentapost::nc
