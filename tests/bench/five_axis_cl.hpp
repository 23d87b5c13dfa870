#pragma once

#include <cstddef>
#include <string>

namespace pentapost::bench {

/// CL text of `points` five-axis GOTO: rows to and fro over a wavy surface, 0.2 mm from point to
/// point, the tool axis 6 to 35 degrees off Z and turning smoothly. Spelled as CAM systems do: four
/// decimals for the tip, seven for the axis.
std::string five_axis_cl(std::size_t points);

}  // namespace pentapost::bench
