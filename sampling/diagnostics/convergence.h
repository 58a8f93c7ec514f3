#pragma once

/// Convergence diagnostics of chains: R-hat, effective sample sizes, Monte Carlo standard errors.
/// Source: [Vehtari2021] for all quantities of this file.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "sampling/run/draws.h"

namespace thenar {

/// Potential scale reduction of split chains [1]; NaN where a draw is not finite or all are equal.
/// @param x  (draws, chains), at least 4 draws a chain
[[nodiscard]] double split_r_hat(const Eigen::Ref<const Eigen::MatrixXd>& x);
/// The larger R-hat of the rank-normalised and of the folded draws [1].
[[nodiscard]] double rank_r_hat(const Eigen::Ref<const Eigen::MatrixXd>& x);

/// Effective sample sizes [1]; NaN as above.
[[nodiscard]] double bulk_ess(const Eigen::Ref<const Eigen::MatrixXd>& x);
[[nodiscard]] double tail_ess(const Eigen::Ref<const Eigen::MatrixXd>& x);  // of 5 and 95 %
[[nodiscard]] double mean_ess(const Eigen::Ref<const Eigen::MatrixXd>& x);
[[nodiscard]] double quantile_ess(const Eigen::Ref<const Eigen::MatrixXd>& x, double share);
[[nodiscard]] double sd_ess(const Eigen::Ref<const Eigen::MatrixXd>& x);  // of (x - mean)^2
/// The smaller effective size of mean_ess(x) and ensemble_ess(): walkers of one ensemble depend on
/// each other.
/// @param group  of each chain, walkers of one ensemble share theirs; empty: none do
/// @throws InputError if ensembles differ in size, or there is not one group for each chain.
[[nodiscard]] double mean_ess(const Eigen::Ref<const Eigen::MatrixXd>& x,
                              const std::vector<int>& group);

/// mean_ess() over the number of draws [1]; 1 if they do not vary.
[[nodiscard]] double mean_efficiency(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                     const std::vector<int>& group = {});

/// Monte Carlo standard errors, in the unit of x.
[[nodiscard]] double mean_mcse(const Eigen::Ref<const Eigen::MatrixXd>& x);
[[nodiscard]] double mean_mcse(const Eigen::Ref<const Eigen::MatrixXd>& x,
                               const std::vector<int>& group);  // as of mean_ess()
/// Monte Carlo standard error of an sd, for any distribution with four moments, not only the normal
/// one [KenneyKeeping1951 p. 141]:
///   sqrt((m4 - m2^2) / ESS of (x - mean)^2) / (2 sqrt(m2)).
[[nodiscard]] double sd_mcse(const Eigen::Ref<const Eigen::MatrixXd>& x);
[[nodiscard]] double quantile_mcse(const Eigen::Ref<const Eigen::MatrixXd>& x, double share);

/// Posterior mean, spread and convergence of one quantity, in its own unit.
struct Estimate {
  std::string name;
  double mean, sd, mcse_mean, mcse_sd;
  double q05, median, q95;    // quantiles
  double r_hat;               // rank-normalised, over chains and over groups, the larger [1]
  double bulk_ess, tail_ess;  // [1]
};

/// @param x      (draws, chains)
/// @param group  of each chain. Chains of one group, walkers of an ensemble, are pooled for a
/// second
///               R-hat over groups; ESS and the error of the mean are the worse of the values from
///               chains and from means over groups.
[[nodiscard]] Estimate estimate(const std::string& name, const Eigen::Ref<const Eigen::MatrixXd>& x,
                                const std::vector<int>& group);

/// Limits that a converged run keeps.
struct ConvergenceLimits {
  double r_hat = 1.01;            // largest allowed [1]
  double nuisance_r_hat = 1.1;    // largest allowed of a coordinate that no answer depends on [1]
  double ess_per_chain = 100;     // least bulk and tail ESS, to be multiplied by the groups [1]
  double divergent_share = 0.01;  // largest share of divergent draws that is a caution [1]
  double swap_rate = 0.05;        // least between neighbours [1]
  int max_depth = 10;             // of trees of NUTS: steps that reach it are counted [1]
};

/// Figures of a run and its warnings; without warnings no diagnostic speaks against convergence.
/// Divergent draws are a warning if they are many, or if anything else is wrong, else a caution.
struct Convergence {
  std::vector<Estimate> estimates;  // of every entry of x, as named
  double worst_r_hat = 0, min_bulk_ess = 0, min_tail_ess = 0;
  long divergent = 0, non_finite = 0, depth_limit = 0;  // steps [1]
  std::vector<std::string> warnings;   // each a sentence with the figure and its limit
  std::vector<std::string> cautions;   // for readers of converged draws: a few divergent ones, or
                                       // coordinates that no answer depends on
  std::vector<std::string> unsettled;  // coordinates beyond a limit of R-hat or effective size
  bool draws_may_help = false;  // nothing speaks against convergence but `unsettled` coordinates
};

/// Computes all diagnostics and compares them with their limits.
/// @param names  of the coordinates
[[nodiscard]] Convergence assess(const Draws& draws, const std::vector<std::string>& names,
                                 const ConvergenceLimits& limits = {});

/// Turns the warnings of unsettled coordinates into one caution where all answers keep the limits
/// that they miss, nothing else is wrong, and no coordinate's R-hat is above `nuisance_r_hat`:
/// forces may have converged though a tilt that they feel by its square alone, or a factor that
/// they hardly feel, has not. Those numbers themselves stay unfit for use, as the caution says.
/// @param answers  estimates of what the run was asked for; none: nothing changes
/// @param what     what they are, for the caution: "forces"
/// @param groups   independent chains or ensembles [1]
[[nodiscard]] Convergence settled_by_answers(Convergence of, const std::vector<Estimate>& answers,
                                             const std::string& what, long groups,
                                             const ConvergenceLimits& limits = {});

}  // namespace thenar
