#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace pentapost::cl {

/// How the vector of a CIRCLE gives the sense of the arc. A word in the statement (CLW, CCLW,
/// CLOCKWISE, COUNTERCLOCKWISE: seen against the vector) comes first in every dialect.
enum class ArcSense : std::uint8_t {
  right_handed,
  left_handed,
  from_neighbours,  ///< no rule: the sense that is tangent to the moves before and behind
};

/// What the GOTO of a hole is.
enum class HolePoint : std::uint8_t { top, bottom };

/// A dialect of CL data: all in which it differs from plain APT.
struct ClDialect {
  std::string_view name;   ///< as in a request
  std::string_view title;  ///< for people
  /// How one of the first lines starts, upper case, blanks left out; empty: unused.
  std::array<std::string_view, 6> line_starts{};
  /// What one of the first lines holds, upper case, blanks left out; empty: unused.
  std::array<std::string_view, 2> line_parts{};
  ArcSense arc_sense = ArcSense::from_neighbours;
  HolePoint hole_point = HolePoint::top;
  bool clearance_is_height = false;  ///< clearance of a cycle is a coordinate along the tool axis
  bool rapto_is_below_clearance = false;  ///< RAPTO is measured down from the clearance
  bool depth_is_signed = false;           ///< FEDTO is negative into the material
  bool text_around = false;     ///< lines of text before the first statement and behind END-OF-PATH
  bool pprint_is_data = false;  ///< PPRINT speaks to another program, not to people
  bool axis_resets = false;     ///< the tool axis is 0,0,1 again at each operation
  /// Its writers have stated SPINDL/ON at a stop of the spindle and SPINDL/OFF at its start.
  bool bare_spindle_is_unclear = false;
};

/// All dialects; the last is plain APT, which is any text that is no other.
std::span<const ClDialect> cl_dialects();

/// The dialect of that name; nullptr: none.
const ClDialect* find_cl_dialect(std::string_view name);

/// The dialect whose marks are in the first 400 lines of `text`, the first mark deciding.
const ClDialect& detect_cl_dialect(std::string_view text);

}  // namespace pentapost::cl
