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
      done_[task] = std::clamp(fraction, done_[task], 1.0);
      double sum = 0;
      for (std::size_t i = 0; i < done_.size(); ++i) sum += done_[i] * tasks_[i].seconds;
      whole_(all_ > 0 ? sum / all_ : 0, what);
    };
    return part;
  }

  /// Counts a task as done, whatever it reported.
  void end(std::size_t task) {
    const std::lock_guard lock(mutex_);
    done_[task] = 1;
  }

 private:
  const Progress& whole_;
  const std::vector<ParallelTask>& tasks_;
  std::mutex mutex_;
  std::vector<double> done_;  // share of each task [1]
  double all_ = 0;            // [s]
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
