#pragma once

/// Chains that begin anew with smaller steps when a trajectory diverges.

#include <vector>

#include "sampling/run/run_chains.h"

namespace thenar {

/// The draws of the last attempt, and the attempts before it.
struct RetriedDraws {
  Draws draws;
  double target_acceptance = 0;   // of the attempt that made the draws; 0: the method's own [1]
  std::vector<double> abandoned;  // target acceptances of attempts that ended at a divergence [1]
};

/// Runs all chains as run_chains() does. As soon as a step after warm-up diverges, the attempt is
/// abandoned, and all chains begin anew from the same starts at the next target acceptance. The
/// last attempt runs to its end, whether it diverges or not: its draws say so.
///
/// A divergence means that the leapfrog is too long for a region, which the chain then visits too
/// seldom; a higher target acceptance gives shorter leapfrogs [Betancourt2017]. Draws of different
/// attempts are never mixed, and which attempt is the last depends on seeds and data alone, not on
/// times or ranks.
///
/// Later attempts keep their checkpoints in FOLDER/acceptance_<target>. The same call goes on with
/// the attempt that was interrupted.
/// @param target_acceptances  to go on with, ascending; those not above the first attempt's are
///                            left out. Empty, or a method without trajectories: run_chains()
/// @throws InputError if they are not ascending within 0..1; and as run_chains() does
[[nodiscard]] RetriedDraws retry_divergent(const Target& target, const Eigen::MatrixXd& starts,
                                           const RunOptions& options,
                                           const std::vector<double>& target_acceptances,
                                           const Communicator& ranks);

}  // namespace thenar
