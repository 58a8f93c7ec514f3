#pragma once

/// Samplers of a run that one rank advances: its share of groups x temperatures.

#include <memory>
#include <string>
#include <vector>

#include "base/thread_pool.h"
#include "sampling/methods/parallel_tempering.h"
#include "sampling/methods/sampler.h"
#include "sampling/methods/target.h"
#include "sampling/run/communicator.h"
#include "sampling/run/run_chains.h"

namespace thenar::internal {

/// Position of a chain and the log densities there; swaps exchange it between temperatures.
struct ChainState {
  Eigen::VectorXd x;  // (n)
  Densities at;       // densities at x
};

/// Appends position, log prior, log likelihood, and gradients if available.
void append_chain_state(const ChainState& chain_state, std::vector<double>& to);

/// Reads a state. @param from  first number of the state on input, of the next state on output
[[nodiscard]] ChainState read_chain_state(const double*& from, Eigen::Index size,
                                          WithGradient gradient);

/// Sampler of one temperature of one group, and its recorded draws. Only temperature_index 0, whose
/// beta is 1, is recorded.
struct ChainSlot {
  int group = 0, temperature_index = 0;
  std::unique_ptr<Sampler> sampler;
  SwapCounts
      swap_counts;  // swap counts of the group since warm-up or the last change of the ladder
  std::vector<double>
      pending;  // recorded draws not taken yet: columns of all its chains, see put_draw()
  std::vector<StepStats> stats_since_draw;  // evaluations, non_finite and divergent counts since
                                            // the last draw (chains)
  long divergent = 0;  // number of divergent steps after warm-up, of all its chains [1]

  /// Records a step; call it after each one. Every `thin`-th step after warm-up is a draw.
  void record(long warm_up, int thin);

  /// Returns and removes all pending draws (rows of a draw * chains, draws).
  [[nodiscard]] Eigen::MatrixXd take_pending_draws();

  /// Returns position and densities of each chain.
  [[nodiscard]] std::vector<ChainState> chain_states() const;

  /// Sets another beta and resets the swap counts.
  void set_beta(double beta);

  void save(StateWriter& to) const;
  void restore(StateReader& from);
};

/// Samplers k = group * temperatures + temperature_index of one rank. Each rank, and each thread of
/// a rank, has consecutive samplers: if there are enough groups for all, no thread waits for
/// another at a swap.
class ChainPool {
 public:
  /// Keeps references to `target`, `options` and `ranks`, which must outlive it.
  ChainPool(const Target& target, const Eigen::MatrixXd& starts, const RunOptions& options,
            const Communicator& ranks);

  [[nodiscard]] long step() const { return step_; }
  [[nodiscard]] int size() const { return target_.size(); }

  /// Advances all samplers to `step`, including the swaps before and at `step`. Collective: every
  /// rank must call it with the same argument.
  void advance_to(long step);

  /// Returns the draws since the last call, of each group whose temperature_index 0 is on this
  /// rank, in the order of groups.
  [[nodiscard]] std::vector<Eigen::MatrixXd> take_draws();

  /// Returns the state of each sampler of this rank, in order.
  [[nodiscard]] std::vector<std::string> save() const;
  /// Restores the samplers of this rank.
  /// @param all  states of all samplers of all ranks
  /// @throws InputError if they do not fit.
  void restore(long step, const Eigen::VectorXd& beta, const std::vector<std::string>& all);

  [[nodiscard]] const Eigen::VectorXd& beta() const { return beta_; }
  /// Returns the number of divergent steps of temperature_index 0 after warm-up, of this rank's
  /// groups [1].
  [[nodiscard]] long divergent() const;
  /// Returns the swap rates of this rank's groups, one after another [1] (groups * (temperatures -
  /// 1)).
  [[nodiscard]] Eigen::VectorXd swap_rates() const;

 private:
  [[nodiscard]] ChainSlot build_slot(int number, const Eigen::MatrixXd& starts) const;
  [[nodiscard]] std::vector<std::vector<ChainState>> chain_states(std::size_t from,
                                                                  std::size_t to) const;
  [[nodiscard]] std::vector<std::vector<ChainState>> gather_chain_states() const;
  [[nodiscard]] long next_stop(long from, long step) const;   // step of the next swap, or `step`
  [[nodiscard]] std::size_t first_slot_of(int worker) const;  // index of the worker's first slot
  [[nodiscard]] long next_retuning(long from) const;  // step of the next change of the ladder
  void adapt_ladder();
  void advance_together(long step);  // stops all at each swap if groups are split
  void advance_apart(std::size_t from, std::size_t to,
                     long step);  // advances whole groups independently
  void advance_slots(std::size_t from, std::size_t to, long step);  // without swaps
  void swap(std::size_t from, std::size_t to,
            const std::vector<std::vector<ChainState>>& chain_states, int first_group, long step);

  const Target& target_;
  const RunOptions& options_;
  const Communicator& ranks_;
  Eigen::VectorXd beta_;
  int first_ = 0;  // number of the first sampler of this rank
  std::vector<ChainSlot> slots_;
  std::unique_ptr<ThreadPool> pool_;
  bool split_ranks_ = false,
       split_threads_ = false;  // groups are split over ranks, or over threads
  long step_ = 0;
};

}  // namespace thenar::internal
