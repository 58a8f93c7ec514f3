#pragma once

/// Adaptation of the leapfrog's step size.

#include "sampling/methods/state_bytes.h"

namespace thenar::internal {

/// Dual averaging: moves the logarithm of the step size until the mean acceptance is on target.
/// Source: [Hoffman2014, section 3.2], with its gamma = 0.05, t0 = 10, kappa = 0.75.
class DualAveraging {
 public:
  explicit DualAveraging(double target) : target_(target) {}

  /// Forgets everything except a first step size.
  /// @param lean  multiple of `step` that the search leans towards [1]
  void restart(double step, double lean);
  /// @param acceptance  of the last step, 0..1
  /// @param most        step size that none shall exceed [1]
  void learn(double acceptance, double most);

  [[nodiscard]] double step() const;      // to be tried next [1]
  [[nodiscard]] double averaged() const;  // to stay with [1]

  void save(StateWriter& to) const;
  void restore(StateReader& from);

 private:
  double target_;            // acceptance [1]
  double count_ = 0;         // of what was learnt [1]
  double lean_ = 0;          // logarithm of the step that is leant towards [1]
  double error_ = 0;         // mean of target - acceptance, early ones weigh less [1]
  double log_step_ = 0;      // [1]
  double log_averaged_ = 0;  // [1]
};

/// Search for a first step size: doubled or halved until the acceptance of one leapfrog crosses
/// 0.8.  Source: [Hoffman2014, algorithm 4], with Stan's 0.8 for its 0.5 [Carpenter2017].
class StepSearch {
 public:
  void start(double step);
  /// @param energy_error  of a leapfrog of this step, with a fresh momentum [1]
  /// @return whether the search is over.
  bool learn(double energy_error);

  [[nodiscard]] double step() const { return step_; }
  [[nodiscard]] int tries() const { return tries_; }

 private:
  double step_ = 1;
  int tries_ = 0;
  bool grow_ = false;
};

}  // namespace thenar::internal
