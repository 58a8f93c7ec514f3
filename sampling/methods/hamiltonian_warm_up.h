#pragma once

/// What Hamiltonian chains learn before they sample: step size and metric.

#include <vector>

#include "sampling/methods/mass_matrix.h"
#include "sampling/methods/step_size.h"

namespace thenar::internal {

/// Steps between which draws are gathered for the metric.
struct MetricWindows {
  long first = 0;          // draws of later steps are gathered
  std::vector<long> ends;  // after each of these the metric is learnt anew; each twice as far
};

/// In the manner of Stan: some steps find the typical set, windows that double learn the metric,
/// and the last steps settle the step size. Departs from its numbers: 20 steps to begin with, where
/// Stan takes 75, since what a first window learnt is forgotten after the next; the last 50 are at
/// most 35 % of a short warm-up, not 10 %. Below 20 steps there is no window.
/// @param first_window  least length of the first [1]
/// Source: [Carpenter2017] for the scheme.
[[nodiscard]] MetricWindows metric_windows(long warm_up, int first_window);

/// Metric and step size of one chain.
class WarmUp {
 public:
  WarmUp(int n, double target_acceptance, const SamplerOptions& options);

  [[nodiscard]] const MassMatrix& metric() const { return metric_; }
  /// Of the leapfrog of the next trajectory or trial, in whitened units [1].
  [[nodiscard]] double step() const { return searching_ ? search_.step() : step_; }

  /// Whether the next leapfrog is a trial that looks for a step size to begin with. The metric has
  /// just changed then, or nothing was learnt yet.
  [[nodiscard]] bool searching() const { return searching_; }
  [[nodiscard]] int tries() const { return search_.tries(); }
  void learn_trial(double energy_error);

  /// To be told of every step of the warm-up; later ones are ignored.
  /// @param step  its number, from 1
  void learn(long step, const Eigen::VectorXd& x, double acceptance);

  /// To be told of every step, after learn(), and of those of chains that cannot learn, too: from
  /// the last of the warm-up on, metric and step size stay. A search for a step size that is not
  /// over, as of a chain that found no density, ends with what it would have tried next.
  void settle(long step);

  /// Whether the metric is final after this many steps.
  [[nodiscard]] bool metric_settled(long steps) const;

  void save(StateWriter& to) const;
  void restore(StateReader& from);

 private:
  void learn_metric();

  long steps_;  // of the warm-up [1]
  MetricWindows windows_;
  MassMatrix metric_;
  CovarianceEstimate estimate_;
  DualAveraging averaging_;
  StepSearch search_;
  double step_ = 1;  // [1]
  bool searching_ = true;
};

}  // namespace thenar::internal
