#pragma once

/// What every program that prints a table does beside printing it.

#include <cstdio>
#include <exception>

namespace thenar::bench {

/// Calls `run`, or says why that failed. @returns the exit code
template <typename Run>
int run_program(const char* name, const Run& run) {
  try {
    run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
    return 1;
  }
  return 0;
}

}  // namespace thenar::bench
