#pragma once

/// The samplers of a run that one rank advances: its share of groups x temperatures.

#include <memory>
#include <string>
#include <vector>

#include "sampling/ranks.h"
#include "sampling/run_chains.h"
#include "sampling/sampler_slot.h"
#include "sampling/worker_team.h"

namespace thenar::internal {

/// Sampler k = group * temperatures + rung. Ranks have consecutive ones, and so have the threads of
/// a rank: where there are enough groups for all, nobody waits for another at a swap.
class DealtSamplers {
 public:
  /// Keeps references to all but `starts`.
  DealtSamplers(const Target& target, const Eigen::MatrixXd& starts, const RunOptions& options,
                const Ranks& ranks);

  [[nodiscard]] long step() const { return step_; }
  [[nodiscard]] int size() const { return target_.size(); }

  /// Brings all samplers to `step`, with the swaps on the way and that of `step` itself. Every rank
  /// must call it alike.
  void advance_to(long step);

  /// Draws since the last call, of each group whose rung 0 is dealt here, in their order.
  [[nodiscard]] std::vector<Eigen::MatrixXd> take_draws();

  /// State of each sampler dealt here, in their order.
  [[nodiscard]] std::vector<std::string> save() const;
  /// @param all  states of all samplers of all ranks
  /// @throws InputError if they do not fit.
  void restore(long step, const Eigen::VectorXd& temper, const std::vector<std::string>& all);

  [[nodiscard]] const Eigen::VectorXd& temper() const { return temper_; }
  [[nodiscard]] long divergent() const;  // steps of rung 0 after warm-up, of the groups dealt here
  [[nodiscard]] Eigen::VectorXd swap_rates()
      const;  // of the groups dealt here, one after the other

 private:
  [[nodiscard]] SamplerSlot build_slot(int number, const Eigen::MatrixXd& starts) const;
  [[nodiscard]] std::vector<std::vector<Place>> places(std::size_t from, std::size_t to) const;
  [[nodiscard]] std::vector<std::vector<Place>> gather_places() const;
  [[nodiscard]] long next_stop(long from, long step) const;  // the next swap, or `step`
  [[nodiscard]] std::size_t share(int worker) const;         // its first slot
  [[nodiscard]] long next_retuning(long from) const;         // step; never: far away
  void retune();
  void advance_together(long step);  // all to each swap, where groups are split
  void advance_apart(std::size_t from, std::size_t to, long step);  // whole groups
  void advance_slots(std::size_t from, std::size_t to, long step);  // without swaps
  void swap(std::size_t from, std::size_t to, const std::vector<std::vector<Place>>& places,
            int first_group, long step);

  const Target& target_;
  const RunOptions& options_;
  const Ranks& ranks_;
  Eigen::VectorXd temper_;
  int first_ = 0;  // number of the first sampler dealt here
  std::vector<SamplerSlot> slots_;
  std::unique_ptr<WorkerTeam> team_;
  bool split_ranks_ = false, split_threads_ = false;  // does a group belong to several?
  long step_ = 0;
};

}  // namespace thenar::internal
