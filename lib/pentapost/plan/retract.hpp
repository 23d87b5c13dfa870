#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/plan/block_maker.hpp"
#include "pentapost/plan/frame.hpp"
#include "pentapost/plan/settings.hpp"

#include <cstdint>
#include <optional>

namespace pentapost::plan {

/// Where the tool is when it has to leave the path.
struct RetractPlace {
  Vec3 tip_mm;  ///< frame of the tool path
  Vec3 axis;
  std::uint32_t point;  ///< the move in hand leads to this point
  std::uint32_t cl_line;
};

/// The posture above a place from which the tool comes down along its axis; nullopt: the linear
/// ranges leave no room.
/// @param distance_mm  wanted; less where the ranges need it.
std::optional<Posture> posture_above(const RetractPlace& place, const RotaryPair& rotary,
                                     double distance_mm, BlockMaker& maker);

/// Writes retract, repositioning and plunge: along the tool axis to clearance, TCP off, tool to its
/// safe end, rotary axes to `after`, TCP on, back above the place, plunge to exactly the place.
/// @return the posture at the place with the new rotary values; Problem linear_range where there is
///         no room to retract.
Result<Posture> retract_and_reposition(const RetractPlace& place, const RotaryPair& before,
                                       const RotaryPair& after, const Settings& settings,
                                       bool check_linear, BlockMaker& maker, Frame& frame);

}  // namespace pentapost::plan
