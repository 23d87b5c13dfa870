#pragma once

#include "pentapost/core/units.hpp"
#include "pentapost/plan/candidates.hpp"

#include <cstdint>
#include <vector>

namespace pentapost::plan {

/// Values of the two rotary joints. A joint that the machine lacks stays 0.
struct RotaryPair {
  double first_rad = 0.0;
  double second_rad = 0.0;
  bool operator==(const RotaryPair&) const = default;
};

/// The rotary joints along a range of CL points, whole turns included: one choice of section 4.
struct AxisPath {
  static constexpr std::uint8_t at_rest = 2;  ///< branch of a move between two points at the pole

  PointRange range;
  // columns over the range
  std::vector<RotaryPair> arrival;   ///< values with which the move to the point ends
  std::vector<std::uint8_t> branch;  ///< that the move to the point follows: 0, 1 or at_rest
  std::vector<std::uint8_t> pole;    ///< as in Candidates

  /// The path goes on with other values than it came with.
  struct Departure {
    std::uint32_t point;
    RotaryPair pair;
    bool retract;  ///< true: retract, reposition, plunge; false: the axis turns at the pole
    /// 0: at the point. Otherwise inside the move to the next point, where the first axis is at the
    /// end of its range: `turns_rad` is what it is moved by there, and `pair` is not used.
    bool inside = false;
    double turns_rad = 0.0;
  };
  std::vector<Departure> departures;  ///< in order of their points

  /// A move passes the pole between its points.
  struct Crossing {
    std::uint32_t point;  ///< the move's end
    double fraction;
    std::uint8_t pole;
    RotaryPair before, after;  ///< values at the pole; they differ where the axis turns there
    std::uint8_t branch_before, branch_after;
  };
  std::vector<Crossing> crossings;  ///< in order of their points

  const RotaryPair& at(std::uint32_t point) const { return arrival[point - range.begin]; }
};

}  // namespace pentapost::plan
