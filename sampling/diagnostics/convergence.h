#pragma once

/// Have the chains converged, and how well is each quantity known?
/// Source: [Vehtari2021] for all numbers of this file.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "sampling/run/draws.h"

namespace thenar {

/// Potential scale reduction. @param x  (draws, chains), at least 4 draws a chain  @return [1];
/// NaN where a draw is not finite or all draws are alike.
[[nodiscard]] double split_r_hat(const Eigen::Ref<const Eigen::MatrixXd>& x);
/// The larger of the rank-normalised and the folded one.
[[nodiscard]] double rank_r_hat(const Eigen::Ref<const Eigen::MatrixXd>& x);

/// Effective sample sizes [1]; NaN as above.
[[nodiscard]] double bulk_ess(const Eigen::Ref<const Eigen::MatrixXd>& x);
[[nodiscard]] double tail_ess(const Eigen::Ref<const Eigen::MatrixXd>& x);  // of 5 and 95 %
[[nodiscard]] double mean_ess(const Eigen::Ref<const Eigen::MatrixXd>& x);
[[nodiscard]] double quantile_ess(const Eigen::Ref<const Eigen::MatrixXd>& x, double share);
[[nodiscard]] double sd_ess(const Eigen::Ref<const Eigen::MatrixXd>& x);  // of (x - mean)^2
/// Of walkers of ensembles, which depend on each other: the worse of what chains and ensembles say.
/// @param group  of each chain, walkers of one ensemble share theirs; empty: none do
/// @throws InputError if ensembles differ in size, or there is not one group for each chain.
[[nodiscard]] double mean_ess(const Eigen::Ref<const Eigen::MatrixXd>& x,
                              const std::vector<int>& group);

/// Monte Carlo standard errors, in the unit of x.
[[nodiscard]] double mean_mcse(const Eigen::Ref<const Eigen::MatrixXd>& x);
[[nodiscard]] double mean_mcse(const Eigen::Ref<const Eigen::MatrixXd>& x,
                               const std::vector<int>& group);  // as of mean_ess()
/// For any distribution with four moments, not only the normal one [KenneyKeeping1951 p. 141]:
///   sqrt((m4 - m2^2) / ESS of (x - mean)^2) / (2 sqrt(m2)).
[[nodiscard]] double sd_mcse(const Eigen::Ref<const Eigen::MatrixXd>& x);
[[nodiscard]] double quantile_mcse(const Eigen::Ref<const Eigen::MatrixXd>& x, double share);

/// One quantity of a posterior, in its own unit.
struct Estimate {
  std::string name;
  double mean, sd, mcse_mean, mcse_sd;
  double q05, median, q95;  // quantiles
  double r_hat;             // rank-normalised, over chains and over groups, the larger [1]
  double bulk_ess, tail_ess;
};

/// @param x      (draws, chains)
/// @param group  of each chain; chains of one group, walkers of an ensemble, are pooled for R-hat
/// over groups, and ESS and the error of the mean are the worse of those that chains and means over
/// groups give
[[nodiscard]] Estimate estimate(const std::string& name, const Eigen::Ref<const Eigen::MatrixXd>& x,
                                const std::vector<int>& group);

/// What a run must reach to be believed.
struct ConvergenceLimits {
  double r_hat = 1.01;         // largest allowed [1]
  double ess_per_chain = 100;  // least bulk and tail ESS, times the number of groups [1]
  double divergent_share = 0;  // of draws [1]
  double swap_rate = 0.05;     // least between neighbours [1]
  int max_depth = 10;          // of trees of NUTS: steps that reach it are counted [1]
};

/// Empty `warnings`: converged as far as anyone can tell.
struct Convergence {
  std::vector<Estimate> estimates;  // of every entry of x, as named
  double worst_r_hat = 0, min_bulk_ess = 0, min_tail_ess = 0;
  long divergent = 0, non_finite = 0, depth_limit = 0;  // steps
  std::vector<std::string> warnings;  // each a sentence with the figure and its limit
};

[[nodiscard]] Convergence assess(const Draws& draws, const std::vector<std::string>& names,
                                 const ConvergenceLimits& limits = {});

}  // namespace thenar
