#pragma once

/// Single trials that do not go with the others: rows that may be turned, or of another load.

#include <string>
#include <vector>

#include "kinematics_fit/covariance.h"

namespace thenar {

/// A trial whose measured force is far from what the others tell of it.
struct OddTrial {
  int experiment;    // index in FitProblem::experiments()
  int trial;         // index in its trials, then in its rows of activations
  double distance;   // of the force from that told by all others, in sds of their difference:
                     // of three components the root of the sum of squares [1]
  double tail;       // probability of one as odd among as many trials, at most [1]
  int instead = -1;  // of the furthest: a trial that may be wrong in its stead, at least half as
                     // far and not odd once this one is left out; -1: none
};

/// Trials of which one as odd has a tail below 1e-3, the oddest first. With residuals r of a trial,
/// J = dr/dz and the covariance C of the fit, what all others tell of it is missed by
///   e = (I - H)^-1 r,   of covariance (I - H)^-1,   H = J C J',
/// so that  e' (I - H) e = r' (I - H)^-1 r  is chi-square with as many degrees of freedom as
/// components are fitted: exact for a linear model with normal priors and noise. A wrong trial
/// draws the fit from sound ones: those of its experiment that are not odd once the further ones
/// are left out, by the same linear model, are not returned.
/// @param z  the fitted point (size)
[[nodiscard]] std::vector<OddTrial> odd_trials(const FitProblem& problem, const Eigen::VectorXd& z,
                                               const Covariance& covariance);

/// A warning of each experiment with odd trials: "experiment 'H01': EXT in posture 'Hook' is 9.1
/// sds from what the other trials tell: ..".
[[nodiscard]] std::vector<std::string> describe(const FitProblem& problem,
                                                const std::vector<OddTrial>& odd);

}  // namespace thenar
