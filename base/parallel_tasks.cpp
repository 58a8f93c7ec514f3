#include "base/parallel_tasks.h"

#include <algorithm>
#include <mutex>

#include "base/parallel_for.h"

namespace thenar {
namespace {

/// Progress of tasks that are done side by side.
class SharedProgress {
 public:
  SharedProgress(const Progress& whole, const std::vector<ParallelTask>& tasks)
      : whole_(whole), tasks_(tasks), done_(tasks.size(), 0.0) {
    for (const ParallelTask& task : tasks) all_ += task.seconds;
  }

  [[nodiscard]] Progress of(std::size_t task) {
    Progress part = whole_;
    part.report = [this, task](double fraction, const std::string& what) {
      const std::lock_guard lock(mutex_);
      advance(task, fraction);
      whole_(all_ > 0 ? std::min(sum_ / all_, 1.0) : 0, what);
    };
    return part;
  }

  /// Counts a task as done, whatever it reported.
  void end(std::size_t task) {
    const std::lock_guard lock(mutex_);
    advance(task, 1);
  }

 private:
  /// Moves a task on to a fraction, never back; reports of many tasks do not add up all of them.
  void advance(std::size_t task, double fraction) {
    const double before = done_[task];
    done_[task] = std::clamp(fraction, before, 1.0);
    sum_ += (done_[task] - before) * tasks_[task].seconds;
  }

  const Progress& whole_;
  const std::vector<ParallelTask>& tasks_;
  std::mutex mutex_;
  std::vector<double> done_;  // share of each task [1]
  double all_ = 0, sum_ = 0;  // of all tasks, and of what is done of them [s]
};

}  // namespace

void run_tasks(std::vector<ParallelTask> tasks, const Progress& progress) {
  // Begin with the longest, so that no long task is left over at the end.
  std::stable_sort(tasks.begin(), tasks.end(), [](const ParallelTask& a, const ParallelTask& b) {
    return a.seconds > b.seconds;
  });
  SharedProgress shared(progress, tasks);
  parallel_for(tasks.size(), [&](std::size_t i) {
    if (progress.stop()) return;
    tasks[i].work(shared.of(i));
    shared.end(i);
  });
}

}  // namespace thenar
