#include "pentapost/core/number_text.hpp"
#include "pentapost/nc/readers/heidenhain_program.hpp"

#include <cmath>
#include <string>

namespace pentapost::nc::readers::heidenhain {
namespace {

/// "The starting and end points of the arc must lie on the circle. Input tolerance: up to 0.016
/// mm."
constexpr double largest_radius_mismatch_mm = 0.016;

}  // namespace

bool Program::value_of(char letter, bool is_length, double& value) {
  value = words_[letter];
  if (is_length && is_inch_) value *= mm_per_inch;
  constexpr double largest = 99'999.9999;  // manual, technical information: (5, 4) places
  if (std::abs(value) <= largest) return true;
  return items_.fail(Code::bad_number,
                     std::string{letter} + number_text(value) + " is out of the control's range");
}

/// I and J: centre of arcs to come, absolute or (G91) from where the tool is before this block.
bool Program::set_pole() {
  struct Part {
    char letter, axis;
    std::optional<double>& pole_mm;
  };
  for (const auto& [letter, axis, pole_mm] :
       {Part{'I', 'X', modes_.pole_x_mm}, Part{'J', 'Y', modes_.pole_y_mm}}) {
    if (!words_.take(letter)) continue;
    double value = 0.0;
    if (!block_->distance)
      return items_.fail(Code::not_in_dialect, std::string{letter} + " before G90 or G91");
    if (!value_of(letter, true, value)) return false;
    if (is_relative(letter)) {
      if ((columns_.known & columns_.bit_of(axis)) == 0)
        return items_.fail(Code::bad_arc,
                           std::string{letter} + " in G91 from a position that is not known");
      value += columns_.position[columns_.column_of(axis)];
    }
    pole_mm = value;
  }
  return true;
}

bool Program::move() {
  const std::uint8_t stated = words_.take_columns(columns_);
  if (stated == 0) return true;
  if (!modes_.motion)
    return items_.fail(Code::not_in_dialect, "axis words before G00, G01, G02 or G03");
  ReadMotion motion;
  motion.kind = *modes_.motion == 0   ? ReadMotion::Kind::rapid
                : *modes_.motion == 1 ? ReadMotion::Kind::line
                                      : ReadMotion::Kind::arc;
  motion.stated = stated;
  motion.tcp = modes_.tcp;
  motion.tool_length_offset = modes_.tool != 0 && !modes_.tcp;
  motion.datum_shift = modes_.datum_shift;
  if (machine_datum_ != 0) return machine_move(stated, motion);
  motion.position = columns_.position;
  if (!targets(stated, motion)) return false;
  motion.known = columns_.known | stated;
  if (modes_.shortest_way && !turns_are_certain(motion)) return false;
  if (*modes_.motion != 0 && !fill_feed(motion)) return false;
  if (*modes_.motion >= 2 && !arc(motion)) return false;
  columns_.position = motion.position;
  columns_.known = motion.known;
  return items_.send(motion);
}

bool Program::targets(std::uint8_t stated, ReadMotion& motion) {
  if (!block_->distance) return items_.fail(Code::not_in_dialect, "axis words before G90 or G91");
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    if ((stated >> column & 1U) == 0) continue;
    const char letter = columns_.letter(column);
    double value = 0.0;
    if (!value_of(letter, columns_.is_linear(column), value)) return false;
    if (is_relative(letter)) {
      if ((columns_.known >> column & 1U) == 0 || machine_datum_ != 0)
        return items_.fail(Code::not_in_dialect,
                           std::string{letter} + " in G91 from a position that is not known");
      value += columns_.position[column];
    }
    motion.position[column] = value;
  }
  return true;
}

/// M91 and M92 hold for their block only. Where the datum of M92 lies, the machine builder says.
bool Program::machine_move(std::uint8_t stated, ReadMotion& motion) {
  if (modes_.tcp) return items_.fail(Code::not_in_dialect, "M91 or M92 while M128 is on");
  if (motion.kind == ReadMotion::Kind::arc)
    return items_.fail(Code::not_in_dialect, "an arc with M91 or M92");
  if (!targets(stated, motion)) return false;
  motion.machine_frame = true;
  motion.known = machine_datum_ == 91 ? stated : std::uint8_t{0};
  if (motion.kind != ReadMotion::Kind::rapid && !fill_feed(motion)) return false;
  columns_.forget(stated);
  return items_.send(motion);
}

/// With M126 a rotary axis may run the other way than its numbers say; below half a turn it does
/// not.
bool Program::turns_are_certain(const ReadMotion& motion) {
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    const auto bit = static_cast<std::uint8_t>(1U << column);
    if (columns_.is_linear(column) || (motion.stated & columns_.known & bit) == 0) continue;
    const double turn = motion.position[column] - columns_.position[column];
    if (std::abs(turn) >= 180.0)
      return items_.fail(Code::not_in_dialect, std::string{columns_.letter(column)} + " moves by " +
                                                   number_text(turn, 4) + " deg while M126 is on");
  }
  return true;
}

bool Program::fill_feed(ReadMotion& motion) {
  if (!modes_.feed) return items_.fail(Code::no_feed, "a cutting motion has no feed");
  // The unit of F in inch programs differs between controls of the family.
  if (is_inch_) return items_.fail(Code::not_in_dialect, "a feed in a program with G70");
  motion.feed_mode = ReadMotion::Feed::per_minute;
  motion.feed = *modes_.feed;
  return true;
}

bool Program::arc(ReadMotion& motion) {
  if (modes_.plane != 17)
    return items_.fail(Code::not_in_dialect, "an arc outside of the plane G17");
  motion.clockwise = modes_.motion == 2;
  ArcBlock arc_block{columns_, largest_radius_mismatch_mm, motion, items_};
  return arc_block.open() && arc_centre(arc_block);
}

bool Program::arc_centre(ArcBlock& arc_block) {
  if (words_.take('R')) {
    double radius = 0.0;
    return value_of('R', true, radius) && arc_block.set_radius(radius);
  }
  if (!modes_.pole_x_mm || !modes_.pole_y_mm)
    return items_.fail(Code::bad_arc, "an arc before its centre I, J");
  return arc_block.set_centre({*modes_.pole_x_mm, *modes_.pole_y_mm});
}

}  // namespace pentapost::nc::readers::heidenhain
