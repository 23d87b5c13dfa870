#pragma once

#include "pentapost/core/diagnostics.hpp"
#include "pentapost/core/result.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/motion.hpp"
#include "pentapost/path/tool_path.hpp"
#include "pentapost/plan/branches.hpp"
#include "pentapost/plan/choice.hpp"
#include "pentapost/plan/settings.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace pentapost::plan {

struct Retract {
  std::uint32_t cl_line = 0;
  std::string reason;
};

/// The whole NC program, and what the report says of the planning.
struct Program {
  path::Motion motion;
  std::vector<Retract> retracts;
  Diagnostics diagnostics;
  std::uint64_t inserted_points = 0;    ///< ends of blocks that are no CL points
  double length_mm = 0.0;               ///< of the tip's cutting path
  double programmed_time_s = 0.0;       ///< of that path at the feed of the CL data
  double axis_change_rad = 0.0;         ///< largest use of the freedom of the tool axis
  std::vector<SequenceChoice> choices;  ///< in order of the sequences
};

/// What can be told before the planning: whether the machine can have this output, the digits printed
/// can hold the tolerances, and all coordinates are within bounds.
Status check_plannable(const kinematics::Model& model, const path::ToolPath& tool_path,
                       const Settings& settings);

/// Plans the NC program for a tool path: choice of solutions, linearisation, feeds, and the safe
/// order of everything around them (lib/README.md sections 4 to 6).
///
/// @param tool_path  in the table's orientation; holes only where a native cycle drills them.
/// @return Problem with the CL line: what this machine cannot do, or what the path lacks.
Result<Program> plan_program(const kinematics::Model& model, const JointRanges& ranges,
                             const path::ToolPath& tool_path, const Settings& settings);

}  // namespace pentapost::plan
