#include "pentapost/core/number_text.hpp"
#include "pentapost/nc/dialects/siemens_840d_writer.hpp"
#include "pentapost/nc/refusals.hpp"

#include <stdexcept>

// Cycles and their parameters: SINUMERIK 840D Programming Guide Cycles (PGZ) 11.02, 2.1 Drilling
// cycles; 840D sl, Job planning, Programming cycles externally.
namespace pentapost::nc {
namespace {

using Kind = path::CycleStart::Kind;

constexpr double longest_dwell_s = 99'999.999;
/// Six decimals hold every pitch, inch threads too.
constexpr int pitch_decimals = 6;
constexpr int speed_decimals = 3;

std::string number(std::int64_t count, int decimals) {
  std::string text;
  append_decimal(text, count, decimals, {});
  return text;
}

}  // namespace

bool SiemensWriter::act(const path::NativeCycle& cycle, std::uint32_t) {
  if (!(cycle.feed_mm_min > 0.0)) throw std::logic_error{"SiemensWriter: a cycle without feed"};
  if (!cycle.retract_to_clearance)
    throw std::logic_error{"SiemensWriter: a cycle without a retraction plane"};
  leave_inverse_time();
  if (cycle_state_ == CycleState::written) end_cycle();
  cycle_ = cycle;
  cycle_state_ = CycleState::ordered;
  return true;
}

bool SiemensWriter::act(const path::NativeCycleEnd&, std::uint32_t) {
  if (cycle_state_ == CycleState::written) end_cycle();
  cycle_state_ = CycleState::off;
  return true;
}

/// MCALL drills behind every block that moves; the block itself goes across at the level where the
/// tool is.
bool SiemensWriter::write_hole(const path::Block& block) {
  const std::size_t none = WordColumns::none;
  const std::size_t z = words_.z();
  if (cycle_state_ == CycleState::off || words_.x() == none || words_.y() == none || z == none)
    throw std::logic_error{"SiemensWriter: a hole without a cycle or without X, Y, Z"};
  start_smoothing(block);
  if (block.word[z] != cycle_.bottom_z && cycle_state_ == CycleState::written) end_cycle();
  cycle_.bottom_z = block.word[z];
  if (cycle_state_ != CycleState::written && !write_cycle(block.cl_line)) return false;
  std::uint8_t words = settings_.modal_words ? std::uint8_t{0} : block.stated;
  for (const std::size_t column : words_.columns())
    if (words_.moves(block, column)) words |= bit(column);
  words = static_cast<std::uint8_t>((words | bit(words_.x()) | bit(words_.y())) & ~bit(z));
  std::string& out = text_.begin_block();
  write_motion_code(out, 0);
  words_.append(out, block, words);
  approach(out, block);
  text_.end_block();
  words_.place(block);
  words_.lose(z);
  return true;
}

bool SiemensWriter::write_cycle(std::uint32_t cl_line) {
  std::string call = "MCALL ";
  if (!cycle_call(call, cl_line)) return false;
  const bool has_own_feed = cycle_.kind == Kind::tap || cycle_.kind == Kind::tap_left ||
                            cycle_.kind == Kind::bore || cycle_.kind == Kind::ream;
  if (!has_own_feed) {
    feed_.restate();
    std::string& out = text_.begin_block();
    if (feed_mode_ == FeedMode::unknown) write_mode(out, path::Block::Feed::per_minute);
    if (!write_feed(out, path::Block::Feed::per_minute, cycle_.feed_mm_min, cl_line)) return false;
    text_.end_block();
  }
  text_.block(call);
  cycle_state_ = CycleState::written;
  return true;
}

bool SiemensWriter::cycle_call(std::string& call, std::uint32_t cl_line) {
  const WordColumns& columns = words_.columns();
  const std::size_t z = words_.z();
  if (!columns.fits(z, cycle_.clearance_z) || !columns.fits(z, cycle_.peck) ||
      !columns.fits(z, cycle_.clearance) ||
      !(cycle_.dwell_s >= 0.0 && cycle_.dwell_s <= longest_dwell_s))
    return refuse(
        refusal(Code::out_of_domain, "a number of the cycle has too many digits", cl_line));
  const std::string dwell = number(*nearest_count(cycle_.dwell_s, 3), 3);
  const bool pecks = cycle_.peck > 0;
  switch (cycle_.kind) {
    case Kind::deep:
    case Kind::break_chip:
      if (pecks) {
        // FDPR is the first depth below the reference plane, DAM 0 keeps it for all.
        call += "CYCLE83(" + levels() + ",,," + length(cycle_.peck) + ",0,0,0,1,";
        call += cycle_.kind == Kind::deep ? "1)" : "0)";
        return true;
      }
      [[fallthrough]];
    case Kind::drill:
    case Kind::face:
      call += cycle_.dwell_s > 0.0 ? "CYCLE82(" + levels() + ",," + dwell + ")"
                                   : "CYCLE81(" + levels() + ")";
      return true;
    case Kind::tap:
    case Kind::tap_left:
      return tapping_call(call, cl_line);
    case Kind::bore:
    case Kind::ream: {
      const auto feed = feed_count(cycle_.feed_mm_min, settings_.common.feed_decimals);
      if (!feed) return refuse(unwritable("F", cycle_.feed_mm_min, "mm/min", cl_line));
      const std::string word = number(*feed, settings_.common.feed_decimals);
      call += "CYCLE85(" + levels() + ",," + dwell + "," + word + "," + word + ")";
      return true;
    }
    case Kind::bore_drag:
      // Without a lift-off in RPA, RPO and RPAP the tool leaves along its axis.
      call +=
          "CYCLE86(" + levels() + ",," + dwell + "," + std::to_string(spindle_code()) + ",0,0,0,0)";
      return true;
  }
  throw std::logic_error{"SiemensWriter: no such cycle"};
}

/// The thread is its pitch: the cycle couples spindle and Z by PIT, whose sign is its hand.
bool SiemensWriter::tapping_call(std::string& call, std::uint32_t cl_line) {
  const auto speed =
      spindle_.speed_rpm ? nearest_count(*spindle_.speed_rpm, speed_decimals) : std::nullopt;
  if (!speed || *speed == 0)
    return refuse(refusal(Code::out_of_domain, "the pitch of a tap needs a spindle speed before it",
                          cl_line));
  const double pitch_mm = cycle_.feed_mm_min / *spindle_.speed_rpm;
  const auto pitch = nearest_count(pitch_mm, pitch_decimals);
  if (!pitch || *pitch == 0) return refuse(unwritable("pitch", pitch_mm, "mm", cl_line));
  const std::string speed_text = number(*speed, speed_decimals);
  call += "CYCLE84(" + levels() + ",," + number(*nearest_count(cycle_.dwell_s, 3), 3) + "," +
          std::to_string(spindle_code()) + ",," +
          number(cycle_.kind == Kind::tap_left ? -*pitch : *pitch, pitch_decimals) + ",0," +
          speed_text + "," + speed_text + ")";
  return true;
}

/// RTP, RFP, SDIS and DP: retraction plane, reference plane, safety distance, depth.
std::string SiemensWriter::levels() const {
  return length(cycle_.clearance_z) + "," + length(cycle_.clearance_z - cycle_.clearance) + "," +
         length(cycle_.clearance) + "," + length(cycle_.bottom_z);
}

std::string SiemensWriter::length(std::int64_t count) const {
  return number(count, words_.columns().decimals(words_.z()));
}

/// 3 or 4: the spindle turns so behind the cycle.
int SiemensWriter::spindle_code() const {
  return spindle_.state == path::Spindle::State::counterclockwise ? 4 : 3;
}

void SiemensWriter::end_cycle() {
  text_.block("MCALL");
  // CYCLE86 leaves the spindle where it stopped at the bottom.
  if (cycle_.kind == Kind::bore_drag && spindle_.state != path::Spindle::State::off)
    text_.block("M" + std::to_string(spindle_code()));
  cycle_state_ = CycleState::ordered;
  forget();
}

}  // namespace pentapost::nc
