#pragma once

#include "pentapost/path/motion.hpp"
#include "pentapost/path/tool_path.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pentapost::jobs {

/// Where every motion block of a program comes from: columns, one row a block, in program order.
struct LineMap {
  enum class Kind : std::uint8_t {
    rapid,
    line,
    arc,
    hole,
    off_path,  ///< retract, repositioning or approach: on the way to the CL line
  };
  std::vector<std::uint32_t> nc_line;  ///< of the NC text, as its reader counted
  std::vector<std::uint32_t> cl_line;  ///< whose move the block is of; 0: of none
  std::vector<double> fraction;        ///< of that move at the end of the block, in (0, 1]
  std::vector<Kind> kind;
};

/// CL moves in a row that more than one block cuts, for one reason.
struct InsertedStretch {
  enum class Reason : std::uint8_t {
    turning,       ///< a single block would leave tip or axis tolerance while the rotary axes turn
    arc_as_lines,  ///< an arc that the control cannot have, or not with these axes moving
    arc_in_parts,  ///< an arc that is written as several
  };
  std::uint32_t from_cl_line = 0, to_cl_line = 0;
  std::uint64_t points = 0;  ///< ends of blocks that are no CL points
  Reason reason = Reason::turning;
};

/// @param nc_lines  of all motion blocks.
LineMap line_map(const path::Motion& motion, const path::ToolPath& tool_path,
                 std::span<const std::uint32_t> nc_lines);

/// In the order of the path.
std::vector<InsertedStretch> inserted_stretches(const path::Motion& motion,
                                                const path::ToolPath& tool_path);

}  // namespace pentapost::jobs
