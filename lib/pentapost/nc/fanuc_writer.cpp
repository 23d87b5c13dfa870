#include "pentapost/nc/fanuc_writer.hpp"

#include "pentapost/nc/program_header.hpp"
#include "pentapost/nc/refusals.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace pentapost::nc {

FanucWriter::FanucWriter(const path::Motion& motion, const FanucSettings& settings,
                         std::string& out)
    : motion_{motion},
      settings_{settings},
      words_{motion, settings.whole_digits, {.always_point = true}},
      feed_{settings.common.feed_decimals},
      text_{out, settings.common.block_numbers, settings.largest_block_number, ""},
      blocks_{settings.common, text_} {}

void FanucWriter::start(const path::ProgramHeader& header) {
  if (settings_.tape_marks) text_.line("%");
  if (!settings_.program_line.empty()) text_.line(settings_.program_line);
  for (const std::string& line : header_comments(header, motion_)) comment(line);
  text_.blocks(settings_.common.start_lines);
}

void FanucWriter::finish() {
  if (settings_.tape_marks) text_.line("%");
}

bool FanucWriter::write(const path::Block& block) {
  using Kind = path::Block::Kind;
  using Feed = path::Block::Feed;
  if (auto misfit = words_.misfit(block)) return refuse(std::move(*misfit));
  switch (block.kind) {
    case Kind::rapid:
      if (settings_.common.rapid_as_line)
        return write_straight(block, 1, Feed::per_minute, settings_.common.rapid_feed_mm_min);
      return write_straight(block, 0, Feed::none, 0.0);
    case Kind::line:
      if (block.feed_mode == Feed::none) throw std::logic_error{"FanucWriter: a line without feed"};
      return write_straight(block, 1, block.feed_mode, block.feed);
    case Kind::arc_clockwise:
    case Kind::arc_counterclockwise:
      return write_arc(block);
    case Kind::drill:
      return write_hole(block);
  }
  throw std::logic_error{"FanucWriter: no such block"};
}

bool FanucWriter::write_straight(const path::Block& block, int code, path::Block::Feed mode,
                                 double feed) {
  if (cycle_state_ == CycleState::written) end_cycle();
  const bool length = approach(block);
  std::uint8_t words = settings_.modal_words ? words_.changed(block) : block.stated;
  std::string& out = text_.begin_block();
  write_mode(out, mode);
  write_motion_code(out, code);
  if (length) {
    out += "G43 ";
    words |= bit(words_.z());
  }
  words_.append(out, block, words);
  if (length) write_tool_length(out);
  if (mode != path::Block::Feed::none && !write_feed(out, mode, feed, block.cl_line)) return false;
  text_.end_block();
  words_.place(block);
  return true;
}

bool FanucWriter::write_arc(const path::Block& block) {
  if (!centre_) throw std::logic_error{"FanucWriter: an arc without a centre"};
  if (cycle_state_ == CycleState::written) end_cycle();
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

/// The hole's place is always written, a block without it would not drill; Z is modal in a cycle.
std::uint8_t FanucWriter::hole_words(const path::Block& block) const {
  if (!settings_.modal_words) return block.stated;
  auto words = static_cast<std::uint8_t>(words_.changed(block) | bit(words_.x()) | bit(words_.y()));
  if (cycle_state_ == CycleState::ordered || block.word[words_.z()] != hole_bottom_)
    return words | bit(words_.z());
  return static_cast<std::uint8_t>(words & ~bit(words_.z()));
}

bool FanucWriter::write_hole(const path::Block& block) {
  const std::size_t none = WordColumns::none;
  if (cycle_state_ == CycleState::off || words_.x() == none || words_.y() == none ||
      words_.z() == none)
    throw std::logic_error{"FanucWriter: a hole without a cycle or without X, Y, Z"};
  const bool first = cycle_state_ == CycleState::ordered;
  const bool length = approach(block);
  if (first) write_rigid_tapping();
  std::string& out = text_.begin_block();
  if (first) write_mode(out, path::Block::Feed::per_minute);
  if (length) out += "G43 ";
  if (first) write_cycle_code(out);
  words_.append(out, block, hole_words(block));
  if (length) write_tool_length(out);
  if (first && !write_cycle_parameters(out, block.cl_line)) return false;
  text_.end_block();
  cycle_state_ = CycleState::written;
  hole_bottom_ = block.word[words_.z()];
  words_.place(block);
  words_.lose(words_.z());
  return true;
}

/// True where this block is to switch the tool length on: the first that states Z after a retract.
bool FanucWriter::approach(const path::Block& block) {
  if (motion_.output == Output::tcp || approached_ || words_.z() == WordColumns::none ||
      (block.stated & bit(words_.z())) == 0)
    return false;
  approached_ = true;
  blocks_.smoothing_on();
  length_on_ = motion_.length_offset;
  return length_on_;
}

void FanucWriter::write_motion_code(std::string& out, int code) {
  if (code == motion_code_) return;
  append_whole_word(out, 'G', code);
  motion_code_ = code;
}

void FanucWriter::write_mode(std::string& out, path::Block::Feed mode) {
  const FeedMode wanted =
      mode == path::Block::Feed::inverse_time ? FeedMode::inverse_time : FeedMode::per_minute;
  if (wanted == feed_mode_) return;
  out += wanted == FeedMode::inverse_time ? "G93 " : "G94 ";
  feed_mode_ = wanted;
  feed_.restate();
}

bool FanucWriter::write_feed(std::string& out, path::Block::Feed mode, double feed,
                             std::uint32_t cl_line) {
  if (mode == path::Block::Feed::per_minute) {
    if (feed_.append(out, feed, words_.style())) return true;
    return refuse(unwritable("F", feed, "mm/min", cl_line));
  }
  // In inverse time the control wants an F in every block.
  const int decimals = settings_.inverse_time_decimals;
  const auto count = feed_count(std::min(feed, settings_.largest_inverse_time), decimals);
  if (!count) return refuse(unwritable("F", feed, "1/min", cl_line));
  append_word(out, 'F', *count, decimals, words_.style());
  return true;
}

void FanucWriter::leave_inverse_time() {
  if (feed_mode_ != FeedMode::inverse_time) return;
  text_.block("G94");
  feed_mode_ = FeedMode::per_minute;
  feed_.restate();
}

void FanucWriter::end_cycle() {
  text_.block("G80");
  cycle_state_ = CycleState::off;
  forget();
}

void FanucWriter::forget() {
  words_.restate_all();
  feed_.restate();
  motion_code_ = -1;
}

bool FanucWriter::done(std::optional<Problem> problem) {
  problem_ = std::move(problem);
  return !problem_;
}

bool FanucWriter::refuse(Problem problem) {
  problem_ = std::move(problem);
  return false;
}

}  // namespace pentapost::nc
