#pragma once

/// Parallel tempering: chains of prior * likelihood^beta that change places.

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

/// What one round of swaps of one group decided. Entry (w, i) is about walker w of rungs i and
/// i + 1; neighbouring pairs never swap in the same round.
struct Swaps {
  SwapMask tried;               // (walkers, T - 1)
  SwapMask exchange;            // walker w of rungs i and i + 1 change places (walkers, T - 1)
  Eigen::ArrayXXd probability;  // of that; 0 where not tried [1] (walkers, T - 1)
};

/// Decides round `round` of a group, a function of its arguments alone:
///   P(exchange) = min(1, exp((beta_i - beta_{i+1}) (log L_{i+1} - log L_i))).
/// Even pairs (0-1, 2-3, ...) in even rounds, odd ones in odd rounds: a place that moves on keeps
/// its direction, and crosses the ladder in about T rounds instead of T^2.
///
/// A likelihood that is NaN or +inf counts as zero. A chain at a place of zero likelihood takes
/// any other; two of them stay.
/// @param beta          falling (T)
/// @param log_likelihood  not tempered, at the place of each walker of each temperature_index
/// (walkers, T)
/// @throws InputError if shapes disagree.
/// Source: [Okabe2001] and [Syed2022] for the alternation.
[[nodiscard]] Swaps decide_swaps(const Eigen::VectorXd& beta, const Eigen::MatrixXd& log_likelihood,
                                 std::uint64_t seed, std::uint32_t group, std::uint32_t round);

/// How often neighbours changed places.
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

/// A ladder with the same ends, whose neighbours would refuse about equally often: the rungs stand
/// at equal parts of the communication barrier  Lambda(beta_k) = sum_{i < k} rejection_rate_i,
/// which is interpolated linearly in beta^(1/5). To be asked in warm-up only, with enough swaps
/// counted.
/// @param beta   falling (T)
/// @param rejection_rate  mean probability of refusal of neighbours, 0..1; NaN: as the mean of the
/// others (T - 1)
/// @throws InputError if shapes disagree.
/// Source: [Syed2022, algorithm 2].
[[nodiscard]] Eigen::VectorXd adapted_ladder(const Eigen::VectorXd& beta,
                                             const Eigen::VectorXd& rejection_rate);

}  // namespace thenar
