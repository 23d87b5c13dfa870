#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/tool_path.hpp"
#include "pentapost/plan/block_maker.hpp"
#include "pentapost/plan/frame.hpp"
#include "pentapost/plan/settings.hpp"

#include <cstdint>
#include <functional>

namespace pentapost::plan {

/// Which holes the control drills by a cycle of its own: those of machines whose tool axis never
/// turns and is the Z of the words, with joint values for words (TCP is off), which retract to the
/// clearance level, and which the tool reaches from another point. All others become single moves.
std::function<bool(std::uint32_t point)> native_holes(const kinematics::Model& model,
                                                      const path::ToolPath& tool_path,
                                                      const Settings& settings);

/// Writes the hole of the cycle that is on. Brings the rotary axes there first, from the safe end;
/// where they stand still and the tool is below the clearance, it rises first: in a cycle the
/// control moves across at the level where the tool is.
/// @param from  where the tool is.
/// @return the posture at the retract level.
Result<Posture> drill(const path::ToolPath& tool_path, std::uint32_t point, const Posture& from,
                      const RotaryPair& rotary, bool rotary_moves, BlockMaker& maker, Frame& frame);

}  // namespace pentapost::plan
