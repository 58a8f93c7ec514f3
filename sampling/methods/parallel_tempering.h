#pragma once

/// Parallel tempering: chains of prior * likelihood^beta that exchange their states.

#include <cstdint>

#include <Eigen/Core>

#include "sampling/methods/state_bytes.h"

namespace thenar {

/// Powers of the likelihood, falling from 1 to `least`: geometric,  beta_i = least^(i / (T - 1)),
/// or, where the last is to be the prior,  beta_i = (1 - i / (T - 1))^5.
/// @param temperatures  T, at least 1; one alone is 1 (T)
/// @param least         0 .. below 1; of no effect if T = 1
/// @throws InputError if one is out of range.
/// Source: [Friel2008] for the fifth power.
[[nodiscard]] Eigen::VectorXd temperature_ladder(int temperatures, double least);

using SwapMask = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

/// Decisions of one round of swaps in one group. Entry (w, i) is about walker w of the temperatures
/// i and i + 1; neighbouring pairs never swap in the same round.
struct Swaps {
  SwapMask tried;               // (walkers, T - 1)
  SwapMask exchange;            // walkers w of i and i + 1 exchange states (walkers, T - 1)
  Eigen::ArrayXXd probability;  // of the exchange; 0 where not tried [1] (walkers, T - 1)
};

/// Decides one round of swaps; the result depends on the arguments alone:
///   P(exchange) = min(1, exp((beta_i - beta_{i+1}) (log L_{i+1} - log L_i))).
/// Even pairs (0-1, 2-3, ...) swap in even rounds, odd pairs in odd rounds: a state that moves
/// keeps its direction, and crosses the ladder in about T rounds instead of T^2.
///
/// A likelihood that is NaN or +inf counts as zero. A chain at zero likelihood takes any other
/// state; two such chains stay.
/// @param beta          falling (T)
/// @param log_likelihood  not tempered, of each walker at each temperature (walkers, T)
/// @throws InputError if shapes disagree.
/// Source: [Okabe2001] and [Syed2022] for the alternation.
[[nodiscard]] Swaps decide_swaps(const Eigen::VectorXd& beta, const Eigen::MatrixXd& log_likelihood,
                                 std::uint64_t seed, std::uint32_t group, std::uint32_t round);

/// Counts of swaps between neighbouring temperatures.
struct SwapCounts {
  explicit SwapCounts(int temperatures = 1);

  void add(const Swaps& swaps);
  [[nodiscard]] Eigen::VectorXd rate() const;      // accepted / tried; NaN if none tried (T - 1)
  [[nodiscard]] Eigen::VectorXd rejected() const;  // mean probability of refusal (T - 1)

  void save(StateWriter& to) const;
  void restore(StateReader& from);

  Eigen::VectorXd tried, accepted;  // swaps [1] (T - 1)
  Eigen::VectorXd probability;      // sum over the tried [1] (T - 1)
};

/// Returns a ladder with the same ends whose neighbours would reject swaps about equally often: its
/// temperatures stand at equal parts of the communication barrier  Lambda(beta_k) = sum_{i < k}
/// rejection_rate_i, which is interpolated linearly in beta^(1/5). Call during warm-up only, with
/// enough swaps counted.
/// @param beta   falling (T)
/// @param rejection_rate  mean rejection probability of neighbours, 0..1; NaN: the mean of the
/// other
///                        pairs is taken (T - 1)
/// @throws InputError if shapes disagree.
/// Source: [Syed2022, algorithm 2].
[[nodiscard]] Eigen::VectorXd adapted_ladder(const Eigen::VectorXd& beta,
                                             const Eigen::VectorXd& rejection_rate);

}  // namespace thenar
