#pragma once

/// Warm-up and sampling of many chains and temperatures: threads, ranks, checkpoints.

#include <functional>
#include <string>

#include "base/error.h"
#include "base/progress.h"
#include "sampling/run/communicator.h"
#include "sampling/run/draws.h"

namespace thenar {

/// The folder of a run holds the checkpoint of another one, or a damaged one.
class CheckpointError : public InputError {
 public:
  enum class Kind {
    kOtherRun,  // sound, but of a run with other data or options: that one can go on with it
    kDamaged    // nothing can go on with it
  };
  CheckpointError(Kind kind, const std::string& message) : InputError(message), kind_(kind) {}
  [[nodiscard]] Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

struct RunOptions {
  SamplingMethod method = SamplingMethod::kNuts;
  SamplerOptions sampler;        // seed, warm-up, metric; beta and first_chain are set by the run
  int groups = 4;                // independent chains, or ensembles [1]
  int walkers = 1;               // chains of one ensemble; 1 unless the method is one [1]
  int temperatures = 1;          // 1: no tempering [1]
  double min_beta = 0;           // power of the likelihood of the hottest; 0: the prior [1]
  int swap_every = 1;            // steps between swaps [1]
  long draws = 1000;             // of each chain, after thinning [1]
  int thin = 1;                  // steps a draw [1]
  std::string folder;            // of checkpoints and streams; empty: in memory only
  double checkpoint_every = 10;  // [s]
  int threads = 0;               // 0: as many as fill lanes and processors; 1 of several ranks [1]
  std::string fingerprint;       // of target and data: a checkpoint of another one is refused
  Progress progress;
};

/// Runs or resumes. Streams and checkpoints go to `folder`; killed at any moment, the same call
/// goes on from there and ends with the same draws, to the bit. A stop request checkpoints and
/// returns what there is (Draws::complete is false).
///
/// The ladder of temperatures keeps its ends; in warm-up those between them move to where all
/// neighbours swap about equally often (Draws::beta).
///
/// Samplers (groups x temperatures) are dealt to ranks; rank 0 returns all draws, the others none.
/// Only rank 0 needs the folder. It may be asked for more draws than before, and goes on; threads,
/// ranks and the time between checkpoints may change as well. Whatever else differs is refused.
///
/// An error of one rank alone ends all ranks (Communicator::abort); one that all of them meet is
/// thrown.
/// @param starts  one column for each walker of each group; hotter rungs start from the same
/// (n, groups * walkers)
/// @throws CheckpointError if a checkpoint belongs to another run or is damaged.
/// @throws InputError if options do not fit together, another process works in the folder, or
/// nothing can be written there.
[[nodiscard]] Draws run_chains(const Target& target, const Eigen::MatrixXd& starts,
                               const RunOptions& options, const Communicator& ranks);

/// The same in this process.
[[nodiscard]] Draws run_chains(const Target& target, const Eigen::MatrixXd& starts,
                               const RunOptions& options);

}  // namespace thenar
