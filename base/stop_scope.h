#pragma once

/// A request to stop that work hears which is called far below whoever was asked: factors of a
/// matrix, facets of a hull, unions of solids that a file is read into.

#include <functional>

#include "base/progress.h"

namespace thenar {

/// Whom the work of this thread asks whether to stop, for as long as it lives; then as before. It
/// is of the thread, and no argument, because readers and solvers that end in an instant but for
/// what they are given would otherwise hand it on through all of their callers.
class StopScope {
 public:
  using Request = std::function<bool()>;  // see Progress::stop_requested

  explicit StopScope(const Progress& progress) : StopScope(&progress.stop_requested) {}
  /// Joins the scope of another thread that works on the same task.
  /// @param stop_requested  of its scope; null: none
  explicit StopScope(const Request* stop_requested);
  ~StopScope();
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;

  /// Returns the request of this thread's scope; null where there is none.
  [[nodiscard]] static const Request* current();

 private:
  const Request* before_;
};

/// Ends work that was asked to stop. It is called by amount of work and never by time, so that work
/// that is repeated asks as often.
/// @throws Stopped where the scope of this thread says so
void end_if_stopped();

}  // namespace thenar
