#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace pentapost::bench {

/// The work that no postprocessor can do without: finds the lines and the GOTO among them, reads
/// their six numbers and prints a block of words for each, with nothing between. Words are spelled
/// as controls do: a letter, at most three decimals, no trailing zeros; rotary words have the size
/// of degrees. Shares no code with the library.
///
/// @param words  of a block, as many as the NC program has: 5 (X Y Z A C), 6 (a block number
///               before them), or 7 (a feed behind them as well).
/// @return the count of GOTO.
std::size_t number_floor(std::string_view cl, int words, std::string& out);

/// For the report.
std::string_view what_the_floor_does();

}  // namespace pentapost::bench
