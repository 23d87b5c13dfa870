#pragma once

#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/motion.hpp"
#include "pentapost/path/segment.hpp"
#include "pentapost/plan/block_maker.hpp"
#include "pentapost/plan/settings.hpp"

#include <optional>
#include <vector>

namespace pentapost::plan {

/// A circular block: where it ends, and its words.
struct ArcPiece {
  double fraction = 1.0;
  Posture posture;
  path::ArcCentre centre;
  bool clockwise = false;  ///< seen from +Z of the words
};

/// The circular blocks for a CL arc, where the control can run it as such: rotary axes at rest, the
/// arc in the plane across Z of the words and across the tool axis, ends and centre at the digits
/// printed within the tip tolerance. Each block turns less than 350 degrees, so that no rounding
/// can exchange a whole turn and none.
///
/// @return nullopt where the arc has to be linearised.
std::optional<std::vector<ArcPiece>> native_arc(const kinematics::Model& model,
                                                const Settings& settings, BlockMaker& maker,
                                                const path::Segment& segment,
                                                const RotaryPair& rotary, const Posture& from,
                                                std::uint32_t cl_line);

}  // namespace pentapost::plan
