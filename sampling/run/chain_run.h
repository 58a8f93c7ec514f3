#pragma once

/// The run of all chains on one rank: legs of steps, and checkpoints between them.

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "sampling/run/chain_pool.h"
#include "sampling/run/run_folder.h"

namespace thenar::internal {

/// A run on one rank. Every member that gathers must be called by all ranks alike.
class ChainRun {
 public:
  /// Keeps references to all arguments except `starts`; they must outlive it.
  /// @param folder  of rank 0, if anything is to be kept
  ChainRun(const Target& target, const Eigen::MatrixXd& starts, const RunOptions& options,
           const Communicator& ranks, std::optional<RunFolder>& folder);

  /// Continues from the checkpoint, if there is one.
  void resume();

  /// Runs to the end, or until a stop request.
  void go();

  /// All draws so far on rank 0, none on the others.
  [[nodiscard]] Draws result() const;

 private:
  void leg();
  void agree(double seconds, long steps);
  void report() const;
  void checkpoint();

  /// New draws of each group, and states of the samplers where there is a folder.
  struct Gathered {
    std::vector<Eigen::MatrixXd> draws;
    std::vector<std::string> states;
  };
  /// Returns the results of all ranks on rank 0, none on the others.
  [[nodiscard]] Gathered gather(const Gathered& mine) const;

  [[nodiscard]] std::string state(const std::vector<std::string>& samplers) const;
  [[nodiscard]] Eigen::MatrixXd draws_of(std::size_t group) const;
  [[nodiscard]] bool ended_at_divergence() const;  // on all ranks alike
  [[nodiscard]] bool first() const { return ranks_.rank() == 0; }

  const RunOptions& options_;
  const Communicator& ranks_;
  std::optional<RunFolder>& folder_;
  ChainPool samplers_;
  Eigen::Index rows_;                               // of a draw of one chain
  long total_;                                      // steps, with warm-up
  std::vector<std::vector<Eigen::MatrixXd>> kept_;  // of each group, where there is no folder

  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now(),
                                        last_checkpoint_ = start_;
  double seconds_before_ = 0;  // of the runs that this one goes on from [s]
  long saved_step_ = 0;
  double seconds_per_step_ = 0;  // of the last leg [s]
  long next_leg_ = 1;            // steps
  long divergent_ = 0;           // steps of all groups, after warm-up
  // What the ranks agreed on after the last leg.
  bool stop_ = false, checkpoint_due_ = false;
};

}  // namespace thenar::internal
