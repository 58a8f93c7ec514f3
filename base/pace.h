#pragma once

/// Estimate of the duration of work from its progress.

#include <optional>
#include <string>

namespace thenar {

/// Estimator of the duration of one task from its progress reports.
class Pace {
 public:
  /// @param begin  start of the work, on the clock of add_report() [s]
  explicit Pace(double begin = 0) : begin_(begin) {}

  /// Adds a progress report.
  /// @param now  time on any steady clock [s]
  /// @param fraction  completed fraction of the work [1]
  void add_report(double now, double fraction);

  /// Returns the estimated total duration [s]; absent if remaining_time() is.
  [[nodiscard]] std::optional<double> total_time() const;

  /// Returns the estimated remaining time at the rate since the first report [s]; absent until 1.5
  /// s and 2 % of the work have passed since then.
  [[nodiscard]] std::optional<double> remaining_time() const;

 private:
  struct Mark {
    double at = 0, fraction = 0;  // [s], [1]
  };
  double begin_;  // [s]
  std::optional<Mark> first_;
  Mark last_;
};

/// Returns a duration rounded as an estimate deserves: "40 s", "3 min" or "2 h".
[[nodiscard]] std::string rough_time(double seconds);

}  // namespace thenar
