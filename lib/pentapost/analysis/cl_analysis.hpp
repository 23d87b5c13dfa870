#pragma once

#include "pentapost/analysis/path_analysis.hpp"
#include "pentapost/core/result.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/tool_path.hpp"
#include "pentapost/plan/branches.hpp"
#include "pentapost/plan/choice.hpp"
#include "pentapost/plan/settings.hpp"

#include <span>

namespace pentapost::analysis {

/// Analyses the continuous path: tip on its lines and arcs, tool axis on its great circles, rotary
/// solutions as they are chosen for the NC program (lib/README.md section 3).
///
/// @param tool_path  in the table's orientation; holes expanded.
/// @return Problem with the CL line: out of reach or range, or no feed.
Result<PathAnalysis> analyse_path(const kinematics::Model& model, const plan::JointRanges& ranges,
                                  const path::ToolPath& tool_path, const plan::Settings& settings,
                                  const AnalysisOptions& options);

/// The same for rotary solutions that have been chosen.
///
/// @param choices  of all sequences of the path, in order.
Result<PathAnalysis> analyse_choices(const kinematics::Model& model,
                                     const plan::JointRanges& ranges,
                                     const path::ToolPath& tool_path,
                                     const plan::Settings& settings,
                                     std::span<const plan::SequenceChoice> choices,
                                     const AnalysisOptions& options);

}  // namespace pentapost::analysis
