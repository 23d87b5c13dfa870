#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/segment.hpp"
#include "pentapost/plan/block_maker.hpp"
#include "pentapost/plan/move_curve.hpp"
#include "pentapost/plan/settings.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace pentapost::plan {

/// Of a tolerance, what the plan uses: the proof measures to 0.1 percent.
inline constexpr double tolerance_share = 0.995;

/// Where a block of a move ends.
struct Waypoint {
  double fraction = 1.0;  ///< of the whole CL move
  Posture posture;
};

/// A CL move.
struct PlannedMove {
  path::Segment cl;  ///< what the tolerances are held against
  /// The same from or to the pole itself, where an end is taken as the pole: what the axes follow.
  std::optional<path::Segment> by_pole = {};

  const path::Segment& planned() const { return by_pole ? *by_pole : cl; }
};

/// Divides a part of a CL move into blocks whose tip and tool axis stay within the tolerances over
/// the whole of every block (lib/README.md section 5). Appends the end of each block.
///
/// @param from  posture at the start of the part, as printed.
/// @param slack_rad  see kinematics::inverse_rotary.
/// @return Problem tolerance_below_digits, out_of_reach, a range or too_large, with the CL line.
Status linearise(const kinematics::Model& model, const Settings& settings, BlockMaker& maker,
                 const PlannedMove& move, const MovePart& part, const Posture& from,
                 double slack_rad, std::uint32_t cl_line, std::vector<Waypoint>& ends);

}  // namespace pentapost::plan
