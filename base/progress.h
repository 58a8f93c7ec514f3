#pragma once

/// Progress reports and stop requests of long computations.

#include <functional>
#include <string>

namespace thenar {

/// Callbacks of a long computation; the default ignores reports and never stops.
struct Progress {
  std::function<void(double fraction, const std::string& what)> report;  // fraction 0..1
  std::function<bool()> stop_requested;  // true: return the best result so far

  void operator()(double fraction, const std::string& what) const {
    if (report) report(fraction, what);
  }
  [[nodiscard]] bool stop() const { return stop_requested && stop_requested(); }
};

}  // namespace thenar
