#include "pentapost/core/number_text.hpp"
#include "pentapost/nc/dialects/heidenhain_klartext_writer.hpp"
#include "pentapost/nc/refusals.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

// Q parameters and their order: TNC 640 and iTNC 530 user's manuals cycle programming, fixed
// cycles: drilling, tapping. Only those are written that both controls have.
namespace pentapost::nc {
namespace {

using Kind = path::CycleStart::Kind;

constexpr double longest_dwell_s = 3600.0;
constexpr int pitch_decimals = 4;
constexpr std::int64_t largest_pitch = 999'999;  ///< 99.9999 mm
constexpr int option_decimals = 4;
constexpr std::int64_t most_breaks = 99'999;

std::string number(std::int64_t count, int decimals) {
  std::string text;
  append_decimal(text, count, decimals, {.plus_sign = true});
  return text;
}

bool is_tapping(Kind kind) { return kind == Kind::tap || kind == Kind::tap_left; }

}  // namespace

bool KlartextWriter::act(const path::NativeCycle& cycle, std::uint32_t) {
  if (!(cycle.feed_mm_min > 0.0))
    throw std::logic_error{"heidenhain: a cycle without feed"};
  if (!cycle.retract_to_clearance)
    throw std::logic_error{"heidenhain: a cycle without a retraction level"};
  end_cycle();
  cycle_ = cycle;
  cycle_state_ = CycleState::ordered;
  return true;
}

bool KlartextWriter::act(const path::NativeCycleEnd&, std::uint32_t) {
  end_cycle();
  return true;
}

/// "At the end of the cycle the spindle comes to a stop" (cycle 207, programming notes).
void KlartextWriter::end_cycle() {
  if (cycle_state_ == CycleState::written && is_tapping(cycle_.kind)) restart_spindle();
  cycle_state_ = CycleState::off;
}

/// M99 drills behind the block, which goes across at the level where the tool is.
bool KlartextWriter::write_hole(const path::Block& block) {
  const std::size_t none = WordColumns::none;
  const std::size_t z = words_.z();
  if (cycle_state_ == CycleState::off || words_.x() == none || words_.y() == none || z == none)
    throw std::logic_error{"heidenhain: a hole without a cycle or without X, Y, Z"};
  start_smoothing(block);
  const bool is_new = cycle_state_ == CycleState::ordered || block.word[z] != cycle_.bottom_z;
  cycle_.bottom_z = block.word[z];
  if (is_new && !write_cycle(block.cl_line)) return false;
  cycle_state_ = CycleState::written;
  const auto words =
      static_cast<std::uint8_t>((words_of(block) | bit(words_.x()) | bit(words_.y())) & ~bit(z));
  std::string& out = text_.begin_block();
  out += "L ";
  words_.append(out, block, words);
  out += "R0 FMAX M99 ";
  text_.end_block();
  compensation_is_off_ = true;
  behind_helix_.reset();
  words_.place(block);
  words_.lose(z);
  return true;
}

bool KlartextWriter::write_cycle(std::uint32_t cl_line) {
  if (!cycle_fits())
    return refuse(
        refusal(Code::out_of_domain, "a number of the cycle has too many digits", cl_line));
  if (cycle_.bottom_z >= cycle_.clearance_z - cycle_.clearance)
    return refuse(
        refusal(Code::out_of_domain, "the depth of the hole is 0 in the last digit", cl_line));
  const bool pecks = cycle_.peck > 0;
  switch (cycle_.kind) {
    case Kind::deep:
      return pecks ? pecking(cl_line) : drilling(cl_line);
    case Kind::break_chip:
      return pecks ? chip_breaking(cl_line) : drilling(cl_line);
    case Kind::drill:
    case Kind::face:
      return drilling(cl_line);
    case Kind::tap:
    case Kind::tap_left:
      return tapping(cl_line);
    case Kind::bore:
    case Kind::ream:
      return reaming(cl_line);
    case Kind::bore_drag:
      return boring(cl_line);
  }
  throw std::logic_error{"heidenhain: no such cycle"};
}

bool KlartextWriter::cycle_fits() const {
  const WordColumns& columns = words_.columns();
  const std::size_t z = words_.z();
  return columns.fits(z, cycle_.clearance_z) && columns.fits(z, cycle_.peck) &&
         columns.fits(z, cycle_.clearance) &&
         columns.fits(z, cycle_.clearance_z - cycle_.clearance) &&
         columns.fits(z, cycle_.clearance_z - cycle_.clearance - cycle_.bottom_z) &&
         cycle_.dwell_s >= 0.0 && cycle_.dwell_s <= longest_dwell_s;
}

std::string KlartextWriter::length(std::int64_t count) const {
  return number(count, words_.columns().decimals(words_.z()));
}

KlartextWriter::Parameters KlartextWriter::levels() const {
  return {{200, length(cycle_.clearance), "SET-UP CLEARANCE"},
          {201, length(cycle_.bottom_z - cycle_.clearance_z + cycle_.clearance), "DEPTH"}};
}

KlartextWriter::Parameter KlartextWriter::surface() const {
  return {203, length(cycle_.clearance_z - cycle_.clearance), "SURFACE COORDINATE"};
}

/// The tool stays at the set-up clearance.
KlartextWriter::Parameter KlartextWriter::second_clearance() const {
  return {204, length(cycle_.clearance), "2ND SET-UP CLEARANCE"};
}

KlartextWriter::Parameter KlartextWriter::dwell_at_depth() const {
  return {211, number(*nearest_count(cycle_.dwell_s, 3), 3), "DWELL TIME AT DEPTH"};
}

bool KlartextWriter::feed_parameter(Parameters& parameters, std::uint32_t cl_line) {
  const int decimals = settings_.common.feed_decimals;
  const auto feed = feed_count(cycle_.feed_mm_min, decimals);
  if (!feed) return refuse(unwritable("F", cycle_.feed_mm_min, "mm/min", cl_line));
  parameters.push_back({206, number(*feed, decimals), "FEED RATE FOR PLNGNG"});
  return true;
}

/// In one movement: the plunging depth is the whole depth.
bool KlartextWriter::drilling(std::uint32_t cl_line) {
  Parameters all = levels();
  if (!feed_parameter(all, cl_line)) return false;
  const std::int64_t depth = cycle_.clearance_z - cycle_.clearance - cycle_.bottom_z;
  all.insert(all.end(), {{202, length(depth), "PLUNGING DEPTH"},
                         {210, "+0", "DWELL TIME AT TOP"},
                         surface(),
                         second_clearance(),
                         dwell_at_depth()});
  define("200 DRILLING", std::move(all), true);
  return true;
}

/// As many breaks as there are infeeds keep the tool in the hole.
bool KlartextWriter::chip_breaking(std::uint32_t cl_line) {
  Parameters all = levels();
  if (!feed_parameter(all, cl_line)) return false;
  const std::int64_t depth = cycle_.clearance_z - cycle_.clearance - cycle_.bottom_z;
  const std::int64_t breaks = std::min(depth / cycle_.peck + 1, most_breaks);
  const std::int64_t back = decimal_count(settings_.chip_break_mm, option_decimals);
  const std::int64_t retraction = decimal_count(settings_.retraction_feed_mm_min, 3);
  all.insert(all.end(), {{202, length(cycle_.peck), "PLUNGING DEPTH"},
                         {210, "+0", "DWELL TIME AT TOP"},
                         surface(),
                         second_clearance(),
                         {212, "+0", "DECREMENT"},
                         {213, number(breaks, 0), "NR OF BREAKS"},
                         {205, "+0", "MIN. PLUNGING DEPTH"},
                         dwell_at_depth(),
                         {208, number(retraction, 3), "RETRACTION FEED RATE"},
                         {256, number(back, option_decimals), "DIST FOR CHIP BRKNG"}});
  define("203 UNIVERSAL DRILLING", std::move(all), true);
  return true;
}

bool KlartextWriter::pecking(std::uint32_t cl_line) {
  Parameters all = levels();
  if (!feed_parameter(all, cl_line)) return false;
  const std::string stop =
      number(decimal_count(settings_.advanced_stop_mm, option_decimals), option_decimals);
  const std::string back =
      number(decimal_count(settings_.chip_break_mm, option_decimals), option_decimals);
  all.insert(all.end(), {{202, length(cycle_.peck), "PLUNGING DEPTH"},
                         surface(),
                         second_clearance(),
                         {212, "+0", "DECREMENT"},
                         {205, "+0", "MIN. PLUNGING DEPTH"},
                         {258, stop, "UPPER ADV STOP DIST"},
                         {259, stop, "LOWER ADV STOP DIST"},
                         {257, "+0", "DEPTH FOR CHIP BRKNG"},
                         {256, back, "DIST FOR CHIP BRKNG"},
                         dwell_at_depth(),
                         {379, "+0", "STARTING POINT"},
                         {253, "+750", "F PRE-POSITIONING"}});
  define("205 UNIVERSAL PECKING", std::move(all), true);
  return true;
}

/// Out at the feed of the way in.
bool KlartextWriter::reaming(std::uint32_t cl_line) {
  Parameters all = levels();
  if (!feed_parameter(all, cl_line)) return false;
  const std::string feed = all.back().value;
  all.insert(
      all.end(),
      {dwell_at_depth(), {208, feed, "RETRACTION FEED RATE"}, surface(), second_clearance()});
  define("201 REAMING", std::move(all), false);
  return true;
}

/// Out with the spindle stopped; the tool does not leave the wall.
bool KlartextWriter::boring(std::uint32_t cl_line) {
  Parameters all = levels();
  if (!feed_parameter(all, cl_line)) return false;
  const std::string feed = all.back().value;
  all.insert(all.end(), {dwell_at_depth(),
                         {208, feed, "RETRACTION FEED RATE"},
                         surface(),
                         second_clearance(),
                         {214, "+0", "DISENGAGING DIRECTN"},
                         {336, "+0", "ANGLE OF SPINDLE"}});
  define("202 BORING", std::move(all), false);
  return true;
}

/// The thread is its pitch: the cycle couples spindle and Z by Q239, whose sign is its hand.
bool KlartextWriter::tapping(std::uint32_t cl_line) {
  Parameters all = levels();
  all.back().name = "DEPTH OF THREAD";
  if (!pitch_parameter(all, cl_line)) return false;
  all.insert(all.end(), {surface(), second_clearance()});
  define("207 RIGID TAPPING NEW", std::move(all), false);
  return true;
}

bool KlartextWriter::pitch_parameter(Parameters& parameters, std::uint32_t cl_line) {
  if (!spindle_.speed_rpm || !(*spindle_.speed_rpm > 0.0))
    return refuse(refusal(Code::out_of_domain, "the pitch of a tap needs a spindle speed before it",
                          cl_line));
  const double pitch_mm = cycle_.feed_mm_min / *spindle_.speed_rpm;
  const auto pitch = nearest_count(pitch_mm, pitch_decimals);
  if (!pitch || *pitch == 0 || *pitch > largest_pitch)
    return refuse(unwritable("pitch", pitch_mm, "mm", cl_line));
  const std::int64_t hand = cycle_.kind == Kind::tap_left ? -1 : 1;
  parameters.push_back({239, number(hand * *pitch, pitch_decimals), "THREAD PITCH"});
  return true;
}

/// One block over several lines, each but the last with ~ at its end.
void KlartextWriter::define(std::string_view head, Parameters parameters,
                            bool has_depth_reference) {
  if (has_depth_reference && settings_.depth_reference)
    parameters.push_back({395, "+0", "DEPTH REFERENCE"});
  text_.block(std::string{"CYCL DEF "}.append(head) + " ~");
  for (const Parameter& parameter : parameters) {
    std::string line = "    Q" + std::to_string(parameter.number) + "=" + parameter.value + " ;";
    line += parameter.name;
    if (&parameter != &parameters.back()) line += " ~";
    text_.line(line);
  }
}

}  // namespace pentapost::nc
