#pragma once

/// Parallel tempering: chains of prior * likelihood^beta that exchange their states.

#include <cstdint>

#include <Eigen/Core>

#include "sampling/methods/state_bytes.h"

namespace thenar {

/// Returns powers of the likelihood that fall from 1 to `min_beta`: geometric,
///   beta_i = min_beta^(i / (T - 1)),
/// or, if the last is the prior,
///   beta_i = (1 - i / (T - 1))^5.
/// @param temperatures  number T, at least 1; a single one has power 1
/// @param min_beta      smallest power, 0 .. below 1; ignored if T = 1
/// @return powers in falling order (T).
/// @throws InputError if an argument is out of range.
/// Source: [Friel2008] for the fifth power.
[[nodiscard]] Eigen::VectorXd temperature_ladder(int temperatures, double min_beta);

/// Flags of swaps between neighbouring temperatures (walkers, T - 1).
using SwapMask = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

/// Decisions of one round of swaps in one group. Entry (w, i) refers to walker w of the
/// temperatures i and i + 1; neighbouring pairs never swap in the same round.
struct Swaps {
  SwapMask tried;     // pairs that attempt a swap (walkers, T - 1)
  SwapMask exchange;  // pairs that exchange their states (walkers, T - 1)
  Eigen::ArrayXXd
      probability;  // probability of the exchange; 0 if not attempted [1] (walkers, T - 1)
};

/// Decides one round of swaps; the result depends on the arguments only:
///   P(exchange) = min(1, exp((beta_i - beta_{i+1}) (log L_{i+1} - log L_i))).
/// Even pairs (0-1, 2-3, ...) swap in even rounds, odd pairs in odd rounds: a state keeps its
/// direction and crosses the ladder in about T rounds instead of T^2.
///
/// A likelihood of NaN or +inf counts as zero. A chain at zero likelihood accepts any other state;
/// two such chains stay.
/// @param beta            powers of the likelihood, falling (T)
/// @param log_likelihood  log likelihood without beta, of each walker and temperature (walkers, T)
/// @throws InputError if shapes disagree.
/// Source: [Okabe2001] and [Syed2022] for the alternation.
[[nodiscard]] Swaps decide_swaps(const Eigen::VectorXd& beta, const Eigen::MatrixXd& log_likelihood,
                                 std::uint64_t seed, std::uint32_t group, std::uint32_t round);

/// Counts of swaps between neighbouring temperatures.
struct SwapCounts {
  explicit SwapCounts(int temperatures = 1);

  void add(const Swaps& swaps);
  [[nodiscard]] Eigen::VectorXd swap_rate() const;       // accepted / tried; NaN if none (T - 1)
  [[nodiscard]] Eigen::VectorXd rejection_rate() const;  // mean probability of rejection (T - 1)

  void save(StateWriter& to) const;
  void restore(StateReader& from);

  Eigen::VectorXd tried, accepted;  // numbers of swaps [1] (T - 1)
  Eigen::VectorXd probability;      // sum of the probabilities of attempted swaps [1] (T - 1)
};

/// Returns a ladder with the same ends whose neighbours would reject swaps about equally often: its
/// temperatures divide the communication barrier  Lambda(beta_k) = sum_{i < k} rejection_rate_i,
/// interpolated linearly in beta^(1/5), into equal parts. Call it only during warm-up, after enough
/// swaps.
/// @param beta            powers of the likelihood, falling (T)
/// @param rejection_rate  mean rejection probability of neighbours, 0..1; NaN: replaced by the mean
///                        of the other pairs (T - 1)
/// @throws InputError if shapes disagree.
/// Source: [Syed2022, algorithm 2].
[[nodiscard]] Eigen::VectorXd adapted_ladder(const Eigen::VectorXd& beta,
                                             const Eigen::VectorXd& rejection_rate);

}  // namespace thenar
