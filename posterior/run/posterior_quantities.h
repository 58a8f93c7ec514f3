#pragma once

/// Draws of a run as named quantities in display units: parameters and factors.

#include <string>
#include <vector>

#include "posterior/run/sample_posterior.h"

namespace thenar {

/// Named quantity of a posterior.
struct PosteriorQuantity {
  std::string name;       // "axis/CMC1_FE/direction/1", "H01: arm/FPL/IP1", "noise/H01"
  std::string unit;       // "mm", "deg", "1", "1/rad"
  Eigen::MatrixXd draws;  // posterior draws [unit] (draws, chains)
  Eigen::VectorXd prior;  // prior draws [unit]
};

/// Returns the parameters of the population, of every specimen if there are several, and the
/// factors of noise and between specimens.
/// @param prior_count  number of prior draws of each quantity [1]
[[nodiscard]] std::vector<PosteriorQuantity> posterior_quantities(const PosteriorRun& run,
                                                                  int prior_count = 1000);

/// Returns the sd of the prior draws, in the unit of the quantity.
[[nodiscard]] double prior_sd(const PosteriorQuantity& quantity);

/// Computes means, Monte Carlo errors and R-hats of quantities, in the same order and units.
[[nodiscard]] std::vector<Estimate> estimates_of(const std::vector<PosteriorQuantity>& quantities,
                                                 const std::vector<int>& group);

/// Reshapes values at the pooled draws of a run, chain by chain, to (draws, chains).
[[nodiscard]] Eigen::MatrixXd reshape_by_chain(const Eigen::VectorXd& values, int chains);

/// Selection of observations.
enum class Observed { kForces, kAll };

/// Returns names such as "H01: Hook FDS" of every trial of every experiment in turn and, for kAll,
/// of every row of muscle activations: the order of HandPosterior::pointwise().
[[nodiscard]] std::vector<std::string> observation_names(const FitProblem& problem,
                                                         Observed which = Observed::kAll);

[[nodiscard]] std::vector<std::string> experiment_names(const FitProblem& problem);

/// Draws from the prior of a posterior, using the seed of the run [1] (size, count).
[[nodiscard]] Eigen::MatrixXd prior_draws(const PosteriorRun& run, int count);

}  // namespace thenar
