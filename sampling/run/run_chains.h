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
  SamplerOptions sampler;          // seed, warm-up, metric; beta and first_chain are set by the run
  int groups = 4;                  // independent chains, or ensembles [1]
  int walkers = 1;                 // chains of one ensemble; 1 for methods of single chains [1]
  int temperatures = 1;            // 1: no tempering [1]
  double min_beta = 0;             // power of the likelihood of the hottest; 0: the prior [1]
  int swap_every = 1;              // steps between swaps [1]
  long draws = 1000;               // of each chain, after thinning [1]
  int thin = 1;                    // steps a draw [1]
  std::string folder;              // of checkpoints and streams; empty: in memory only
  double checkpoint_every = 10;    // [s]
  bool end_at_divergence = false;  // return early, incomplete, once a step after warm-up diverges
  int threads = 0;                 // 0: as many as fill batches and processors; 1 if there are
                                   // several ranks [1]
  std::string fingerprint;         // of target and data; a checkpoint with another one is refused
  Progress progress;
};

/// Runs all chains, or resumes a run. Streams and checkpoints go to `folder`; if the process is
/// killed at any moment, the same call continues from there and ends with the same draws, to the
/// bit. A stop request writes a checkpoint and returns the draws so far (Draws::complete is false).
///
/// The ladder of temperatures keeps its ends; during warm-up the inner temperatures move to where
/// all neighbours swap about equally often (Draws::beta).
///
/// Samplers (groups x temperatures) are distributed over ranks; rank 0 returns all draws, the
/// others none. Only rank 0 needs the folder. A resumed run may request more draws and use other
/// threads, ranks and times between checkpoints; any other difference is refused.
///
/// An error of a single rank ends all ranks (Communicator::abort); an error that all ranks meet is
/// thrown.
/// @param starts  one column for each walker of each group; all temperatures start from the same
///                (n, groups * walkers)
/// @throws CheckpointError if a checkpoint belongs to another run or is damaged.
/// @throws InputError if options do not fit together, another process works in the folder, or
/// nothing can be written there.
[[nodiscard]] Draws run_chains(const Target& target, const Eigen::MatrixXd& starts,
                               const RunOptions& options, const Communicator& ranks);

/// Runs the chains in this process alone.
[[nodiscard]] Draws run_chains(const Target& target, const Eigen::MatrixXd& starts,
                               const RunOptions& options);

}  // namespace thenar
