#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/machine/chain.hpp"
#include "pentapost/path/tool_path.hpp"
#include "pentapost/plan/axis_path.hpp"
#include "pentapost/plan/candidates.hpp"
#include "pentapost/plan/settings.hpp"

#include <array>
#include <optional>

namespace pentapost::plan {

/// What every joint may do, in the order of a Model.
struct JointRanges {
  std::array<std::optional<Range<double>>, 3> linear_mm;
  std::array<std::optional<Range<double>>, 2> rotary_rad;  ///< nullopt: endless
};
JointRanges joint_ranges(const machine::Chain& chain, const kinematics::Model& model);

/// Speeds by which steps are compared: the limits, or 30 deg/s and 250 mm/s where none is known.
struct OrderingSpeeds {
  Vec3 linear_mm_s;
  std::array<double, 2> rotary_rad_s;
};
OrderingSpeeds ordering_speeds(const kinematics::Model& model, const Settings& settings);

/// Chooses branch and turns for a whole range by dynamic programming: the cheapest admissible
/// sequence wins, with a retract where none is continuous (lib/README.md section 4).
///
/// @param gauge_length_mm  of the tool that cuts the range; 0 where unknown.
/// @param check_linear  states outside the linear ranges do not exist.
/// @return Problem rotary_range or linear_range: axis, value, limit, first CL line.
/// @note Linear in the number of points.
Result<AxisPath> choose_branches(const kinematics::Model& model, const JointRanges& ranges,
                                 const path::ToolPath& tool_path, const Candidates& candidates,
                                 const Settings& settings, double gauge_length_mm,
                                 bool check_linear);

}  // namespace pentapost::plan
