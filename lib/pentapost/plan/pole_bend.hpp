#pragma once

#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/tool_path.hpp"
#include "pentapost/plan/branches.hpp"
#include "pentapost/plan/settings.hpp"

#include <cstdint>
#include <vector>

namespace pentapost::plan {

/// A passage that was led through the pole.
struct PoleBend {
  std::uint32_t cl_line = 0;  ///< of the move that is nearest to the pole
  double change_rad = 0.0;    ///< largest change of the tool axis
};

/// A tool path with its bends; empty where there is none.
struct PoleBends {
  std::vector<PoleBend> bends;   ///< in the order of the path
  path::ToolPath tool_path;      ///< to be planned: changed axes, points on the CL moves more
  std::vector<Vec3> cl_axis_wp;  ///< the CL's own axis at each of its points
  std::uint64_t inserted_points = 0;
  double largest_change_rad = 0.0;
};

/// Leads the path exactly through the poles that it passes within settings.pole_axis_rad, so that
/// the tilt can change its sign there and the first joint hardly turns (lib/README.md section 4;
/// Sorby 2007). Tips stay; points are inserted on the CL moves, and each bend has a comment event.
///
/// Left alone are passages that bending does not at least halve the turn of the first joint of, or
/// that it would change by more: where the path ends, turns about or leaves straight feed moves too
/// near to the pole, and where the range of the second joint forbids the change of sign.
///
/// @param tool_path  in the table's orientation, holes expanded.
PoleBends bend_at_poles(const kinematics::Model& model, const JointRanges& ranges,
                        const Settings& settings, const path::ToolPath& tool_path);

}  // namespace pentapost::plan
