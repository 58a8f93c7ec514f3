#pragma once

/// Pieces of work of one call that several threads take, and that may add others.

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>

namespace thenar {

/// A queue of pieces of work. Where each piece writes to a place of its own, and adds the same
/// others whenever it runs, the result is the same with any number of threads.
class TaskQueue {
 public:
  using Task = std::function<void()>;

  /// Adds a piece behind all that wait, or before them; also from a piece that runs.
  void add(Task task);
  void add_first(Task task);

  /// Runs all pieces on so many threads; the caller is one of them, and calls `between` after each
  /// of its own and once more when all are done.
  /// @throws what a piece or `between` threw first; pieces that have not begun then are left out.
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
