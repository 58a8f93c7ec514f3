#pragma once

/// Base of all recorded motions: a time axis with an end.

#include <cstddef>
#include <vector>

#include "live/live_timeline.h"

namespace thenar {

/// A recorded motion on its line of time, on which any time may be shown.
class RecordedTimeline : public LiveTimeline {
 public:
  [[nodiscard]] unsigned long shape_changes() const override { return 0; }
  [[nodiscard]] unsigned long changes() const override { return changes_; }
  /// A step is a 240th of a second.
  [[nodiscard]] LiveTime live_time() const override;

  /// Goes on in time; stops playing at the end.
  MotionQuality step(long count, const Progress& progress) override;
  /// Any time from the first instant to the last one.
  double seek(double t) override;
  void reset() override;

 protected:
  /// @param times  of the instants that were kept: at least one, rising [s] (instants)
  explicit RecordedTimeline(std::vector<double> times);

  [[nodiscard]] double shown() const { return t_; }  // [s]
  /// The instant that is nearest to what is shown.
  [[nodiscard]] std::size_t nearest() const { return nearest_; }
  /// Position between two instants: a share of the way from one to the other.
  struct Between {
    std::size_t from = 0, to = 0;  // instants; the same one where it is one of them
    double share = 0;              // [1]
  };
  [[nodiscard]] Between between() const;
  /// A number that goes straight between two instants. @param at  its value at an instant
  template <class At>
  [[nodiscard]] double straight_number(const At& at) const {
    const Between now = between();
    const double from = at(now.from);
    return now.from == now.to ? from : from + now.share * (at(now.to) - from);
  }
  /// Interpolates linearly between two instants. @param rows  (instants, numbers)
  [[nodiscard]] Eigen::VectorXd straight(const Eigen::MatrixXd& rows) const;

 private:
  std::vector<double> times_;
  double t_ = 0;             // that is shown [s]
  std::size_t nearest_ = 0;  // instant
  unsigned long changes_ = 0;
};

}  // namespace thenar
