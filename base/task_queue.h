#pragma once

/// Queue of tasks for several threads; tasks may add further ones.

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>

namespace thenar {

/// Queue of tasks. If each task writes to its own memory and always adds the same tasks, the result
/// is the same with any number of threads.
class TaskQueue {
 public:
  using Task = std::function<void()>;

  /// Add a task behind or before all waiting ones; also from a running task.
  void add(Task task);
  void add_first(Task task);

  /// Runs all tasks on the given number of threads; the caller is one of them, and calls `between`
  /// after each of its tasks and once more at the end.
  /// @throws the first exception of a task or of `between`; tasks that have not started by then are
  ///         skipped.
  void run(int threads, const std::function<void()>& between = {});

 private:
  void serve(const std::function<void()>& between);
  void fail();
  [[nodiscard]] bool take(Task& task);

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Task> waiting_;
  std::size_t running_ = 0;
  std::exception_ptr failure_;
};

}  // namespace thenar
