#pragma once

/// Stop request for work deep below the caller that set it: matrix factorisations, facets of a
/// hull, unions of solids read from a file.

#include <functional>

#include "base/progress.h"

namespace thenar {

/// Scope that sets the stop request of this thread, and restores the previous one at its end. It
/// belongs to the thread instead of an argument list, because readers and solvers that are slow
/// only for extreme inputs would otherwise pass it through all of their callers.
class StopScope {
 public:
  using Request = std::function<bool()>;  // see Progress::stop_requested

  explicit StopScope(const Progress& progress) : StopScope(&progress.stop_requested) {}
  /// Joins the scope of another thread that works on the same task.
  /// @param stop_requested  request of its scope; null: none
  explicit StopScope(const Request* stop_requested);
  ~StopScope();
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;

  /// Returns the request of this thread's scope; null where there is none.
  [[nodiscard]] static const Request* current();

 private:
  const Request* before_;
};

/// Throws if a stop is requested. It is called after amounts of work and never after times, so that
/// repeated work calls it equally often.
/// @throws Stopped if the scope of this thread requests it
void end_if_stopped();

}  // namespace thenar
