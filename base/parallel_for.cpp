#include "base/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "base/stop_scope.h"

namespace thenar {

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  std::mutex failing;
  std::size_t first_failed = count;
  std::exception_ptr failure;
  // Numbers are dealt in order, so that all below one that fails have begun.
  const auto labour = [&] {
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
  // The caller works, too.
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::thread> others;
  const StopScope::Request* stop = StopScope::current();
  for (std::size_t k = 1; k < std::min(cores, count); ++k)
    others.emplace_back([&labour, stop] {
      const StopScope scope(stop);
      labour();
    });
  labour();
  for (std::thread& thread : others) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace thenar
