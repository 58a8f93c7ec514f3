#pragma once

/// Restart of chains with smaller steps when a trajectory diverges.

#include <vector>

#include "sampling/run/run_chains.h"

namespace thenar {

/// Draws of the last attempt, and the abandoned attempts.
struct RetriedDraws {
  Draws draws;
  double target_acceptance =
      0;  // target acceptance of the attempt that made the draws; 0: default of the method [1]
  std::vector<double> abandoned;  // target acceptances of attempts that ended at a divergence [1]
};

/// Runs all chains as run_chains() does. As soon as a step after warm-up diverges, the attempt is
/// abandoned, and all chains restart from the same starting points with the next target acceptance.
/// The last attempt runs to its end even if it diverges, which its draws record.
///
/// A divergence means that the leapfrog step is too long for a region, which the chain then visits
/// too rarely; a higher target acceptance gives shorter steps [Betancourt2017]. Draws of different
/// attempts are never mixed, and the number of attempts depends on seeds and data only, not on
/// timing or ranks.
///
/// Later attempts keep their checkpoints in FOLDER/acceptance_<target>. A repeated call resumes the
/// attempt that was interrupted.
/// @param target_acceptances  further targets, ascending; those not above the first attempt's are
///                            skipped. If empty, or for a method without trajectories: run_chains()
/// @throws InputError if they are not ascending within 0..1; and as run_chains() does
[[nodiscard]] RetriedDraws retry_divergent(const Target& target, const Eigen::MatrixXd& starts,
                                           const RunOptions& options,
                                           const std::vector<double>& target_acceptances,
                                           const Communicator& ranks);

}  // namespace thenar
