#pragma once

/// What a run leaves behind.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "sampling/sampler.h"

namespace thenar {

/// Draws of the sampling phase of several chains, in memory.
struct Draws {
  std::vector<Eigen::MatrixXd> x;  // of each chain (n, draws)
  // Of each chain and draw; evaluations, broken and divergent of all steps since the draw before,
  // those of the posterior's own chain alone: what hotter chains of tempering cost is not counted.
  std::vector<std::vector<StepStats>> stats;
  std::vector<int> group;     // of each chain: walkers of one ensemble share theirs
  Eigen::VectorXd temper;     // powers of the likelihood, 1 first; one entry: no tempering
  Eigen::MatrixXd swap_rate;  // accepted share of swaps of neighbours (temperatures - 1, groups)
  long warm_up = 0;           // steps before the first draw
  bool complete = false;      // as many draws as were asked for
  double seconds = 0;         // wall time of warm-up and sampling, summed over resumes [s]

  [[nodiscard]] int size() const { return x.empty() ? 0 : static_cast<int>(x[0].rows()); }
  [[nodiscard]] int chains() const { return static_cast<int>(x.size()); }
  [[nodiscard]] long draws() const { return x.empty() ? 0 : x[0].cols(); }

  /// One coordinate of all (draws, chains).
  [[nodiscard]] Eigen::MatrixXd coordinate(int i) const;
};

}  // namespace thenar
