#pragma once

/// The samplers of a run that one rank advances: its share of groups x temperatures.

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
  Densities at;       // at x alone
};

/// Appends position, log prior, log likelihood, and gradients if there are any.
void append_chain_state(const ChainState& chain_state, std::vector<double>& to);

/// Reads a state back. @param from  its first number; afterwards the first of the next state
[[nodiscard]] ChainState read_chain_state(const double*& from, Eigen::Index size,
                                          WithGradient gradient);

/// The sampler of one temperature of one group, and its recorded draws. Only temperature_index 0,
/// whose beta is 1, is recorded.
struct ChainSlot {
  int group = 0, temperature_index = 0;
  std::unique_ptr<Sampler> sampler;
  SwapCounts swap_counts;        // of the group, since warm-up or the last change of the ladder
  std::vector<double> pending;   // draws not taken yet: columns of all its chains, see put_draw()
  std::vector<StepStats> since;  // counts since the last draw: evaluations, non_finite, divergent
                                 // (chains)
  long divergent = 0;            // divergent steps after warm-up, of all its chains [1]

  /// Call after each step. Every `thin`-th step after warm-up is a draw.
  void record(long warm_up, int thin);

  /// All pending draws (rows of a draw * chains, draws); none are pending afterwards.
  [[nodiscard]] Eigen::MatrixXd take();

  [[nodiscard]] std::vector<ChainState> chain_states() const;

  /// Sets another beta and starts the counts of swaps anew.
  void set_beta(double beta);

  void save(StateWriter& to) const;
  void restore(StateReader& from);
};

/// Sampler k = group * temperatures + temperature_index. Each rank has consecutive samplers, and so
/// has each thread of a rank: with enough groups for all, no thread waits for another at a swap.
class ChainPool {
 public:
  /// Keeps references to `target`, `options` and `ranks`, which must outlive it.
  ChainPool(const Target& target, const Eigen::MatrixXd& starts, const RunOptions& options,
            const Communicator& ranks);

  [[nodiscard]] long step() const { return step_; }
  [[nodiscard]] int size() const { return target_.size(); }

  /// Advances all samplers to `step`, with the swaps on the way and the swap at `step`. Every rank
  /// must call it alike.
  void advance_to(long step);

  /// Draws since the last call, of each group whose temperature_index 0 is on this rank, in the
  /// order of groups.
  [[nodiscard]] std::vector<Eigen::MatrixXd> take_draws();

  /// State of each sampler of this rank, in their order.
  [[nodiscard]] std::vector<std::string> save() const;
  /// @param all  states of all samplers of all ranks
  /// @throws InputError if they do not fit.
  void restore(long step, const Eigen::VectorXd& beta, const std::vector<std::string>& all);

  [[nodiscard]] const Eigen::VectorXd& beta() const { return beta_; }
  /// Divergent steps of temperature_index 0 after warm-up, of this rank's groups [1].
  [[nodiscard]] long divergent() const;
  /// Swap rates of this rank's groups, one after the other [1] (groups * (temperatures - 1)).
  [[nodiscard]] Eigen::VectorXd swap_rates() const;

 private:
  [[nodiscard]] ChainSlot build_slot(int number, const Eigen::MatrixXd& starts) const;
  [[nodiscard]] std::vector<std::vector<ChainState>> chain_states(std::size_t from,
                                                                  std::size_t to) const;
  [[nodiscard]] std::vector<std::vector<ChainState>> gather_chain_states() const;
  [[nodiscard]] long next_stop(long from, long step) const;  // the next swap, or `step`
  [[nodiscard]] std::size_t share(int worker) const;         // its first slot
  [[nodiscard]] long next_retuning(long from) const;         // step; never: far away
  void retune();
  void advance_together(long step);  // all to each swap, where groups are split
  void advance_apart(std::size_t from, std::size_t to, long step);  // whole groups
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
  bool split_ranks_ = false, split_threads_ = false;  // does a group belong to several?
  long step_ = 0;
};

}  // namespace thenar::internal
