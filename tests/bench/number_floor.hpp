#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace pentapost::bench {

/// The work that no postprocessor can do without: reads the six numbers of every GOTO and prints
/// five numbers of three decimals for it, with nothing between. Shares no code with the library.
/// @return the count of GOTO.
std::size_t number_floor(std::string_view cl, std::string& out);

}  // namespace pentapost::bench
