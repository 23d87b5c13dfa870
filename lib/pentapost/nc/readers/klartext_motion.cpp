#include "pentapost/core/number_text.hpp"
#include "pentapost/core/units.hpp"
#include "pentapost/nc/readers/klartext_program.hpp"

#include <algorithm>
#include <cmath>

// User's manuals conversational programming, path functions.
namespace pentapost::nc::readers::klartext {
namespace {

using Kind = Block::Kind;

/// "Input tolerance: up to 0.016 mm": by so much start and end of an arc may differ in their
/// distance from the centre.
constexpr double largest_radius_mismatch_mm = 0.016;
constexpr double largest_coordinate = 99'999.9999;
constexpr double full_turn_deg = 360.0;

PlanePoint turned(PlanePoint point, PlanePoint centre, double angle_deg) {
  const double cosine = std::cos(angle_deg * rad_per_deg);
  const double sine = std::sin(angle_deg * rad_per_deg);
  const double x = point.x - centre.x;
  const double y = point.y - centre.y;
  return {centre.x + x * cosine - y * sine, centre.y + x * sine + y * cosine};
}

}  // namespace

bool Program::value_of(char letter, bool is_length, double& value) {
  value = words_[letter];
  if (is_length && is_inch_) value *= mm_per_inch;
  return in_range(value, std::string_view{&letter, 1});
}

bool Program::in_range(double value, std::string_view name) {
  if (std::abs(value) <= largest_coordinate) return true;
  return items_.fail(Code::bad_number,
                     std::string{name} + number_text(value) + " is out of the control's range");
}

/// CC X Y; without coordinates the pole is where the tool is.
bool Program::set_pole() {
  const auto plane = static_cast<std::uint8_t>(columns_.bit_of('X') | columns_.bit_of('Y'));
  if (columns_.bit_of('X') == 0 || columns_.bit_of('Y') == 0)
    return items_.fail(Code::bad_arc, "CC on a machine without X and Y");
  const bool has_x = words_.take('X');
  const bool has_y = words_.take('Y');
  if (has_x != has_y)
    return items_.fail(Code::bad_arc, "CC is understood with X and Y or with neither");
  const bool from_here = !has_x || is_relative('X') || is_relative('Y');
  if (from_here && (columns_.known & plane) != plane)
    return items_.fail(Code::bad_arc, "CC from a position that is not known");
  PlanePoint pole{columns_.position[columns_.column_of('X')],
                  columns_.position[columns_.column_of('Y')]};
  if (has_x) {
    double x = 0.0;
    double y = 0.0;
    if (!value_of('X', true, x) || !value_of('Y', true, y)) return false;
    pole.x = is_relative('X') ? pole.x + x : x;
    pole.y = is_relative('Y') ? pole.y + y : y;
  }
  modes_.pole = pole;
  return true;
}

ReadMotion Program::started_motion(std::uint8_t stated) const {
  ReadMotion motion;
  motion.stated = stated;
  motion.tcp = modes_.tcp;
  motion.tool_length_offset = modes_.tool != 0 && !modes_.tcp;
  motion.datum_shift = modes_.datum_shift;
  motion.work_offset = modes_.preset;
  motion.position = columns_.position;
  motion.known = columns_.known;
  return motion;
}

bool Program::move() {
  std::uint8_t stated = words_.take_columns(columns_);
  const bool is_arc = block_->kind == Kind::circle || block_->kind == Kind::circle_by_radius ||
                      block_->kind == Kind::polar_circle;
  const bool is_polar = block_->kind == Kind::polar_line || block_->kind == Kind::polar_circle;
  if (stated == 0 && !is_polar) {
    if (is_arc) return items_.fail(Code::bad_arc, "an arc without an end point");
    return !calls_cycle_ || call_cycle(0, started_motion(0));
  }
  ReadMotion motion = started_motion(stated);
  const bool is_rapid = block_->feed == Block::Feed::rapid;
  motion.kind = is_arc     ? ReadMotion::Kind::arc
                : is_rapid ? ReadMotion::Kind::rapid
                           : ReadMotion::Kind::line;
  if (machine_datum_ != 0) return machine_move(stated, motion);
  if (!targets(stated, motion)) return false;
  if (is_polar) {
    const auto plane = static_cast<std::uint8_t>(columns_.bit_of('X') | columns_.bit_of('Y'));
    if ((stated & plane) != 0)
      return items_.fail(Code::not_in_dialect, "X or Y beside polar coordinates");
    stated = static_cast<std::uint8_t>(stated | plane);
    if (block_->kind == Kind::polar_line && !polar_target(motion)) return false;
  }
  motion.stated = stated;
  motion.known = static_cast<std::uint8_t>(columns_.known | stated);
  if (modes_.shortest_way && !turns_are_certain(motion)) return false;
  const bool hole_is_in_block =
      calls_cycle_ && is_rapid && !is_arc && (stated & columns_.bit_of('Z')) == 0;
  if (hole_is_in_block) return call_cycle(stated, motion);
  if (motion.kind != ReadMotion::Kind::rapid && !fill_feed(motion)) return false;
  if (is_arc && !arc(motion)) return false;
  columns_.position = motion.position;
  columns_.known = motion.known;
  return send_motion(motion) && (!calls_cycle_ || call_cycle(0, started_motion(0)));
}

bool Program::targets(std::uint8_t stated, ReadMotion& motion) {
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    if ((stated >> column & 1U) == 0) continue;
    const char letter = columns_.letter(column);
    double value = 0.0;
    if (!value_of(letter, columns_.is_linear(column), value)) return false;
    if (is_relative(letter)) {
      if ((columns_.known >> column & 1U) == 0 || machine_datum_ != 0)
        return items_.fail(Code::not_in_dialect,
                           std::string{"I"} + letter + " from a position that is not known");
      value += columns_.position[column];
    }
    motion.position[column] = value;
  }
  return true;
}

bool Program::polar_target(ReadMotion& motion) {
  if (!modes_.pole) return items_.fail(Code::bad_arc, "polar coordinates before a pole CC");
  if (!block_->polar_radius || !block_->polar_angle_deg || block_->polar_angle_is_relative)
    return items_.fail(Code::not_in_dialect, "LP is understood with PR and PA");
  const double radius_mm = *block_->polar_radius * (is_inch_ ? mm_per_inch : 1.0);
  if (!in_range(radius_mm, "PR") || !in_range(*block_->polar_angle_deg, "PA")) return false;
  const PlanePoint end =
      turned({modes_.pole->x + radius_mm, modes_.pole->y}, *modes_.pole, *block_->polar_angle_deg);
  motion.position[columns_.column_of('X')] = end.x;
  motion.position[columns_.column_of('Y')] = end.y;
  return true;
}

/// M91 and M92 hold for their block only. Where the datum of M92 lies, the machine builder says.
bool Program::machine_move(std::uint8_t stated, ReadMotion& motion) {
  if (modes_.tcp) return items_.fail(Code::not_in_dialect, "M91 or M92 while M128 is on");
  if (block_->kind != Kind::line || calls_cycle_)
    return items_.fail(Code::not_in_dialect, "M91 or M92 in a block that is no straight line L");
  if (!targets(stated, motion)) return false;
  motion.machine_frame = true;
  motion.known = machine_datum_ == 91 ? stated : std::uint8_t{0};
  if (motion.kind != ReadMotion::Kind::rapid && !fill_feed(motion)) return false;
  columns_.forget(stated);
  return send_motion(motion);
}

/// With M126 a rotary axis may run the other way than its numbers say; below half a turn it does
/// not.
bool Program::turns_are_certain(const ReadMotion& motion) {
  constexpr double half_turn_deg = 180.0;
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    const auto bit = static_cast<std::uint8_t>(1U << column);
    if (columns_.is_linear(column) || (motion.stated & columns_.known & bit) == 0) continue;
    const double turn_deg = motion.position[column] - columns_.position[column];
    if (std::abs(turn_deg) >= half_turn_deg)
      return items_.fail(Code::not_in_dialect, std::string{columns_.letter(column)} + " moves by " +
                                                   number_text(turn_deg, 4) +
                                                   " deg while M126 is on");
  }
  return true;
}

bool Program::fill_feed(ReadMotion& motion) {
  if (block_->feed == Block::Feed::rapid)
    return items_.fail(Code::not_in_dialect, "an arc with FMAX");
  if (!modes_.feed) return items_.fail(Code::no_feed, "a cutting motion has no feed");
  // The unit of F in inch programs differs between controls of the family.
  if (is_inch_) return items_.fail(Code::not_in_dialect, "a feed in a program in INCH");
  motion.feed_mode = ReadMotion::Feed::per_minute;
  motion.feed = *modes_.feed;
  if (!modes_.feed_per_revolution) return true;
  const bool turns = modes_.spindle.state != ReadSpindle::State::off;
  motion.feed *= turns ? modes_.spindle.speed_rpm : 0.0;
  if (motion.feed > 0.0) return true;
  return items_.fail(Code::no_feed, "a feed per revolution while the spindle does not turn");
}

bool Program::arc(ReadMotion& motion) {
  if (!modes_.tool_axis_is_z)
    return items_.fail(Code::not_in_dialect, "an arc before TOOL CALL with the tool axis Z");
  if (block_->turning == Block::Turning::unsaid)
    return items_.fail(Code::bad_arc, "an arc without DR");
  motion.clockwise = block_->turning == Block::Turning::clockwise;
  if (block_->kind == Kind::circle_by_radius) return circle_by_radius(motion);
  if (!modes_.pole) return items_.fail(Code::bad_arc, "an arc before its centre CC");
  return block_->kind == Kind::circle ? circle(motion) : polar_circle(motion);
}

bool Program::circle(ReadMotion& motion) {
  ArcBlock arc_block{columns_, largest_radius_mismatch_mm, motion, items_};
  return arc_block.open() && arc_block.set_centre(*modes_.pole);
}

bool Program::circle_by_radius(ReadMotion& motion) {
  ArcBlock arc_block{columns_, largest_radius_mismatch_mm, motion, items_};
  if (!words_.take('R')) return items_.fail(Code::bad_arc, "CR without a radius");
  double radius_mm = 0.0;
  return value_of('R', true, radius_mm) && arc_block.open() && arc_block.set_radius(radius_mm);
}

/// CP PA: to this angle about the pole. CP IPA: by this angle, whole turns included; its sign is
/// that of DR.
bool Program::polar_circle(ReadMotion& motion) {
  if (!block_->polar_angle_deg || block_->polar_radius)
    return items_.fail(Code::bad_arc, "CP is understood with PA or IPA alone");
  ArcBlock arc_block{columns_, largest_radius_mismatch_mm, motion, items_};
  if (!arc_block.open()) return false;
  const PlanePoint start = arc_block.start();
  const PlanePoint pole = *modes_.pole;
  const double angle_deg = *block_->polar_angle_deg;
  double sweep_deg = angle_deg;
  if (block_->polar_angle_is_relative) {
    constexpr double largest_sweep_deg = 99'999.9999;
    if (angle_deg == 0.0 || (angle_deg < 0.0) != motion.clockwise ||
        std::abs(angle_deg) > largest_sweep_deg)
      return items_.fail(Code::bad_arc, "IPA" + number_text(angle_deg) + " is not in line with DR");
  } else {
    if (std::abs(angle_deg) > full_turn_deg)
      return items_.fail(Code::bad_arc, "PA" + number_text(angle_deg) + " is beyond a turn");
    sweep_deg = angle_deg - std::atan2(start.y - pole.y, start.x - pole.x) * deg_per_rad;
  }
  const double way_deg = std::remainder(sweep_deg, full_turn_deg);
  const PlanePoint end = way_deg == 0.0 ? start : turned(start, pole, way_deg);
  motion.position[columns_.column_of('X')] = end.x;
  motion.position[columns_.column_of('Y')] = end.y;
  if (!arc_block.open() || !arc_block.set_centre(pole)) return false;
  if (block_->polar_angle_is_relative)
    motion.whole_turns = static_cast<int>(std::abs(angle_deg) / full_turn_deg);
  return true;
}

/// Sends a motion that is no hole.
bool Program::send_motion(const ReadMotion& motion) {
  if (modes_.spindle_was_coupled && !stop_spindle()) return false;
  modes_.before_tcp_ended.reset();
  return items_.send(motion);
}

/// The control goes across at the level where the tool is, then along Z to the set-up clearance, up
/// or down ("Working with fixed cycles").
/// @param motion  to the hole, without its levels.
bool Program::call_cycle(std::uint8_t stated, ReadMotion motion) {
  const std::uint8_t z = columns_.bit_of('Z');
  if (!modes_.cycle) return items_.fail(Code::bad_cycle, "a cycle call before CYCL DEF");
  const Cycle& cycle = *modes_.cycle;
  if (!modes_.tool_axis_is_z || z == 0)
    return items_.fail(Code::bad_cycle, "a cycle before TOOL CALL with the tool axis Z");
  if (modes_.tcp) return items_.fail(Code::bad_cycle, "a cycle while M128 is on");
  if (modes_.feed_per_revolution && cycle.feed_mm_min > 0.0)
    return items_.fail(Code::bad_cycle, "a cycle while M136 is on");
  const std::size_t column = columns_.column_of('Z');
  motion.kind = ReadMotion::Kind::drill;
  motion.stated = static_cast<std::uint8_t>(stated | z);
  motion.known = static_cast<std::uint8_t>(columns_.known | stated | z);
  if ((columns_.known & z) != 0) motion.travel_z_mm = columns_.position[column];
  motion.position[column] = cycle.surface_z_mm - cycle.depth_mm;
  motion.clearance_z_mm = cycle.surface_z_mm + cycle.clearance_mm;
  motion.retract_z_mm = cycle.surface_z_mm + cycle.retract_mm;
  motion.peck_mm = cycle.peck_mm;
  motion.dwell_s = cycle.dwell_s;
  motion.hole = cycle.hole;
  motion.pitch_mm = cycle.pitch_mm;
  motion.cycle = cycle.word;
  motion.feed_mode = ReadMotion::Feed::per_minute;
  motion.feed = cycle.feed_mm_min;
  if (cycle.pitch_mm > 0.0) motion.feed = cycle.pitch_mm * modes_.spindle.speed_rpm;
  if (!(motion.feed > 0.0)) return items_.fail(Code::no_feed, "a tap without a spindle speed");
  if (cycle.number == 206 && modes_.spindle.state == ReadSpindle::State::counterclockwise)
    motion.hole = ReadMotion::Hole::tap_left;
  if (!cycle.stops_spindle() && modes_.spindle_was_coupled && !stop_spindle()) return false;
  modes_.before_tcp_ended.reset();
  columns_.known = motion.known;
  columns_.position = motion.position;
  columns_.position[column] = motion.retract_z_mm;
  modes_.spindle_was_coupled = modes_.spindle_was_coupled || cycle.stops_spindle();
  return items_.send(motion);
}

}  // namespace pentapost::nc::readers::klartext
