#pragma once

/// Counts what a program asks of the heap. Included by one source of a program, as it replaces new
/// and delete.

#include <cstddef>
#include <cstdlib>
#include <new>

namespace thenar {

inline std::size_t allocations = 0;

}  // namespace thenar

void* operator new(std::size_t size) {
  ++thenar::allocations;
  void* block = std::malloc(size > 0 ? size : 1);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}
// The address sanitizer would serve this one itself, and miss its own delete.
void* operator new(std::size_t size, const std::nothrow_t& /*tag*/) noexcept {
  ++thenar::allocations;
  return std::malloc(size > 0 ? size : 1);
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t /*size*/) noexcept { std::free(block); }
