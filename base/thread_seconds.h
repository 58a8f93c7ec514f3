#pragma once

/// Processor time, for what runs cost.

#include <ctime>

namespace thenar {

/// Returns the processor time that the calling thread has taken [s]. Differences count.
[[nodiscard]] inline double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace thenar
