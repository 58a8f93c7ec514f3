#pragma once

/// Counts what a program asks of malloc, as Eigen does, and operator new. Included by one source of
/// a program, as it replaces malloc. Sanitizers have a malloc of their own: there it counts
/// nothing.

#include <cstddef>
#include <cstdlib>

namespace thenar {

inline std::size_t allocations = 0;

}  // namespace thenar

#ifndef __SANITIZE_ADDRESS__
extern "C" {
// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming)
void* __libc_malloc(std::size_t size);
void* malloc(std::size_t size) {
  ++thenar::allocations;
  return __libc_malloc(size);
}
}
#endif
