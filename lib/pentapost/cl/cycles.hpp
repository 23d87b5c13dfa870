#pragma once

#include "pentapost/core/diagnostics.hpp"
#include "pentapost/path/tool_path.hpp"

#include <cstdint>
#include <functional>

namespace pentapost::cl {

/// `path` with its holes written as single moves along the tool axis.
///
/// The tool reaches a hole at rapid rate: along its axis up to the retract height of the hole,
/// across, down to the clearance. Where it is higher already it goes across at its own height;
/// where its axis turns by more than 1 deg it goes by way of home (GoHome).
///
/// A hole is: feed to the depth (deep: pecks with full retracts; break_chip: pecks with small
/// ones), dwell, and out: rapid, at feed for bore and ream (as G85), with the spindle stopped for
/// bore_drag (as G86), with the spindle reversed for taps. Its moves carry the CL line of the hole.
/// The feed of the path is restored behind the holes.
///
/// @param stays_native  true for a point with Move::hole (index into `path`) that is to remain one;
///                      such holes keep their cycle's CycleStart and CycleEnd.
/// @param diagnostics   takes a cycle_expanded warning for each cycle that taps: single moves do
/// not
///                      couple feed and spindle. nullptr: none are wanted.
path::ToolPath expand_cycles(const path::ToolPath& path,
                             const std::function<bool(std::uint32_t point)>& stays_native,
                             Diagnostics* diagnostics = nullptr);

}  // namespace pentapost::cl
