#pragma once

/// Progress of long work in parts, and the exception of stopped work.

#include "base/error.h"
#include "base/progress.h"

namespace thenar {

/// Exception of stopped work, thrown after results are saved, where there is no
/// result to return.
class Stopped : public Error {
 public:
  using Error::Error;
};

/// Progress of a computation, divided into parts.
class ProgressParts {
 public:
  /// @param seconds  estimated duration of all parts [s]
  ProgressParts(Progress whole, double seconds);

  /// Returns the progress of the next part: its 0 .. 1 is mapped to its share of the whole.
  /// @param seconds  estimated duration of the part [s]
  [[nodiscard]] Progress next(double seconds);

  /// Releases the callbacks, so that a progress bar ends before the next output.
  void finish() { whole_ = {}; }

 private:
  Progress whole_;
  double seconds_, done_ = 0;
};

/// Reports progress. @throws Stopped if a stop is requested
void report_or_stop(const Progress& progress, double fraction, const std::string& what);

}  // namespace thenar
