#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/tool_path.hpp"
#include "pentapost/plan/axis_path.hpp"
#include "pentapost/plan/branches.hpp"
#include "pentapost/plan/settings.hpp"

namespace pentapost::plan {

/// The rotary values along a range of points.
struct Choice {
  AxisPath axis_path;
  double slack_rad = 0.0;        ///< that the range was chosen with: see kinematics::inverse_rotary
  double axis_change_rad = 0.0;  ///< largest use of the freedom of the tool axis
};

/// The choice of a sequence.
struct SequenceChoice {
  Choice choice;
  int tool_number = 1;
  double gauge_length_mm = 0.0;  ///< 0 where unknown
};

/// Chooses branch and turns for a range: by the cheaper way where its answer is beyond doubt, else
/// by the whole search.
///
/// @param gauge_length_mm  of the tool that cuts the range; 0 where unknown.
/// @param check_linear  the linear ranges are held.
/// @return Problem as find_candidates() and choose_branches().
Result<Choice> choose(const kinematics::Model& model, const JointRanges& ranges,
                      const path::ToolPath& tool_path, PointRange range, const Settings& settings,
                      double gauge_length_mm, bool check_linear);

}  // namespace pentapost::plan
