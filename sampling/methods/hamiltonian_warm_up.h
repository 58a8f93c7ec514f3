#pragma once

/// Adaptation of step size and metric during the warm-up of Hamiltonian chains.

#include <vector>

#include "sampling/methods/learn_whitening.h"
#include "sampling/methods/step_size.h"

namespace thenar::internal {

/// Windows of warm-up steps whose draws estimate the metric.
struct MetricWindows {
  long first = 0;          // number of the last step that is not used
  std::vector<long> ends;  // steps after which the metric is updated; each window is twice as long
};

/// Returns windows in the manner of Stan: initial steps find the typical set, windows of doubling
/// length estimate the metric, and the last steps adapt the step size. Two numbers differ from
/// Stan's: 20 initial steps instead of 75, because the estimate of the first window is discarded
/// after the next; and the last 50 steps are at most 35 % of a short warm-up instead of 10 %. A
/// warm-up below 20 steps has no window.
/// @param first_window  minimum length of the first window [steps]
/// Source: [Carpenter2017] for the scheme.
[[nodiscard]] MetricWindows metric_windows(long warm_up, int first_window);

/// Adaptation of the metric and step size of one chain.
class WarmUp {
 public:
  WarmUp(const Eigen::VectorXd& start, double target_acceptance, const SamplerOptions& options);

  [[nodiscard]] const Whitening& whitening() const { return whitening_; }
  /// Returns the step size of the next trajectory or trial, in whitened units; along orbits at most
  /// 0.4 pi, less than a quarter turn [1].
  [[nodiscard]] double step() const;

  /// Returns whether the next leapfrog step is a trial in the search for an initial step size: at
  /// the start of warm-up, and after each change of the metric.
  [[nodiscard]] bool searching() const { return searching_; }
  /// Returns the number of trials of the current search.
  [[nodiscard]] int trial_count() const { return search_.trial_count(); }
  /// Continues the search with the energy error of a trial [1].
  void learn_trial(double energy_error);

  /// Adapts to a step. Call after every step; steps after warm-up have no effect.
  /// @param step      number of the step, from 1
  /// @param gradient  gradient of the log density at x (n)
  /// @return whether whitening() has changed.
  bool learn(long step, const Eigen::VectorXd& x, const Eigen::VectorXd& gradient,
             double acceptance);

  /// Fixes metric and step size from the last step of warm-up on. Call after learn(), at every
  /// step, also for chains that cannot learn. An unfinished search for a step size (in a chain that
  /// found no density) ends with the step size that it would have tried next.
  void freeze_after_warm_up(long step);

  /// Returns whether the metric is final after `steps` steps.
  [[nodiscard]] bool metric_settled(long steps) const;

  void save(StateWriter& to) const;
  void restore(StateReader& from);

 private:
  [[nodiscard]] double max_step() const;
  bool learn_metric();

  long steps_;  // length of the warm-up [steps]
  MetricWindows windows_;
  Whitening whitening_;
  WindowDraws draws_;
  DualAveraging averaging_;
  StepSearch search_;
  double step_ = 1;  // step size found by the last search [1]
  bool searching_ = true;
};

}  // namespace thenar::internal
