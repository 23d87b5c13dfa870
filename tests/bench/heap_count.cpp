#include "heap_count.hpp"

#include <malloc.h>

#include <cstdlib>
#include <new>

// The benchmarks run in one thread: plain counters disturb the times least.
namespace {

std::size_t bytes_now = 0;
std::size_t bytes_peak = 0;

void* counted(void* block) {
  if (block == nullptr) throw std::bad_alloc{};
  bytes_now += malloc_usable_size(block);
  if (bytes_now > bytes_peak) bytes_peak = bytes_now;
  return block;
}

void release(void* block) {
  if (block == nullptr) return;
  bytes_now -= malloc_usable_size(block);
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) { return counted(std::malloc(size)); }
void* operator new[](std::size_t size) { return counted(std::malloc(size)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(step, (size + step - 1) / step * step));
}
void operator delete(void* block) noexcept { release(block); }
void operator delete[](void* block) noexcept { release(block); }
void operator delete(void* block, std::size_t) noexcept { release(block); }
void operator delete[](void* block, std::size_t) noexcept { release(block); }
void operator delete(void* block, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { release(block); }

namespace pentapost::bench {

std::size_t heap_bytes() { return bytes_now; }
std::size_t heap_peak_bytes() { return bytes_peak; }
void reset_heap_peak() { bytes_peak = bytes_now; }

}  // namespace pentapost::bench
