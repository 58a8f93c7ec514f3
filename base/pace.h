#pragma once

/// Foretells how long work takes, from how much of it is done.

#include <optional>
#include <string>

namespace thenar {

/// Listens to the progress of one piece of work.
class Pace {
 public:
  /// @param begin  when the work began, on the clock of hear() [s]
  explicit Pace(double begin = 0) : begin_(begin) {}

  /// Takes a report.
  /// @param now  time on any clock that goes on evenly [s]
  /// @param fraction  of the work that is done [1]
  void hear(double now, double fraction);

  /// Returns the total duration: the time since the beginning plus left(); absent as left() is [s].
  [[nodiscard]] std::optional<double> whole() const;

  /// Returns the remaining time at the pace since the first report; absent until 1.5 s of work, and
  /// 2 % of it, are done since [s].
  [[nodiscard]] std::optional<double> left() const;

 private:
  struct Mark {
    double at = 0, fraction = 0;  // [s], [1]
  };
  double begin_;  // [s]
  std::optional<Mark> first_;
  Mark last_;
};

/// Returns "40 s", "3 min" or "2 h": to a step that an estimate deserves.
[[nodiscard]] std::string rough_time(double seconds);

}  // namespace thenar
