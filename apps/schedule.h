#pragma once

/// Long work in parts, each of which reports its own progress.

#include "base/progress.h"

namespace thenar {

/// Hands out the bar of the whole, part by part.
class Schedule {
 public:
  /// @param seconds  that all parts take, roughly [s]
  Schedule(Progress whole, double seconds);

  /// The next part: its 0 .. 1 is its share of the whole.
  /// @param seconds  that it takes, roughly [s]
  [[nodiscard]] Progress next(double seconds);

  /// Lets go of the bar, so that it leaves the terminal to what is printed next.
  void finish() { whole_ = {}; }

 private:
  Progress whole_;
  double seconds_, done_ = 0;
};

/// Reports, or stops. @throws Interrupted where progress says stop
void report_or_stop(const Progress& progress, double fraction, const std::string& what);

}  // namespace thenar
