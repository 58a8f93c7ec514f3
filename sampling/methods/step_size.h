#pragma once

/// Adaptation of the leapfrog step size.

#include "sampling/methods/state_bytes.h"

namespace thenar::internal {

/// Dual averaging: adapts the logarithm of the step size until the mean acceptance is on target.
/// Source: [Hoffman2014, section 3.2], with its gamma = 0.05, t0 = 10, kappa = 0.75.
class DualAveraging {
 public:
  explicit DualAveraging(double target) : target_(target) {}

  /// Resets everything except an initial step size.
  /// @param bias  multiple of `step` towards which the iteration is biased [1]
  void restart(double step, double bias);
  /// Adapts to the acceptance of a step.
  /// @param acceptance  acceptance probability of the last step, 0..1
  /// @param max_step    maximum step size [1]
  void learn(double acceptance, double max_step);

  [[nodiscard]] double step() const;           // step size to try next [1]
  [[nodiscard]] double averaged_step() const;  // averaged step size, to use after adaptation [1]

  void save(StateWriter& to) const;
  void restore(StateReader& from);

 private:
  double target_;            // target acceptance [1]
  double count_ = 0;         // number of adaptations [1]
  double log_bias_ = 0;      // logarithm of the step size towards which the iteration is biased [1]
  double error_ = 0;         // weighted mean of target - acceptance; early ones weigh less [1]
  double log_step_ = 0;      // logarithm of the step size to try next [1]
  double log_averaged_ = 0;  // logarithm of the averaged step size [1]
};

/// Search for an initial step size: doubled or halved until the acceptance of one leapfrog step
/// crosses 0.8. Source: [Hoffman2014, algorithm 4], with Stan's 0.8 instead of 0.5 [Carpenter2017].
class StepSearch {
 public:
  /// Starts a search at a step size [1].
  void start(double step);
  /// Updates the search.
  /// @param energy_error  energy error of a leapfrog step of this size with a new momentum [1]
  /// @return whether the search is over
  bool learn(double energy_error);

  [[nodiscard]] double step() const { return step_; }
  [[nodiscard]] int trial_count() const { return trial_count_; }

 private:
  double step_ = 1;      // step size to try next [1]
  int trial_count_ = 0;  // number of trials so far
  bool grow_ = false;    // direction of the search: the step size is doubled
};

}  // namespace thenar::internal
