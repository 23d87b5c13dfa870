#pragma once

#include <cstddef>
#include <string>

namespace pentapost::bench {

/// CL text of `points` five-axis GOTO: rows to and fro over a wavy surface, 0.1 to 1 mm from point
/// to point, the tool axis 5 to 60 degrees off Z and turning smoothly, all five axes of a machine
/// in motion. Spelled as CAM systems do: five decimals for the tip, eight for the axis.
std::string five_axis_cl(std::size_t points);

}  // namespace pentapost::bench
