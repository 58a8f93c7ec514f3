#pragma once

/// The tail of importance ratios, and what its shape says of their sums.

#include <Eigen/Core>

namespace thenar {

/// Generalised Pareto distribution of excesses x > 0: P(X > x) = (1 + k x / sigma)^(-1/k).
/// Moments of order 1/k and above are infinite.
struct ParetoFit {
  double k = 0;      // shape [1]
  double sigma = 0;  // scale [unit of x]
};

/// Shape and scale by a quasi-posterior mean over profile likelihoods: [ZhangStephens2009], with
/// the finer grid of 30 + sqrt(n) points of [Vehtari2024].
/// @param rising  excesses in rising order, >= 0, the largest > 0; 5 or more (n)
/// @throws InputError else.
[[nodiscard]] ParetoFit fit_pareto(const Eigen::Ref<const Eigen::VectorXd>& rising);

/// Importance weights with a tail that is smoothed.
struct SmoothedWeights {
  Eigen::VectorXd log_weight;  // sum of exp is 1 (N)
  double k = 0;  // shape of the tail [1]; infinite: fewer than 25 draws; 0: equal ratios
};

/// Pareto-smoothed importance sampling: the largest M = min(N / 5, 3 sqrt(N / r)) ratios become
/// the expected order statistics of the Pareto distribution that fits them, at most the largest
/// ratio. k is drawn towards 1/2 as by ten further draws: (M k + 5) / (M + 10).
/// @param log_ratio   finite (N)
/// @param efficiency  r, effective size over N [1]
/// @throws InputError if a ratio is not finite.
/// Source: [Vehtari2024] sec. 2 and app. C.
[[nodiscard]] SmoothedWeights smooth_weights(const Eigen::Ref<const Eigen::VectorXd>& log_ratio,
                                             double efficiency = 1);

}  // namespace thenar
