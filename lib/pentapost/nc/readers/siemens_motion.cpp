#include "pentapost/core/number_text.hpp"
#include "pentapost/nc/readers/siemens_program.hpp"

#include <cmath>
#include <string>

namespace pentapost::nc::readers::siemens {
namespace {

/// Further off, the control raises alarm 14040 (machine data 21000, CIRCLE_ERROR_CONST, 0.01 mm).
constexpr double largest_radius_mismatch_mm = 0.01;
/// Words of shops do not go beyond.
constexpr double largest_word = 999'999.999'9;
constexpr double most_turns = 999.0;  ///< Fundamentals, helical interpolation: TURN 0 to 999

}  // namespace

ReadMotion Program::started_motion(ReadMotion::Kind kind) const {
  ReadMotion motion;
  motion.kind = kind;
  motion.tcp = modes_.tcp;
  motion.tool_length_offset = !modes_.tcp && modes_.edge.adds_length();
  motion.work_offset = modes_.work_offset;
  return motion;
}

bool Program::has_arc_words() const {
  return words_.any_left(letter_bit('I') | letter_bit('J')) || block_->radius || block_->turns;
}

bool Program::value_of(char letter, bool is_length, double& value) {
  value = words_[letter];
  if (is_length) {
    if (!modes_.unit)
      return items_.fail(Code::not_in_dialect, std::string{letter} + " before G70 or G71");
    if (modes_.unit != Modes::Unit::metric) value *= mm_per_inch;
  }
  if (std::abs(value) <= largest_word) return true;
  return items_.fail(Code::bad_number,
                     std::string{letter} + number_text(value) + " is out of the control's range");
}

bool Program::target(std::size_t column, double& position) {
  const char letter = columns_.letter(column);
  const std::uint32_t bit = letter_bit(letter);
  double value = 0.0;
  if (!value_of(letter, columns_.is_linear(column), value)) return false;
  const bool is_absolute =
      ((block_->absolute | block_->shortest | block_->upward | block_->downward) & bit) != 0;
  const bool is_incremental = (block_->incremental & bit) != 0;
  if (!is_absolute && !is_incremental && !modes_.absolute)
    return items_.fail(Code::not_in_dialect, std::string{letter} + " before G90 or G91");
  if (is_absolute || (!is_incremental && *modes_.absolute)) {
    position = value;
    return true;
  }
  if ((columns_.known >> column & 1U) == 0)
    return items_.fail(Code::not_in_dialect,
                       std::string{letter} + " counts from a position that is not known");
  position = columns_.position[column] + value;
  return true;
}

/// DC, ACP and ACN lead to a position within one turn, by a way that its number does not tell. Of a
/// rapid the end alone counts; a cut has to go the way that the numbers say.
bool Program::rotary_way(std::size_t column, const ReadMotion& motion) {
  const std::uint32_t bit = letter_bit(columns_.letter(column));
  const std::string letter{columns_.letter(column)};
  if (!(motion.position[column] >= 0.0 && motion.position[column] < 360.0))
    return items_.fail(Code::bad_number, letter + " by DC, ACP or ACN is outside 0 to 360");
  if (!is_cutting()) return true;
  const double turn = motion.position[column] - columns_.position[column];
  const bool is_known = (columns_.known >> column & 1U) != 0;
  const bool is_plain = (block_->shortest & bit) != 0 ? std::abs(turn) < 180.0
                        : (block_->upward & bit) != 0 ? turn >= 0.0
                                                      : turn <= 0.0;
  return (is_known && is_plain) ||
         items_.fail(Code::not_in_dialect, letter + " crosses 0 by DC, ACP or ACN in a cut");
}

bool Program::take_targets(std::uint8_t stated, ReadMotion& motion) {
  const std::uint32_t ways = block_->shortest | block_->upward | block_->downward;
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    if ((stated >> column & 1U) == 0) continue;
    if (!target(column, motion.position[column])) return false;
    if ((ways & letter_bit(columns_.letter(column))) != 0 && !rotary_way(column, motion))
      return false;
  }
  return true;
}

/// The words of Z, with TRAORI all linear ones, mean nothing while the tool's length is not known.
bool Program::length_is_certain(std::uint8_t stated) {
  const Edge& edge = modes_.edge;
  if (modes_.tcp && edge.is_doubtful() && (stated & columns_.linear()) != 0)
    return items_.fail(Code::not_in_dialect, "TRAORI moves the tool without its length: no D");
  if (!modes_.tcp && edge.is_open && (stated & columns_.bit_of('Z')) != 0)
    return items_.fail(Code::not_in_dialect, "Z moves before a D behind the tool change");
  return true;
}

bool Program::move() {
  const bool is_arc = modes_.motion == 2 || modes_.motion == 3;
  const bool arc_words = is_arc && has_arc_words();
  const std::uint8_t stated = words_.take_columns(columns_);
  if (stated == 0 && !arc_words)
    return !(block_->radius || block_->turns) ||
           items_.fail(Code::not_in_dialect, "CR or TURN in a block without an arc");
  if (!modes_.motion)
    return items_.fail(Code::not_in_dialect, "axis words before G0, G1, G2 or G3");
  if (!is_arc && (block_->radius || block_->turns))
    return items_.fail(Code::not_in_dialect, "CR or TURN in a block without an arc");
  if (modes_.edge.is_doubtful() && !length_is_certain(stated)) return false;
  ReadMotion motion = started_motion(modes_.motion == 0   ? ReadMotion::Kind::rapid
                                     : modes_.motion == 1 ? ReadMotion::Kind::line
                                                          : ReadMotion::Kind::arc);
  motion.stated = stated;
  motion.position = columns_.position;
  if (!take_targets(stated, motion)) return false;
  motion.known = columns_.known | stated;
  if (is_cutting() && !fill_feed(motion)) return false;
  if (is_arc && !arc(motion)) return false;
  columns_.position = motion.position;
  columns_.known = motion.known;
  return items_.send(motion);
}

/// SUPA, G153 and G53 switch the shifts of the workpiece off for their block, not the tool's
/// length: with a D the position is the tip's.
bool Program::machine_move() {
  const std::uint8_t stated = words_.take_columns(columns_);
  if (stated == 0) return true;
  if (modes_.tcp)
    return items_.fail(Code::not_in_dialect, "a move to a machine position while TRAORI is on");
  if (modal_cycle_)
    return items_.fail(Code::not_in_dialect, "a move to a machine position in a modal cycle");
  if (!modes_.motion || *modes_.motion > 1)
    return items_.fail(Code::not_in_dialect, "a move to a machine position needs G0 or G1");
  if (modes_.absolute == false || block_->incremental != 0)
    return items_.fail(Code::not_in_dialect, "a move to a machine position is absolute");
  ReadMotion motion =
      started_motion(is_cutting() ? ReadMotion::Kind::line : ReadMotion::Kind::rapid);
  motion.machine_frame = true;
  motion.stated = motion.known = stated;
  if (!take_targets(stated, motion)) return false;
  if (modes_.edge.number != 0)
    motion.known = static_cast<std::uint8_t>(motion.known & ~columns_.bit_of('Z'));
  if (is_cutting() && !fill_feed(motion)) return false;
  columns_.forget(stated);
  return items_.send(motion);
}

bool Program::fill_feed(ReadMotion& motion) {
  if (!modes_.feed_mode)
    return items_.fail(Code::no_feed, "a cutting motion before G93, G94 or G95");
  if (!modes_.feed) return items_.fail(Code::no_feed, "a cutting motion has no feed");
  motion.feed = *modes_.feed;
  if (modes_.feed_mode == 93) {
    if (!words_->has('F')) return items_.fail(Code::no_feed, "a block in G93 needs its own F");
    motion.feed_mode = ReadMotion::Feed::inverse_time;
    return true;
  }
  motion.feed_mode = ReadMotion::Feed::per_minute;
  if (modes_.feed_is_inch && (motion.stated & columns_.linear()) != 0) motion.feed *= mm_per_inch;
  if (modes_.feed_mode != 95) return true;
  if (modes_.spindle.state == ReadSpindle::State::off || modes_.spindle.speed_rpm <= 0.0)
    return items_.fail(Code::no_feed, "a feed per revolution while the spindle stands");
  motion.feed *= modes_.spindle.speed_rpm;
  return true;
}

bool Program::arc(ReadMotion& motion) {
  if (modes_.plane != 17)
    return items_.fail(Code::not_in_dialect, "an arc outside of the plane G17");
  motion.clockwise = modes_.motion == 2;
  ArcBlock arc_block{columns_, largest_radius_mismatch_mm, motion, items_};
  if (!arc_block.open() || !arc_centre(arc_block)) return false;
  if (!block_->turns) return true;
  const double turns = *block_->turns;
  if (!(turns >= 0.0 && turns <= most_turns) || turns != std::floor(turns))
    return items_.fail(Code::bad_arc, "TURN=" + number_text(turns) + " is no number of turns");
  // Additional passes of the full circle, Fundamentals, helical interpolation.
  motion.whole_turns += static_cast<int>(turns);
  return true;
}

bool Program::arc_centre(ArcBlock& arc_block) {
  if (block_->radius) {
    if (words_.any_left(letter_bit('I') | letter_bit('J')))
      return items_.fail(Code::bad_arc, "an arc with both CR and a centre");
    const bool is_inch = modes_.unit != Modes::Unit::metric;
    return arc_block.set_radius(*block_->radius * (is_inch ? mm_per_inch : 1.0));
  }
  PlanePoint centre;
  return centre_part('I', arc_block.start().x, centre.x) &&
         centre_part('J', arc_block.start().y, centre.y) && arc_block.set_centre(centre);
}

/// I and J count from the start point whatever G90 and G91 say, but for AC(); one left out is 0.
bool Program::centre_part(char letter, double start_mm, double& part_mm) {
  part_mm = start_mm;
  if (!words_.take(letter)) return true;
  double value = 0.0;
  if (!value_of(letter, true, value)) return false;
  part_mm = (block_->absolute & letter_bit(letter)) != 0 ? value : start_mm + value;
  return true;
}

}  // namespace pentapost::nc::readers::siemens
