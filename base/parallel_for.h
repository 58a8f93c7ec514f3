#pragma once

/// Parallel loops on all cores.

#include <cstddef>
#include <functional>

namespace thenar {

/// Returns the number of threads: `asked`, or the number of processors if that is 0.
[[nodiscard]] int threads_or_all(int asked);

/// Calls work(k) once on each thread, with the caller's stop request; work(0) runs on the caller's
/// thread. Returns when all are done.
/// @param work  must not throw
void on_threads(int threads, const std::function<void(int)>& work);

/// Calls work(i) for every i below `count`, in parallel and in any order; returns when all are
/// done. If each call writes to its own memory, the result is that of a sequential loop.
/// @param work  may be called from several threads at once
/// @throws the exception of the smallest i whose work threw; work that has not started by then is
///         skipped.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace thenar
