#pragma once

/// A pool of threads for common work in rounds.

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace thenar::internal {

/// A pool in which the caller is worker 0; a pool of one starts no thread.
class ThreadPool {
 public:
  explicit ThreadPool(int size);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  [[nodiscard]] int size() const { return static_cast<int>(threads_.size()) + 1; }

  /// Every worker does its part; returns when all are done.
  /// @throws what the first of them threw, when all are done.
  void run(const std::function<void(int worker)>& work);

 private:
  void serve(int worker);
  void attempt(int worker);

  std::mutex mutex_;
  std::condition_variable called_, done_;
  const std::function<void(int)>* work_ = nullptr;
  long round_ = 0;
  int busy_ = 0;
  bool over_ = false;
  std::vector<std::exception_ptr> failures_;
  std::vector<std::thread> threads_;
};

}  // namespace thenar::internal
