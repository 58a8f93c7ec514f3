#pragma once

/// Independent tasks on all cores.

#include <functional>
#include <vector>

#include "base/progress.h"

namespace thenar {

/// One of several tasks.
struct ParallelTask {
  double seconds;                             // estimated duration [s]
  std::function<void(const Progress&)> work;  // writes to its own memory; its progress is 0..1
};

/// Runs all tasks in parallel, the longest first; returns when all are done. Reports their joint
/// progress, one report at a time. Tasks that have not started at a stop request are skipped.
/// @throws the exception of one of the tasks that threw; tasks that have not started by then are
///         skipped.
void run_tasks(std::vector<ParallelTask> tasks, const Progress& progress);

}  // namespace thenar
