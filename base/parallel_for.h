#pragma once

/// Independent work on all cores.

#include <cstddef>
#include <functional>

namespace thenar {

/// Returns the number of threads: `asked`, or the number of processors if it is 0.
[[nodiscard]] int threads_or_all(int asked);

/// Calls work(k) once on each of so many threads, all of which hear the caller's stop; work(0) is
/// the caller's own. Returns when all are done.
/// @param work  throws nothing
void on_threads(int threads, const std::function<void(int)>& work);

/// Calls work(i) for every i below `count`, several at once in no order; returns when all are done.
/// Where each writes to a place of its own, the result is that of a loop.
/// @param work  may be called from several threads at once
/// @throws the exception of the least i whose work threw; work that has not begun then is left out.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace thenar
