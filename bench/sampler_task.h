#pragma once

/// The posterior that samplers are timed on, and runs of ours and of a rival.

#include <vector>

#include "posterior/find_modes.h"
#include "posterior/hand_posterior.h"
#include "sampling/run/run_chains.h"

namespace thenar::bench {

/// The thumb of tests/posterior/thumb_scene.h: 20 entries, 54 forces. Its noise is known and tilts
/// of axes are normal beforehand, so that a rival can write the density down in three lines.
[[nodiscard]] HandPosterior thumb_posterior();

/// Processor time of this process, which is wall time where one thread has a core of its own [s].
[[nodiscard]] double processor_seconds();

/// What is found before sampling, as `thenar fit --method nuts` does by default.
struct Prepared {
  std::vector<Mode> modes;
  Eigen::MatrixXd covariance;  // of the best mode, by x (n, n)
  Eigen::MatrixXd starts;      // about the modes, entries of x (n, chains)
  double seconds = 0;          // that all of it took [s]
};
[[nodiscard]] Prepared prepare(const HandPosterior& posterior, int chains, unsigned seed);

/// One run of some sampler.
struct TimedRun {
  double before = 0, warm_up = 0, sampling = 0;  // of mode search, of steps [s]
  double r_hat = 0, ess = 0;                     // worst of all entries, least bulk ESS [1]
  Eigen::VectorXd mean, sd;                      // of the entries of x (n)

  [[nodiscard]] double seconds() const { return before + warm_up + sampling; }
};

/// Means, r_hat and ess of chains (n, draws).
void judge(const std::vector<Eigen::MatrixXd>& chains, TimedRun& run);

/// Ours, on one thread, with modes and metric found beforehand.
[[nodiscard]] TimedRun run_ours(const HandPosterior& posterior, RunOptions options);

/// What Haario's sampler is told. From draws of the prior it does not converge in a million steps.
enum class Told {
  kStarts,  // our starts about the modes; the first guess has sds of 0.001, the best of those tried
  kAll      // our starts, and the covariance there
};
struct RivalRun {
  Told told = Told::kStarts;
  int chains = 4;
  long warm_up = 0, steps = 0;  // of each chain [1]
  unsigned seed = 1;
};

/// Haario's adaptive Metropolis on the scalar density, one chain after the other.
[[nodiscard]] TimedRun run_metropolis(const HandPosterior& posterior, const RivalRun& options);

}  // namespace thenar::bench
