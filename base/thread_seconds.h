#pragma once

/// Processor time of a thread.

#include <ctime>

namespace thenar {

/// Returns the processor time of the calling thread [s]; only differences are meaningful.
[[nodiscard]] inline double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace thenar
