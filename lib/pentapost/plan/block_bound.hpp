#pragma once

#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/segment.hpp"
#include "pentapost/plan/block_maker.hpp"
#include "pentapost/plan/settings.hpp"

namespace pentapost::plan {

/// Upper bounds of what a block leaves the CL move by, over the whole block.
struct BlockBound {
  double tip_mm = 0.0;
  double axis_rad = 0.0;
};

/// The block between two postures against the part of a CL move that it stands for.
///
/// Both deviations are bounded by the quadratic through both ends and the middle plus what the
/// third derivative leaves open, so no point of the block lies above them (lib/README.md section
/// 5).
BlockBound bound_block(const kinematics::Model& model, const Settings& settings,
                       const BlockMaker& maker, const path::Segment& segment, double fraction_from,
                       const Posture& from, double fraction_to, const Posture& to);

}  // namespace pentapost::plan
