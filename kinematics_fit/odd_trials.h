#pragma once

/// Outlier trials: rows of data that may have a wrong sign or load.

#include <string>
#include <vector>

#include "kinematics_fit/covariance.h"

namespace thenar {

/// Trial whose measured force is far from that predicted by the others.
struct OddTrial {
  int experiment = 0;   // index in FitProblem::experiments()
  int trial = 0;        // index in its trials, followed by its activation rows
  double distance = 0;  // distance of the force from that predicted by all others, in sds of their
                        // difference; root of the sum of squares over the components [1]
  double tail = 0;   // upper bound of the probability of such an outlier among as many trials [1]
  int instead = -1;  // for the furthest trial: another one that may be wrong instead, at least half
                     // as far and no outlier without this one; -1: none
};

/// Returns the outliers with a tail below 1e-3, furthest first. With residuals r of a trial, J =
/// dr/dz and the covariance C of the fit, the leave-one-out residual is
///   e = (I - H)^-1 r,   of covariance (I - H)^-1,   H = J C J',
/// so that  e' (I - H) e = r' (I - H)^-1 r  is chi-square with as many degrees of freedom as
/// components are fitted: exact for a linear model with normal priors and noise. A wrong trial also
/// pulls the fit away from correct ones: trials of an experiment that are not outliers once the
/// further ones are left out, by the same linear model, are not returned.
/// @param z  the fitted point (size)
[[nodiscard]] std::vector<OddTrial> odd_trials(const FitProblem& problem, const Eigen::VectorXd& z,
                                               const Covariance& covariance);

/// Returns a warning for each experiment with outliers: "experiment 'H01': EXT in posture 'Hook' is
/// 9.1 sds from what the other trials tell: ..".
[[nodiscard]] std::vector<std::string> describe(const FitProblem& problem,
                                                const std::vector<OddTrial>& odd);

}  // namespace thenar
