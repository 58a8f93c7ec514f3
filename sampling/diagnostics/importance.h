#pragma once

/// Draws of one distribution weighed so that they stand for another, and how far to believe them.

#include <Eigen/Core>

namespace thenar {

/// Largest Pareto shape with which averages over N weighted draws can be relied on:
///   min(1 - 1 / log10 N, 0.7).  Source: [Vehtari2024] sec. 3.2.4.
/// @param draws  N, above 1 [1]
[[nodiscard]] double good_pareto_shape(double draws);

/// Self-normalised importance weights, their tail smoothed.
struct ImportanceWeights {
  Eigen::VectorXd weight;     // sum is 1 (N)
  double effective_size = 0;  // 1 / sum weight^2: as many equal weights would vary as much; that
                              // draws of chains repeat each other is not counted [1]
  double k = 0;               // Pareto shape of the tail; infinite: too few draws to tell [1]
  double good_k = 0;          // good_pareto_shape() of the draws that can be weighed [1]

  [[nodiscard]] bool reliable() const { return k <= good_k; }
};

/// Weights of draws from p that stand for q:  w_i = r_i / sum r_j,  r_i = q(x_i) / p(x_i), smoothed
/// by smooth_weights(), with the efficiency of the mean of r if draws are of chains.
/// @param log_ratio  log r up to a constant; -inf: q does not go there, and the weight is 0 (N)
/// @param chains     draws are of so many chains of one length, chain by chain; 0: independent
/// @throws InputError if a ratio is NaN or +inf, or none is finite; if chains do not divide N, or
/// have fewer than 4 draws.
/// Source: [Vehtari2024] eqs. 1 to 3 and sec. 2; [Kong1994] for the effective size.
[[nodiscard]] ImportanceWeights importance_weights(
    const Eigen::Ref<const Eigen::VectorXd>& log_ratio, int chains = 0);

/// Mean and sd of weighted draws, and what became of the sd of the draws themselves.
struct WeightedSpread {
  Eigen::VectorXd mean, sd;        // of weighted draws [unit of x] (n)
  Eigen::VectorXd mean_shift;      // weighted less plain mean, in plain sds [1] (n)
  Eigen::VectorXd sd_ratio;        // weighted sd over plain sd [1] (n)
  Eigen::VectorXd sd_ratio_error;  // Monte Carlo error of sd_ratio [1] (n)
};

/// Computes the ratio of the weighted sd s to the plain sd s_0 about their means m and m_0, and its
/// error. To first order
///   var(s / s_0) = (s / s_0)^2 / 4  sum (w_i a_i - b_i / N)^2,
///   a_i = (x_i - m)^2 / s^2 - 1,   b_i = (x_i - m_0)^2 / s_0^2 - 1,
/// draws being independent: the delta method for a ratio of two averages over the same draws. For
/// draws of chains it is divided by the efficiency of the mean of these terms, mean_efficiency().
/// @param x       draws as columns (n, N)
/// @param weight  of each, >= 0, sum 1 (N)
/// @param chains  as of importance_weights()
/// @throws InputError if shapes disagree, there are fewer than two draws, or an entry does not
/// vary; of chains as importance_weights().
[[nodiscard]] WeightedSpread weighted_spread(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                             const Eigen::Ref<const Eigen::VectorXd>& weight,
                                             int chains = 0);

}  // namespace thenar
