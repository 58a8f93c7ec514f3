#pragma once

/// Importance weights that make draws from one distribution represent another, and their
/// reliability.

#include <Eigen/Core>

namespace thenar {

/// Returns the largest Pareto shape at which averages over N weighted draws are reliable:
///   min(1 - 1 / log10 N, 0.7).  Source: [Vehtari2024] sec. 3.2.4.
/// @param draws  N, above 1 [1]
[[nodiscard]] double good_pareto_shape(double draws);

/// Self-normalised importance weights with a smoothed tail.
struct ImportanceWeights {
  Eigen::VectorXd weight;     // weight of each draw; the sum is 1 (N)
  double effective_size = 0;  // 1 / sum weight^2: the number of equal weights of the same variance;
                              // ignores the autocorrelation of chains [1]
  double k = 0;               // Pareto shape of the tail; infinite: too few draws [1]
  double good_k = 0;          // good_pareto_shape() of the draws with a finite ratio [1]

  [[nodiscard]] bool reliable() const { return k <= good_k; }
};

/// Computes the weights of draws from p that represent q:  w_i = r_i / sum r_j,  r_i = q(x_i) /
/// p(x_i), smoothed by smooth_weights(). For draws of chains, uses the efficiency of the mean of r.
/// @param log_ratio  log r up to a constant; -inf: q is zero there, and the weight is 0 (N)
/// @param chains     number of chains of equal length, stored one after the other; 0: independent
///         draws
/// @throws InputError if a ratio is NaN or +inf, or none is finite; if N is not a multiple of
///         `chains`, or
/// chains have fewer than 4 draws.
/// Source: [Vehtari2024] eqs. 1 to 3 and sec. 2; [Kong1994] for the effective size.
[[nodiscard]] ImportanceWeights importance_weights(
    const Eigen::Ref<const Eigen::VectorXd>& log_ratio, int chains = 0);

/// Mean and sd of weighted draws, relative to the unweighted draws.
struct WeightedSpread {
  Eigen::VectorXd mean, sd;        // mean and sd of the weighted draws [unit of x] (n)
  Eigen::VectorXd mean_shift;      // weighted minus unweighted mean, in unweighted sds [1] (n)
  Eigen::VectorXd sd_ratio;        // weighted over unweighted sd [1] (n)
  Eigen::VectorXd sd_ratio_error;  // Monte Carlo error of sd_ratio [1] (n)
};

/// Computes the ratio of the weighted sd s to the unweighted sd s_0 around their means m and m_0,
/// and its error. To first order
///   var(s / s_0) = (s / s_0)^2 / 4  sum (w_i a_i - b_i / N)^2,
///   a_i = (x_i - m)^2 / s^2 - 1,   b_i = (x_i - m_0)^2 / s_0^2 - 1,
/// for independent draws: the delta method for a ratio of two averages over the same draws. For
/// draws of chains it is divided by the efficiency of the mean of these terms, mean_efficiency().
/// @param x       draws as columns (n, N)
/// @param weight  weight of each draw, >= 0, sum 1 (N)
/// @param chains  see importance_weights()
/// @throws InputError if shapes disagree, there are fewer than two draws, or an entry does not
/// vary; and for
/// chains as importance_weights().
[[nodiscard]] WeightedSpread weighted_spread(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                             const Eigen::Ref<const Eigen::VectorXd>& weight,
                                             int chains = 0);

}  // namespace thenar
