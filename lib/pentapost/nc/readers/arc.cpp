#include "pentapost/nc/readers/arc.hpp"

#include "pentapost/core/number_text.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace pentapost::nc::readers {
namespace {

/// So little a rotary axis may be told to move in an arc block: rounding of sums in G91.
constexpr double no_turn_deg = 1e-7;

}  // namespace

bool ArcBlock::open() {
  const auto ends = static_cast<std::uint8_t>(columns_.bit_of('X') | columns_.bit_of('Y'));
  if (columns_.bit_of('X') == 0 || columns_.bit_of('Y') == 0 || (columns_.known & ends) != ends)
    return items_.fail(Code::bad_arc, "an arc from a position that is not known");
  const auto in_arc = static_cast<std::uint8_t>(ends | columns_.bit_of('Z'));
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    if ((motion_.stated & ~in_arc & 1U << column) == 0) continue;
    const double turn = motion_.position[column] - columns_.position[column];
    if ((columns_.known >> column & 1U) == 0 || std::abs(turn) > no_turn_deg)
      return items_.fail(Code::not_in_dialect,
                         std::string{columns_.letter(column)} + " moves within an arc");
  }
  const std::size_t x = columns_.column_of('X'), y = columns_.column_of('Y');
  start_ = {columns_.position[x], columns_.position[y]};
  end_ = {motion_.position[x], motion_.position[y]};
  return true;
}

bool ArcBlock::set_radius(double radius_mm) {
  const auto centre =
      centre_from_radius(start_, end_, radius_mm, motion_.clockwise, largest_radius_mismatch_mm_);
  if (!centre || radius_mm == 0.0)
    return items_.fail(Code::bad_arc, "no arc of radius " + number_text(radius_mm) +
                                          " mm leads to this end point");
  motion_.centre_x_mm = centre->x;
  motion_.centre_y_mm = centre->y;
  return true;
}

bool ArcBlock::set_centre(PlanePoint centre) {
  if (is_same_point(start_, centre))
    return items_.fail(Code::bad_arc, "an arc without a centre or without a radius");
  const double mismatch = radius_mismatch_mm(start_, end_, centre);
  if (mismatch > largest_radius_mismatch_mm_)
    return items_.fail(Code::bad_arc, "start and end of an arc differ by " +
                                          number_text(mismatch, 4) +
                                          " mm in their distance from the centre");
  motion_.centre_x_mm = centre.x;
  motion_.centre_y_mm = centre.y;
  if (is_same_point(start_, end_)) motion_.whole_turns = 1;
  return true;
}

}  // namespace pentapost::nc::readers
