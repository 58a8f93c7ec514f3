#pragma once

/// Warm-up and sampling of many chains and temperatures: threads, ranks, checkpoints.

#include <functional>
#include <string>

#include "base/error.h"
#include "base/progress.h"
#include "sampling/run/communicator.h"
#include "sampling/run/draws.h"

namespace thenar {

/// Thrown if the folder of a run holds the checkpoint of another run, or a damaged one.
class CheckpointError : public InputError {
 public:
  enum class Kind {
    kOtherRun,  // intact, but of a run with other data or options, which can continue from it
    kDamaged    // no run can continue from it
  };
  CheckpointError(Kind kind, const std::string& message) : InputError(message), kind_(kind) {}
  [[nodiscard]] Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

/// Sampler, chains and temperatures of a run, and where it keeps its checkpoints.
struct RunOptions {
  SamplingMethod method = SamplingMethod::kNuts;
  SamplerOptions sampler;  // seed, warm-up, metric; the run sets beta and first_chain
  int groups = 4;          // number of independent chains, or ensembles [1]
  int walkers = 1;         // number of chains in an ensemble; 1 for methods of single chains [1]
  int temperatures = 1;    // number of temperatures; 1: no tempering [1]
  double min_beta = 0;     // power of the likelihood of the hottest chain; 0: the prior [1]
  int swap_every = 1;      // number of steps between swaps [1]
  long draws = 1000;       // number of draws of each chain, after thinning [1]
  int thin = 1;            // number of steps per draw [1]
  std::string folder;      // folder of checkpoints and streams; empty: in memory only
  double checkpoint_every = 10;    // time between checkpoints [s]
  bool end_at_divergence = false;  // return early, incomplete, once a step after warm-up diverges
  int threads = 0;  // number of threads; 0: limited by batches and processors, or 1 if there are
                    // several ranks [1]
  std::string fingerprint;  // hash of target and data; a checkpoint with another one is refused
  Progress progress;
};

/// Runs all chains, or resumes a run. Streams and checkpoints go to `folder`; if the process is
/// killed at any moment, the same call resumes and gives the same draws, to the bit. A stop request
/// writes a checkpoint and returns the draws so far (Draws::complete is false).
///
/// The ladder of temperatures keeps its ends; during warm-up the inner temperatures are adapted
/// until all neighbours swap about equally often (Draws::beta).
///
/// Samplers (groups x temperatures) are distributed over ranks; rank 0 returns all draws, the
/// others none. Only rank 0 needs the folder. A resumed run may request more draws, and use other
/// threads, ranks and times between checkpoints; any other difference is refused.
///
/// An error of a single rank ends all ranks (Communicator::abort); an error common to all ranks is
/// thrown.
/// @param starts  one column for each walker of each group, used by all temperatures
///                (n, groups * walkers)
/// @throws CheckpointError if a checkpoint belongs to another run or is damaged.
/// @throws InputError if options are inconsistent, another process uses the folder, or it is not
///         writable.
[[nodiscard]] Draws run_chains(const Target& target, const Eigen::MatrixXd& starts,
                               const RunOptions& options, const Communicator& ranks);

/// Runs the chains in this process alone.
[[nodiscard]] Draws run_chains(const Target& target, const Eigen::MatrixXd& starts,
                               const RunOptions& options);

}  // namespace thenar
