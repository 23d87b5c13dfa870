#pragma once

#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/tool_path.hpp"
#include "pentapost/plan/candidates.hpp"

#include <cstdint>
#include <vector>

namespace pentapost::plan {

/// A place on a tool path, and how far its tool axis is from a pole.
struct PlaceByPole {
  std::uint32_t point = 0;  ///< on the move to this point,
  double fraction = 1.0;    ///< in (0, 1]; 1: the point itself
  double chord = 0.0;       ///< distance of both unit vectors, at most NearRule::far_chord
};

/// A passage of a pole within a run of straight feed moves.
struct NearPassage {
  std::uint8_t pole = 1;  ///< 1 or 2
  std::size_t sequence = 0;
  PlaceByPole nearest;
  PlaceByPole before, after;  ///< points: up to them the distance from the pole grows
};

struct NearRule {
  double nearest_chord = 0.0;  ///< passages farther off do not count
  double far_chord = 0.0;      ///< from here on all places are equally far
  double noise_chord = 0.0;    ///< a distance that goes back by no more still grows
};

/// All passages near the poles that `zone` says are within reach, in the order of the path. Runs
/// end at rapids, holes, arcs and sequences.
/// @note Linear in the number of points.
std::vector<NearPassage> near_passages(const kinematics::Model& model,
                                       const path::ToolPath& tool_path, const PoleZone& zone,
                                       const NearRule& rule);

}  // namespace pentapost::plan
