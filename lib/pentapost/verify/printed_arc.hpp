#pragma once

#include "pentapost/path/segment.hpp"
#include "pentapost/verify/tool_position.hpp"

#include <optional>
#include <string>

namespace pentapost::verify {

/// The tool tip's way over an arc block, CL frame, as the control runs it: in the plane of the
/// words X and Y, the word Z evenly with the angle.
///
/// @param to_cl  from linear words to the tip in the CL frame: linear part, which must keep
/// lengths.
/// @return nullopt: `wrong` says what is not right with the block.
std::optional<path::Segment> printed_arc(const nc::ReadMotion& motion, const Stop& from,
                                         const Stop& to, const Mat3& to_cl, std::string& wrong);

/// What is wrong with the sense of an arc and its turns against the arc of the CL move; empty:
/// nothing.
std::string wrong_turning(const path::Segment& printed, const path::Segment& move,
                          double part_of_move);

}  // namespace pentapost::verify
