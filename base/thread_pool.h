#pragma once

/// Pool of threads for parallel work in rounds.

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace thenar::internal {

/// Pool in which the caller is worker 0; a pool of size 1 starts no thread.
class ThreadPool {
 public:
  explicit ThreadPool(int size);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  [[nodiscard]] int size() const { return static_cast<int>(threads_.size()) + 1; }

  /// Calls work(k) on every worker k; returns when all are done.
  /// @throws the exception of the first worker that threw, when all are done.
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
