#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/path/tool_path.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace pentapost::nc {

/// A Problem at a CL line; 0: not from the CL data.
Problem refusal(Code code, std::string message, std::uint32_t cl_line);

/// out_of_domain: "F = 1e+12 mm/min cannot be written on this control".
Problem unwritable(std::string_view what, double value, std::string_view unit,
                   std::uint32_t cl_line);

/// out_of_domain: "T5 H7 is not a tool that the control can call".
Problem uncallable(std::string_view words, std::uint32_t cl_line);

/// not_in_dialect: the options give no code for this coolant.
Problem no_coolant_code(path::Coolant::State state, std::uint32_t cl_line);

}  // namespace pentapost::nc
