#pragma once

/// Convergence diagnostics of chains: R-hat, effective sample sizes, Monte Carlo standard errors.
/// Source: [Vehtari2021] for all quantities of this file.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "sampling/run/draws.h"

namespace thenar {

/// Computes the potential scale reduction of split chains [1]; NaN if a draw is not finite or all
/// are equal.
/// @param x  at least 4 draws per chain (draws, chains)
[[nodiscard]] double split_r_hat(const Eigen::Ref<const Eigen::MatrixXd>& x);
/// Computes the larger R-hat of the rank-normalised and of the folded draws [1].
[[nodiscard]] double rank_r_hat(const Eigen::Ref<const Eigen::MatrixXd>& x);

/// Compute effective sample sizes [1]; NaN if a draw is not finite or all are equal.
[[nodiscard]] double bulk_ess(const Eigen::Ref<const Eigen::MatrixXd>& x);
[[nodiscard]] double tail_ess(
    const Eigen::Ref<const Eigen::MatrixXd>& x);  // smaller one of the 5 and 95 % quantiles
[[nodiscard]] double mean_ess(const Eigen::Ref<const Eigen::MatrixXd>& x);
[[nodiscard]] double quantile_ess(const Eigen::Ref<const Eigen::MatrixXd>& x, double share);
[[nodiscard]] double sd_ess(
    const Eigen::Ref<const Eigen::MatrixXd>& x);  // effective size of (x - mean)^2
/// Computes the smaller of mean_ess(x) and ensemble_ess(): walkers of one ensemble depend on each
/// other.
/// @param group  group of each chain; walkers of one ensemble share theirs; empty: independent
///               chains
/// @throws InputError if ensembles differ in size, or there is not one group for each chain.
[[nodiscard]] double mean_ess(const Eigen::Ref<const Eigen::MatrixXd>& x,
                              const std::vector<int>& group);

/// Returns mean_ess() over the number of draws [1]; 1 if the draws do not vary.
[[nodiscard]] double mean_efficiency(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                     const std::vector<int>& group = {});

/// Compute Monte Carlo standard errors, in the unit of x.
[[nodiscard]] double mean_mcse(const Eigen::Ref<const Eigen::MatrixXd>& x);
[[nodiscard]] double mean_mcse(const Eigen::Ref<const Eigen::MatrixXd>& x,
                               const std::vector<int>& group);  // group: see mean_ess()
/// Computes the Monte Carlo standard error of an sd for any distribution with four moments
/// [KenneyKeeping1951 p. 141]:
///   sqrt((m4 - m2^2) / ESS of (x - mean)^2) / (2 sqrt(m2)).
[[nodiscard]] double sd_mcse(const Eigen::Ref<const Eigen::MatrixXd>& x);
[[nodiscard]] double quantile_mcse(const Eigen::Ref<const Eigen::MatrixXd>& x, double share);

/// Posterior mean, spread and convergence of one quantity, in its own unit.
struct Estimate {
  std::string name;
  double mean = 0, sd = 0, mcse_mean = 0, mcse_sd = 0;
  double q05 = 0, median = 0, q95 = 0;  // quantiles
  double r_hat = 0;  // larger one of the rank-normalised R-hats over chains and over groups [1]
  double bulk_ess = 0, tail_ess = 0;  // [1]
};

/// Estimates one quantity.
/// @param x      draws (draws, chains)
/// @param group  group of each chain. Chains of one group, the walkers of an ensemble, are pooled
///               for a second R-hat over groups; ESS and the error of the mean are the worse of
///               the values from chains and from means over groups.
[[nodiscard]] Estimate estimate(const std::string& name, const Eigen::Ref<const Eigen::MatrixXd>& x,
                                const std::vector<int>& group);

/// Limits that the draws of a converged run satisfy.
struct ConvergenceLimits {
  double r_hat = 1.01;            // maximum R-hat [1]
  double nuisance_r_hat = 1.1;    // maximum R-hat of a coordinate on which no answer depends [1]
  double ess_per_chain = 100;     // minimum bulk and tail ESS per group [1]
  double divergent_share = 0.01;  // maximum share of divergent draws that is only a caution [1]
  double swap_rate = 0.05;        // minimum swap rate between neighbouring temperatures [1]
  int max_depth = 10;  // maximum depth of NUTS trees: steps that reach it are counted [1]
};

/// Diagnostics of a run and its warnings; without warnings there is no evidence against
/// convergence. Divergent draws are a warning if they are many or if there are other warnings,
/// otherwise a caution.
struct Convergence {
  std::vector<Estimate> estimates;  // estimate of every entry of x
  double worst_r_hat = 0, min_bulk_ess = 0, min_tail_ess = 0;
  long divergent = 0, non_finite = 0, depth_limit = 0;  // numbers of steps [1]
  std::vector<std::string> warnings;                    // sentences with the figure and its limit
  std::vector<std::string> cautions;   // notes on converged draws: a few divergent ones, or
                                       // coordinates on which no answer depends
  std::vector<std::string> unsettled;  // coordinates that miss a limit of R-hat or effective size
  bool draws_may_help = false;  // `unsettled` coordinates are the only evidence against convergence
};

/// Computes all diagnostics and compares them with their limits.
/// @param names  names of the coordinates
[[nodiscard]] Convergence assess(const Draws& draws, const std::vector<std::string>& names,
                                 const ConvergenceLimits& limits = {});

/// Replaces the warnings about unsettled coordinates by one caution if all answers satisfy the
/// limits that these coordinates miss, nothing else is wrong, and no coordinate's R-hat exceeds
/// `nuisance_r_hat`. Forces may have converged although a parameter to which they are hardly
/// sensitive has not; the caution says that the values of such parameters must not be used.
/// @param answers  estimates of the quantities that the run was made for; empty: no change
/// @param what     noun for the answers in the caution: "forces"
/// @param groups   number of independent chains or ensembles [1]
[[nodiscard]] Convergence settled_by_answers(Convergence convergence,
                                             const std::vector<Estimate>& answers,
                                             const std::string& what, long groups,
                                             const ConvergenceLimits& limits = {});

}  // namespace thenar
