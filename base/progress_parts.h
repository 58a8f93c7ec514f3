#pragma once

/// Long work in parts, each of which reports its own progress, and the end of work that was
/// stopped.

#include "base/error.h"
#include "base/progress.h"

namespace thenar {

/// Thrown by work that was asked to stop, after it has saved what it had, where nothing is left to
/// return.
class Stopped : public Error {
 public:
  using Error::Error;
};

/// Hands out the progress of the whole, part by part.
class ProgressParts {
 public:
  /// @param seconds  that all parts take, roughly [s]
  ProgressParts(Progress whole, double seconds);

  /// Returns the next part: its 0 .. 1 is its share of the whole.
  /// @param seconds  that it takes, roughly [s]
  [[nodiscard]] Progress next(double seconds);

  /// Lets go of the whole, so that a progress bar leaves the terminal to what is printed next.
  void finish() { whole_ = {}; }

 private:
  Progress whole_;
  double seconds_, done_ = 0;
};

/// Reports, or stops. @throws Stopped where progress says stop
void report_or_stop(const Progress& progress, double fraction, const std::string& what);

}  // namespace thenar
