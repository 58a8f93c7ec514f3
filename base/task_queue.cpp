#include "base/task_queue.h"

#include <utility>

#include "base/parallel_for.h"

namespace thenar {

void TaskQueue::add(Task task) {
  const std::lock_guard lock(mutex_);
  waiting_.push_back(std::move(task));
  changed_.notify_one();
}

void TaskQueue::add_first(Task task) {
  const std::lock_guard lock(mutex_);
  waiting_.push_front(std::move(task));
  changed_.notify_one();
}

/// Takes the next piece. @returns false when nothing waits, and nothing runs that may add some
bool TaskQueue::take(Task& task) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return !waiting_.empty() || running_ == 0; });
  if (waiting_.empty()) return false;
  task = std::move(waiting_.front());
  waiting_.pop_front();
  ++running_;
  return true;
}

/// Keeps the first failure; nothing that waits begins any more.
void TaskQueue::fail() {
  const std::lock_guard lock(mutex_);
  if (!failure_) failure_ = std::current_exception();
  waiting_.clear();
}

void TaskQueue::serve(const std::function<void()>& between) {
  for (Task task; take(task);) {
    try {
      task();
      if (between) between();
    } catch (...) {
      fail();
    }
    const std::lock_guard lock(mutex_);
    if (--running_ == 0) changed_.notify_all();
  }
}

void TaskQueue::run(int threads, const std::function<void()>& between) {
  on_threads(threads, [&](int thread) { serve(thread == 0 ? between : nullptr); });
  // Finish with whatever other threads did last.
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  if (between) between();
}

}  // namespace thenar
