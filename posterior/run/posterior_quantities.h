#pragma once

/// The draws of a run as numbers that people read: parameters with units, factors.

#include <string>
#include <vector>

#include "posterior/run/sample_posterior.h"

namespace thenar {

/// One number of a posterior.
struct PosteriorQuantity {
  std::string name;       // "axis/CMC1_FE/direction/1", "H01: arm/FPL/IP1", "noise/H01"
  std::string unit;       // "mm", "deg", "1", "1/rad"
  Eigen::MatrixXd draws;  // [unit] (draws, chains)
  Eigen::VectorXd prior;  // draws from the prior [unit]
};

/// The population's parameters, every specimen's where there are several, noise and spread.
/// @param prior_draws  of each quantity [1]
[[nodiscard]] std::vector<PosteriorQuantity> posterior_quantities(const PosteriorRun& run,
                                                                  int prior_draws = 1000);

[[nodiscard]] double prior_sd(const PosteriorQuantity& quantity);  // in its unit

/// Their means, Monte Carlo errors and R-hats, in the same order and units.
[[nodiscard]] std::vector<Estimate> estimates_of(const std::vector<PosteriorQuantity>& quantities,
                                                 const std::vector<int>& group);

/// "H01: Hook FDS": every trial of every experiment in turn; then, unless kForces, every row
/// of muscle activations, as HandPosterior::pointwise() has them.
enum class Observed { kForces, kAll };
[[nodiscard]] std::vector<std::string> observation_names(const FitProblem& problem,
                                                         Observed which = Observed::kAll);

[[nodiscard]] std::vector<std::string> experiment_names(const FitProblem& problem);

/// Draws from the prior of a posterior, by the seed of the run (size, count).
[[nodiscard]] Eigen::MatrixXd prior_draws(const PosteriorRun& run, int count);

}  // namespace thenar
