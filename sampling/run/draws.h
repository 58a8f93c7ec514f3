#pragma once

/// What a run leaves behind.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "sampling/methods/sampler.h"

namespace thenar {

/// Draws of the sampling phase of several chains, in memory.
struct Draws {
  std::vector<Eigen::MatrixXd> x;  // of each chain (n, draws)
  // Of each chain and draw; evaluations, non_finite and divergent of all steps since the draw
  // before, those of the posterior's own chain alone: what hotter chains of tempering cost is not
  // counted.
  std::vector<std::vector<StepStats>> stats;
  std::vector<int> group;     // of each chain: walkers of one ensemble share theirs
  Eigen::VectorXd beta;       // powers of the likelihood, 1 first; one entry: no tempering
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

namespace thenar::internal {

// One draw of one chain as a column of numbers: its statistics, then its position.

/// Rows of a draw of `size` coordinates.
[[nodiscard]] Eigen::Index rows_of_draw(Eigen::Index size);

/// Appends a draw. @param to  numbers of a stream
void put_draw(const StepStats& stats, const Eigen::Ref<const Eigen::VectorXd>& x,
              std::vector<double>& to);

/// The statistics of a draw, from its first rows.
[[nodiscard]] StepStats stats_of(const Eigen::Ref<const Eigen::VectorXd>& draw);

/// The position of a draw (size).
[[nodiscard]] Eigen::VectorXd position_of(const Eigen::Ref<const Eigen::VectorXd>& draw);

}  // namespace thenar::internal
