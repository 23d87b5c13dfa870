#pragma once

#include "pentapost/nc/reader.hpp"

#include <string_view>

namespace pentapost::nc::readers {

/// Reads programs of the SINUMERIK 840D in its own language (G290) for mills. Written against the
/// programming manuals Fundamentals, Job planning (Advanced) and Cycles. What machine data decide
/// must be set by the program; of the options only "edge_after_tool_change" counts here.
Status read_siemens_840d(std::string_view text, const ReaderSetup& setup, const ItemSink& sink);

}  // namespace pentapost::nc::readers
