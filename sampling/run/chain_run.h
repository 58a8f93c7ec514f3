#pragma once

/// Run of all chains on one rank: legs of steps, and checkpoints between them.

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "sampling/run/chain_pool.h"
#include "sampling/run/run_folder.h"

namespace thenar::internal {

/// Run on one rank. Every member that gathers is collective: all ranks must call it.
class ChainRun {
 public:
  /// Keeps references to all arguments except `starts`; they must outlive it.
  /// @param folder  run folder on rank 0, if anything is to be kept
  ChainRun(const Target& target, const Eigen::MatrixXd& starts, const RunOptions& options,
           const Communicator& ranks, std::optional<RunFolder>& folder);

  /// Continues from the checkpoint, if there is one.
  void resume();

  /// Runs to the end, or until a stop request.
  void run_to_end();

  /// Returns all draws so far on rank 0, none on the others.
  [[nodiscard]] Draws result() const;

 private:
  void run_leg();
  void agree_on_next_leg(double seconds, long steps);
  void report() const;
  void checkpoint();

  /// New draws of each group, and states of the samplers if there is a folder.
  struct Gathered {
    std::vector<Eigen::MatrixXd> draws;
    std::vector<std::string> states;
  };
  /// Gathers the results of all ranks on rank 0; returns nothing on the others.
  [[nodiscard]] Gathered gather(const Gathered& mine) const;

  [[nodiscard]] std::string state(const std::vector<std::string>& samplers) const;
  [[nodiscard]] Eigen::MatrixXd draws_of(std::size_t group) const;
  [[nodiscard]] bool ended_at_divergence() const;  // equal on all ranks
  [[nodiscard]] bool is_root() const { return ranks_.rank() == 0; }

  const RunOptions& options_;
  const Communicator& ranks_;
  std::optional<RunFolder>& folder_;
  ChainPool samplers_;
  Eigen::Index rows_;                               // rows of the column of a draw
  long total_;                                      // number of steps, with warm-up
  std::vector<std::vector<Eigen::MatrixXd>> kept_;  // draws of each group if there is no folder

  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now(),
                                        last_checkpoint_ = start_;
  double seconds_before_ = 0;    // wall time of the runs that this one continues [s]
  long saved_step_ = 0;          // step of the last checkpoint
  double seconds_per_step_ = 0;  // wall time per step of the last leg [s]
  long next_leg_ = 1;            // length of the next leg [steps]
  long divergent_ = 0;           // number of divergent steps of all groups after warm-up
  // Decisions that the ranks agreed on after the last leg.
  bool stop_ = false, checkpoint_due_ = false;
};

}  // namespace thenar::internal
