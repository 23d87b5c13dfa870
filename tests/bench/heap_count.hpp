#pragma once

#include <cstddef>

namespace pentapost::bench {

/// Bytes that operator new has handed out and not got back, in this program.
std::size_t heap_bytes();

/// Largest heap_bytes() since the last reset_heap_peak().
std::size_t heap_peak_bytes();
void reset_heap_peak();

/// Largest heap that a call needs above what was in use before it.
template <class Call>
std::size_t heap_peak_of(const Call& call) {
  reset_heap_peak();
  const std::size_t before = heap_bytes();
  call();
  return heap_peak_bytes() - before;
}

}  // namespace pentapost::bench
