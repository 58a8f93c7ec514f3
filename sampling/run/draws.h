#pragma once

/// Draws of a run, with the statistics of their steps.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "sampling/methods/sampler.h"

namespace thenar {

/// Draws of the sampling phase of several chains, in memory.
struct Draws {
  std::vector<Eigen::MatrixXd> x;  // draws of each chain (n, draws)
  // Statistics of each chain and draw; evaluations, non_finite and divergent cover all steps since
  // the previous draw, of the chain at beta = 1 only, without hotter chains.
  std::vector<std::vector<StepStats>> stats;
  std::vector<int> group;  // group of each chain: walkers of one ensemble share theirs
  Eigen::VectorXd beta;    // powers of the likelihood, 1 first; one entry: no tempering
  Eigen::MatrixXd
      swap_rate;          // accepted share of swaps between neighbours (temperatures - 1, groups)
  long warm_up = 0;       // number of steps before the first draw
  bool complete = false;  // the run made all draws that were requested
  bool ended_at_divergence =
      false;           // the run ended early, see RunOptions::end_at_divergence; equal on all ranks
  double seconds = 0;  // wall time of warm-up and sampling, summed over resumes [s]

  [[nodiscard]] int size() const { return x.empty() ? 0 : static_cast<int>(x[0].rows()); }
  [[nodiscard]] int chains() const { return static_cast<int>(x.size()); }
  [[nodiscard]] long draws() const { return x.empty() ? 0 : x[0].cols(); }

  /// Returns coordinate i of all draws (draws, chains).
  [[nodiscard]] Eigen::MatrixXd coordinate(int i) const;
};

}  // namespace thenar

namespace thenar::internal {

/// Returns the number of rows of a column that stores one draw: its statistics, then its position.
[[nodiscard]] Eigen::Index rows_of_draw(Eigen::Index size);

/// Appends a draw as such a column. @param to  numbers of a stream
void put_draw(const StepStats& stats, const Eigen::Ref<const Eigen::VectorXd>& x,
              std::vector<double>& to);

/// Returns the statistics of a draw, from its first rows.
[[nodiscard]] StepStats stats_of(const Eigen::Ref<const Eigen::VectorXd>& draw);

/// Returns the position of a draw (size).
[[nodiscard]] Eigen::VectorXd position_of(const Eigen::Ref<const Eigen::VectorXd>& draw);

}  // namespace thenar::internal
