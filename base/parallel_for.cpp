#include "base/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "base/stop_scope.h"

namespace thenar {

int threads_or_all(int asked) {
  return asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void on_threads(int threads, const std::function<void(int)>& work) {
  std::vector<std::thread> others;
  // Threads inherit the stop of their caller; the caller itself does the work of number 0.
  const StopScope::Request* stop = StopScope::current();
  for (int k = 1; k < threads; ++k)
    others.emplace_back([&work, stop, k] {
      const StopScope scope(stop);
      work(k);
    });
  work(0);
  for (std::thread& thread : others) thread.join();
}

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  std::mutex failing;
  std::size_t first_failed = count;
  std::exception_ptr failure;
  // Hand out indices in order, so that all below a failing one have started.
  const auto labour = [&](int) {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(failing);
        if (i < first_failed) {
          first_failed = i;
          failure = std::current_exception();
        }
        next = count;
      }
    }
  };
  on_threads(static_cast<int>(std::min(static_cast<std::size_t>(threads_or_all(0)), count)),
             labour);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace thenar
