#pragma once

/// Base class of recorded motions: a time axis with an end.

#include <cstddef>
#include <vector>

#include "live/live_timeline.h"

namespace thenar {

/// Recorded motion that can show any time between its first and last instant.
class RecordedTimeline : public LiveTimeline {
 public:
  [[nodiscard]] unsigned long shape_changes() const override { return 0; }
  [[nodiscard]] unsigned long changes() const override { return changes_; }
  /// Returns the time and settings of playback; the step size is 1/240 s.
  [[nodiscard]] LiveTime live_time() const override;

  /// Advances time by `count` steps; stops playing at the end.
  MotionQuality step(long count, const Progress& progress) override;
  /// Shows time t, clamped to the recorded range. @return the time that is shown [s]
  double seek(double t) override;
  void reset() override;

 protected:
  /// @param times  times of the recorded instants, at least one, in rising order [s] (instants)
  explicit RecordedTimeline(std::vector<double> times);

  [[nodiscard]] double shown_time() const { return t_; }  // [s]
  /// Returns the recorded instant nearest to the time that is shown.
  [[nodiscard]] std::size_t nearest_instant() const { return nearest_; }
  /// Position of a time between two recorded instants.
  struct Interpolation {
    std::size_t from = 0, to = 0;  // instants before and after; equal at a recorded instant
    double fraction = 0;           // fraction of the way from one to the other [1]
  };
  [[nodiscard]] Interpolation interpolation() const;
  /// Interpolates a number linearly. @param at  function that returns its value at an instant
  template <class At>
  [[nodiscard]] double interpolated_number(const At& at) const {
    const Interpolation now = interpolation();
    const double from = at(now.from);
    return now.from == now.to ? from : from + now.fraction * (at(now.to) - from);
  }
  /// Interpolates a row linearly. @param rows  recorded values (instants, numbers)
  [[nodiscard]] Eigen::VectorXd interpolated(const Eigen::MatrixXd& rows) const;

 private:
  std::vector<double> times_;
  double t_ = 0;             // time that is shown [s]
  std::size_t nearest_ = 0;  // recorded instant nearest to t_
  unsigned long changes_ = 0;
};

}  // namespace thenar
