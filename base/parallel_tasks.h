#pragma once

/// Tasks that do not wait for each other, on all cores.

#include <functional>
#include <vector>

#include "base/progress.h"

namespace thenar {

/// One of several tasks.
struct ParallelTask {
  double seconds;                             // estimated duration [s]
  std::function<void(const Progress&)> work;  // writes to a place of its own; its progress is 0..1
};

/// Runs all tasks, several at once, the longest first; returns when all are done. Reports their
/// progress as that of the whole, one report at a time. Tasks that have not begun when the whole is
/// asked to stop are left out.
/// @throws the exception of one of the tasks that threw; tasks that have not begun then are left
/// out.
void run_tasks(std::vector<ParallelTask> tasks, const Progress& progress);

}  // namespace thenar
