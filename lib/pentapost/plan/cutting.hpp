#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/tool_path.hpp"
#include "pentapost/plan/branches.hpp"
#include "pentapost/plan/frame.hpp"
#include "pentapost/plan/program.hpp"
#include "pentapost/plan/sequences.hpp"
#include "pentapost/plan/settings.hpp"

namespace pentapost::plan {

/// Plans one sequence: chooses solutions, approaches, cuts, and retracts where it must.
Status cut_sequence(const kinematics::Model& model, const JointRanges& ranges,
                    const path::ToolPath& tool_path, const Settings& settings,
                    const Sequence& sequence, double gauge_length_mm, bool check_linear,
                    Frame& frame, Program& program);

}  // namespace pentapost::plan
