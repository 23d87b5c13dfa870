#pragma once

#include "pentapost/core/units.hpp"
#include "pentapost/path/tool_path.hpp"

namespace pentapost::path {

/// The turn of a workpiece that is clamped with the reorientation of Cripps et al. 2017,
/// section 3.2: turned by -theta_z about +z, then by -theta_x about +x, right-handed (lib/README.md
/// section 7).
Mat3 setup_turn(double theta_x_rad, double theta_z_rad);

/// Turns tool path and all that lies in its frame about the origin.
void turn(ToolPath& tool_path, const Mat3& rotation);

}  // namespace pentapost::path
