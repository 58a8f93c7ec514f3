#pragma once

/// Draws of a run as named quantities in display units: parameters and factors.

#include <string>
#include <vector>

#include "posterior/run/sample_posterior.h"

namespace thenar {

/// One quantity of a posterior.
struct PosteriorQuantity {
  std::string name;       // "axis/CMC1_FE/direction/1", "H01: arm/FPL/IP1", "noise/H01"
  std::string unit;       // "mm", "deg", "1", "1/rad"
  Eigen::MatrixXd draws;  // [unit] (draws, chains)
  Eigen::VectorXd prior;  // draws from the prior [unit]
};

/// Parameters of the population, of every specimen where there are several, and factors of noise
/// and between specimens.
/// @param prior_count  prior draws of each quantity [1]
[[nodiscard]] std::vector<PosteriorQuantity> posterior_quantities(const PosteriorRun& run,
                                                                  int prior_count = 1000);

[[nodiscard]] double prior_sd(const PosteriorQuantity& quantity);  // in its unit

/// Means, Monte Carlo errors and R-hats of quantities, in the same order and units.
[[nodiscard]] std::vector<Estimate> estimates_of(const std::vector<PosteriorQuantity>& quantities,
                                                 const std::vector<int>& group);

/// Values at the pooled draws of a run, chain by chain, as (draws, chains).
[[nodiscard]] Eigen::MatrixXd by_chain(const Eigen::VectorXd& values, int chains);

/// Names such as "H01: Hook FDS" of every trial of every experiment in turn; then, unless kForces,
/// of every row of muscle activations: the order of HandPosterior::pointwise().
enum class Observed { kForces, kAll };
[[nodiscard]] std::vector<std::string> observation_names(const FitProblem& problem,
                                                         Observed which = Observed::kAll);

[[nodiscard]] std::vector<std::string> experiment_names(const FitProblem& problem);

/// Draws from the prior of a posterior, by the seed of the run [1] (size, count).
[[nodiscard]] Eigen::MatrixXd prior_draws(const PosteriorRun& run, int count);

}  // namespace thenar
