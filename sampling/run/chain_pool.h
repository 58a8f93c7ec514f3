#pragma once

/// Where a chain stands, and what the target says there: what swaps of tempering hand on.

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

struct ChainState {
  Eigen::VectorXd x;
  Densities at;  // of this one point
};

/// Appends position, log prior, log likelihood, and gradients if there are any.
void append_chain_state(const ChainState& chain_state, std::vector<double>& to);

/// Takes one out again. @param from  where it begins; afterwards, where the next one does
[[nodiscard]] ChainState read_chain_state(const double*& from, Eigen::Index size,
                                          WithGradient gradient);

// A sampler of a run with what is recorded of it.

/// The sampler of one temperature_index of one group. Only temperature_index 0, whose beta is 1, is
/// recorded.
struct ChainSlot {
  int group = 0, temperature_index = 0;
  std::unique_ptr<Sampler> sampler;
  SwapCounts swap_counts;        // of the group, since warm-up or the last change of the ladder
  std::vector<double> pending;   // draws not taken yet: columns of all its chains (draw_rows.h)
  std::vector<StepStats> since;  // the last draw: evaluations, non_finite, divergent (chains)
  long divergent = 0;            // steps after warm-up, of all its chains

  /// To be called after each step. Every `thin`-th after warm-up is a draw.
  void record(long warm_up, int thin);

  /// All pending draws (rows of a draw * chains, draws); none are pending afterwards.
  [[nodiscard]] Eigen::MatrixXd take();

  [[nodiscard]] std::vector<ChainState> chain_states() const;

  /// Another beta, and swaps counted anew.
  void set_beta(double beta);

  void save(StateWriter& to) const;
  void restore(StateReader& from);
};

// The samplers of a run that one rank advances: its share of groups x temperatures.

/// Sampler k = group * temperatures + temperature_index. Communicator have consecutive ones, and so
/// have the threads of a rank: where there are enough groups for all, nobody waits for another at a
/// swap.
class ChainPool {
 public:
  /// Keeps references to all but `starts`.
  ChainPool(const Target& target, const Eigen::MatrixXd& starts, const RunOptions& options,
            const Communicator& ranks);

  [[nodiscard]] long step() const { return step_; }
  [[nodiscard]] int size() const { return target_.size(); }

  /// Brings all samplers to `step`, with the swaps on the way and that of `step` itself. Every rank
  /// must call it alike.
  void advance_to(long step);

  /// Draws since the last call, of each group whose temperature_index 0 is dealt here, in their
  /// order.
  [[nodiscard]] std::vector<Eigen::MatrixXd> take_draws();

  /// State of each sampler dealt here, in their order.
  [[nodiscard]] std::vector<std::string> save() const;
  /// @param all  states of all samplers of all ranks
  /// @throws InputError if they do not fit.
  void restore(long step, const Eigen::VectorXd& beta, const std::vector<std::string>& all);

  [[nodiscard]] const Eigen::VectorXd& beta() const { return beta_; }
  [[nodiscard]] long divergent()
      const;  // steps of temperature_index 0 after warm-up, of the groups dealt here
  [[nodiscard]] Eigen::VectorXd swap_rates()
      const;  // of the groups dealt here, one after the other

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
  int first_ = 0;  // number of the first sampler dealt here
  std::vector<ChainSlot> slots_;
  std::unique_ptr<ThreadPool> pool_;
  bool split_ranks_ = false, split_threads_ = false;  // does a group belong to several?
  long step_ = 0;
};

}  // namespace thenar::internal
