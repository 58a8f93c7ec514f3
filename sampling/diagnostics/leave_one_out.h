#pragma once

/// Leave-one-out predictive accuracy by Pareto-smoothed importance sampling.

#include <string>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Computes log sum_i exp(x_i) without overflow. @param x  at least one, none +inf or NaN (n)
[[nodiscard]] double log_sum_exp(const Eigen::Ref<const Eigen::VectorXd>& x);

/// Generalised Pareto distribution of excesses x > 0: P(X > x) = (1 + k x / sigma)^(-1/k).
/// Moments of order 1/k and above are infinite.
struct ParetoFit {
  double k = 0;      // shape [1]
  double sigma = 0;  // scale [unit of x]
};

/// Fits shape and scale by a quasi-posterior mean over profile likelihoods: [ZhangStephens2009],
/// with the finer grid of 30 + sqrt(n) points of [Vehtari2024].
/// @param rising  at least 5 excesses in ascending order, >= 0, the largest > 0 (n)
/// @throws InputError for any other excesses.
[[nodiscard]] ParetoFit fit_pareto(const Eigen::Ref<const Eigen::VectorXd>& rising);

/// Importance weights with a smoothed tail.
struct SmoothedWeights {
  Eigen::VectorXd log_weight;  // logarithms of the weights, whose sum is 1 (N)
  double k = 0;  // shape of the tail [1]; infinite: fewer than 25 draws; 0: equal ratios
};

/// Smooths importance ratios by Pareto-smoothed importance sampling: the largest
/// M = min(N / 5, 3 sqrt(N / r)) ratios are replaced by the expected order statistics of the Pareto
/// distribution fitted to them, but not above the largest ratio. k is shrunk towards 1/2 as if by
/// ten further draws: (M k + 5) / (M + 10).
/// @param log_ratio   finite logarithms of the ratios (N)
/// @param efficiency  r, effective size over N [1]
/// @throws InputError if a ratio is not finite.
/// Source: [Vehtari2024] sec. 2 and app. C.
[[nodiscard]] SmoothedWeights smooth_weights(const Eigen::Ref<const Eigen::VectorXd>& log_ratio,
                                             double efficiency = 1);

/// Expected log predictive density (elpd) of each observation given all the others.
struct LeaveOneOut {
  double elpd = 0;  // sum of `pointwise` [1]
  double se = 0;    // standard error of elpd over observations: sqrt(n var) [1]
  double effective_parameters =
      0;                      // p_loo: log density of the data when fitted minus when left out [1]
  Eigen::VectorXd pointwise;  // log p(y_i | y_-i) (observations)
  Eigen::VectorXd k;          // Pareto shape of the ratios of each observation (observations)
  double good_k = 0;          // largest k of a reliable estimate: min(1 - 1/log10 N, 0.7) [1]
  std::vector<std::string> warnings;  // sentences; empty: all estimates are reliable
};

/// Computes the leave-one-out density from draws of the posterior given all observations:
///   log p(y_i | y_-i) = log sum_s w_is p(y_i | x_s),   w_is ~ 1 / p(y_i | x_s), smoothed.
/// Observations must be independent given x.
/// @param log_likelihood  finite; draws stored chain by chain (observations, draws * chains)
/// @param chains          number of chains, for the efficiency of the draws [1]
/// @param group           group of each chain; walkers of one ensemble share theirs; empty:
///                        independent chains
/// @throws InputError if a chain has fewer than 4 draws, or a likelihood is not finite.
/// Source: [Vehtari2017] eqs. 4, 10 and sec. 2; [Vehtari2024] for the limit of k.
[[nodiscard]] LeaveOneOut leave_one_out(const Eigen::Ref<const Eigen::MatrixXd>& log_likelihood,
                                        int chains, const std::vector<int>& group = {});

/// Difference in elpd of two models of the same observations, first minus second, and its standard
/// error.
struct ElpdDifference {
  double elpd = 0, se = 0;  // [1]
};

/// Compares two models. @throws InputError if the numbers of observations differ.
/// Source: [Vehtari2017] eq. 24.
[[nodiscard]] ElpdDifference compare_elpd(const LeaveOneOut& first, const LeaveOneOut& second);

}  // namespace thenar
