#include "base/thread_pool.h"

namespace thenar::internal {

// NOLINTNEXTLINE(bugprone-throw-keyword-missing): keeps exceptions, throws none
ThreadPool::ThreadPool(int size) : failures_(static_cast<std::size_t>(size)) {
  for (int worker = 1; worker < size; ++worker)
    threads_.emplace_back([this, worker] { serve(worker); });
}

ThreadPool::~ThreadPool() {
  {
    const std::lock_guard<std::mutex> guard(mutex_);
    over_ = true;
  }
  called_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void ThreadPool::attempt(int worker) {
  try {
    (*work_)(worker);
  } catch (...) {
    failures_[static_cast<std::size_t>(worker)] = std::current_exception();
  }
}

void ThreadPool::serve(int worker) {
  long served = 0;
  while (true) {
    // Wait for the next round, or the end.
    {
      std::unique_lock<std::mutex> guard(mutex_);
      called_.wait(guard, [&] { return over_ || round_ > served; });
      if (over_) return;
      served = round_;
    }
    attempt(worker);
    const std::lock_guard<std::mutex> guard(mutex_);
    if (--busy_ == 0) done_.notify_one();
  }
}

void ThreadPool::run(const std::function<void(int)>& work) {
  // Announce the round.
  {
    const std::lock_guard<std::mutex> guard(mutex_);
    work_ = &work;
    busy_ = static_cast<int>(threads_.size());
    failures_.assign(failures_.size(), nullptr);
    ++round_;
  }
  called_.notify_all();
  attempt(0);
  // Wait for all, then pass the first failure on.
  {
    std::unique_lock<std::mutex> guard(mutex_);
    done_.wait(guard, [&] { return busy_ == 0; });
  }
  for (const std::exception_ptr& failure : failures_)
    if (failure) std::rethrow_exception(failure);
}

}  // namespace thenar::internal
