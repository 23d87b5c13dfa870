#include "pentapost/nc/readers/fanuc_program.hpp"

#include <string>

namespace pentapost::nc::readers::fanuc {
namespace {

/// Further off, the control raises an alarm or cuts a spiral (parameter 3410); rounded words of a
/// true arc, in steps of 0.0001 inch or finer, are off by less.
constexpr double largest_radius_mismatch_mm = 0.01;

}  // namespace

ReadMotion Program::started_motion(ReadMotion::Kind kind) const {
  ReadMotion motion;
  motion.kind = kind;
  motion.tcp = is_tcp();
  motion.tool_length_offset = modes_.length == 430;
  motion.work_offset = modes_.work_offset;
  if (modes_.length != 490) motion.length_register = modes_.length_register.value_or(0);
  return motion;
}

bool Program::target(std::size_t column, double& value) {
  const char letter = columns_.letter(column);
  if (!modes_.distance)
    return items_.fail(Code::not_in_dialect, std::string{letter} + " before G90 or G91");
  if (!(columns_.is_linear(column) ? length_of(letter, value) : angle_of(letter, value)))
    return false;
  if (modes_.distance == 900) return true;
  if ((columns_.known >> column & 1U) == 0)
    return items_.fail(Code::not_in_dialect,
                       std::string{letter} + " in G91 from a position that is not known");
  value += columns_.position[column];
  return true;
}

bool Program::fill_feed(ReadMotion& motion) {
  if (!modes_.feed_mode)
    return items_.fail(Code::no_feed, "a cutting motion before G93, G94 or G95");
  if (!modes_.feed)
    return items_.fail(Code::no_feed, modes_.feed_mode == 930 ? "a block in G93 needs its own F"
                                                              : "a cutting motion has no feed");
  motion.feed_mode =
      modes_.feed_mode == 930 ? ReadMotion::Feed::inverse_time : ReadMotion::Feed::per_minute;
  motion.feed = *modes_.feed;
  if (modes_.feed_is_inch && (motion.stated & columns_.linear()) != 0) motion.feed *= mm_per_inch;
  if (modes_.feed_mode != 950) return true;
  if (modes_.spindle.state == ReadSpindle::State::off || modes_.spindle.speed_rpm <= 0.0)
    return items_.fail(Code::no_feed, "a feed per revolution while the spindle stands");
  motion.feed *= modes_.spindle.speed_rpm;
  return true;
}

bool Program::move() {
  const bool is_arc = modes_.motion == 20 || modes_.motion == 30;
  const bool arc_words =
      is_arc && words_.any_left(letter_bit('I') | letter_bit('J') | letter_bit('R'));
  const std::uint8_t stated = words_.take_columns(columns_);
  if (stated == 0 && !arc_words) return true;
  if (!modes_.motion)
    return items_.fail(Code::not_in_dialect, "axis words before G0, G1, G2 or G3");
  ReadMotion motion = started_motion(modes_.motion == 0    ? ReadMotion::Kind::rapid
                                     : modes_.motion == 10 ? ReadMotion::Kind::line
                                                           : ReadMotion::Kind::arc);
  motion.stated = stated;
  motion.position = columns_.position;
  for (std::size_t column = 0; column < columns_.size(); ++column)
    if ((stated >> column & 1U) != 0 && !target(column, motion.position[column])) return false;
  motion.known = columns_.known | stated;
  if (modes_.motion != 0 && !fill_feed(motion)) return false;
  if (is_arc && !arc(motion)) return false;
  columns_.position = motion.position;
  columns_.known = motion.known;
  return items_.send(motion);
}

bool Program::arc(ReadMotion& motion) {
  if (modes_.plane != 170)
    return items_.fail(Code::not_in_dialect, "an arc outside of the plane G17");
  // There F is the feed over the radius, not over the length (operator's manual, G93).
  if (modes_.feed_mode == 930) return items_.fail(Code::not_in_dialect, "an arc in G93");
  motion.clockwise = modes_.motion == 20;
  ArcBlock arc_block{columns_, largest_radius_mismatch_mm, motion, items_};
  return arc_block.open() && arc_centre(arc_block);
}

bool Program::arc_centre(ArcBlock& arc_block) {
  if (words_.take('R')) {
    double radius = 0.0;
    if (words_.any_left(letter_bit('I') | letter_bit('J')))
      return items_.fail(Code::bad_arc, "an arc with both R and a centre");
    return length_of('R', radius) && arc_block.set_radius(radius);
  }
  // I and J count from the start point whatever G90 and G91 say; one left out is 0.
  double i = 0.0, j = 0.0;
  if (words_.take('I') && !length_of('I', i)) return false;
  if (words_.take('J') && !length_of('J', j)) return false;
  return arc_block.set_centre({arc_block.start().x + i, arc_block.start().y + j});
}

bool Program::machine_move() {
  const std::uint8_t stated = words_.take_columns(columns_);
  if (stated == 0) return true;
  if (is_tcp() && stated != columns_.bit_of('Z'))
    return items_.fail(Code::not_in_dialect, "G53 along other axes than Z while G43.4 is on");
  if (modes_.distance != 900) return items_.fail(Code::not_in_dialect, "G53 acts in G90 only");
  ReadMotion motion = started_motion(ReadMotion::Kind::rapid);
  motion.machine_frame = true;
  motion.stated = motion.known = stated;
  for (std::size_t column = 0; column < columns_.size(); ++column)
    if ((stated >> column & 1U) != 0 && !target(column, motion.position[column])) return false;
  forget_after_machine_move(stated);
  return items_.send(motion);
}

/// With G43.4 the linear words are the tip's, which any linear axis moves along all of them.
void Program::forget_after_machine_move(std::uint8_t stated) {
  columns_.forget(is_tcp() ? static_cast<std::uint8_t>(stated | columns_.linear()) : stated);
}

bool Program::reference_return() {
  const std::uint8_t stated = words_.take_columns(columns_);
  if (is_tcp() && stated != columns_.bit_of('Z'))
    return items_.fail(Code::not_in_dialect, "G28 along other axes than Z while G43.4 is on");
  if (stated == 0) return items_.fail(Code::not_in_dialect, "G28 without an axis");
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    // The way leads through the point stated: only the one where the axis is already is modelled.
    const char letter = columns_.letter(column);
    if ((stated >> column & 1U) != 0 && (modes_.distance != 910 || words_[letter] != 0.0))
      return items_.fail(Code::not_in_dialect,
                         std::string{"G28 is understood as G91 G28 "} + letter + "0 only");
  }
  const std::uint8_t z = columns_.bit_of('Z');
  forget_after_machine_move(stated);
  if (stated == z) return items_.send(ReadSafeRetract{});
  ReadMotion motion = started_motion(ReadMotion::Kind::rapid);
  motion.machine_frame = true;
  motion.stated = stated;
  return items_.send(motion);
}

}  // namespace pentapost::nc::readers::fanuc
