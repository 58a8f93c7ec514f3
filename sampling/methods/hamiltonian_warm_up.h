#pragma once

/// Adaptation of step size and metric during the warm-up of Hamiltonian chains.

#include <vector>

#include "sampling/methods/learn_whitening.h"
#include "sampling/methods/step_size.h"

namespace thenar::internal {

/// Windows of warm-up steps whose draws estimate the metric.
struct MetricWindows {
  long first = 0;          // draws of later steps are gathered
  std::vector<long> ends;  // after each of these the metric is learnt anew; each twice as far
};

/// Returns windows in the manner of Stan: some steps find the typical set, windows that double in
/// length learn the metric, and the last steps settle the step size. Two numbers depart from
/// Stan's: 20 steps to begin with instead of 75, since the estimate of the first window is
/// forgotten after the next; the last 50 steps are at most 35 % of a short warm-up instead of 10 %.
/// A warm-up below 20 steps has no window.
/// @param first_window  least length of the first window [steps]
/// Source: [Carpenter2017] for the scheme.
[[nodiscard]] MetricWindows metric_windows(long warm_up, int first_window);

/// Metric and step size of one chain.
class WarmUp {
 public:
  WarmUp(const Eigen::VectorXd& start, double target_acceptance, const SamplerOptions& options);

  [[nodiscard]] const Whitening& whitening() const { return whitening_; }
  /// Step size of the next trajectory or trial, in whitened units; along orbits at most 0.4 pi,
  /// less than a quarter turn [1].
  [[nodiscard]] double step() const;

  /// Returns whether the next leapfrog is a trial in the search for a first step size: at the start
  /// of warm-up, and after each change of the metric.
  [[nodiscard]] bool searching() const { return searching_; }
  [[nodiscard]] int tries() const { return search_.tries(); }
  void learn_trial(double energy_error);

  /// Call after every step; steps after warm-up have no effect.
  /// @param step      number of the step, from 1
  /// @param gradient  of the log density at x (n)
  /// @return whether whitening() has changed.
  bool learn(long step, const Eigen::VectorXd& x, const Eigen::VectorXd& gradient,
             double acceptance);

  /// Call after learn(), at every step and also for chains that cannot learn: from the last step of
  /// warm-up on, metric and step size stay. An unfinished search for a step size (a chain that
  /// found no density) ends with the step that it would have tried next.
  void settle(long step);

  /// Returns whether the metric is final after this many steps.
  [[nodiscard]] bool metric_settled(long steps) const;

  void save(StateWriter& to) const;
  void restore(StateReader& from);

 private:
  [[nodiscard]] double greatest_step() const;
  bool learn_metric();

  long steps_;  // of the warm-up [1]
  MetricWindows windows_;
  Whitening whitening_;
  WindowDraws draws_;
  DualAveraging averaging_;
  StepSearch search_;
  double step_ = 1;  // [1]
  bool searching_ = true;
};

}  // namespace thenar::internal
