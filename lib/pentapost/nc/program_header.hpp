#pragma once

#include "pentapost/path/motion.hpp"

#include <string>
#include <vector>

namespace pentapost::nc {

/// What every program says of itself at its head: name, machine, definition, units, meaning of
/// the words, then the header's own comments. One string a comment, not yet in a control's
/// characters.
std::vector<std::string> header_comments(const path::ProgramHeader& header,
                                         const path::Motion& motion);

}  // namespace pentapost::nc
