#pragma once

/// Misfit of a fit: test whether the force errors exceed the stated noise.

#include <string>
#include <vector>

#include "kinematics_fit/covariance.h"

namespace thenar {

/// Misfit of one experiment. With residuals r = (predicted - measured) / sd and J = dr/dz at the
/// fit, the expected sum of squares under model, priors and noise is the number of degrees of
/// freedom (exact for a linear model with normal priors and noise):
///   E r'r = numbers - tr(J C J').
struct Misfit {
  double chi_square = 0;          // r'r [1]
  int numbers = 0;                // number of fitted force components [1]
  double degrees_of_freedom = 0;  // numbers - effective parameters of this experiment [1]
  double times_noise = 0;         // sqrt(chi_square / degrees_of_freedom) [1]
  double tail = 1;  // upper bound of the p-value: P(X >= chi_square) of a chi-square variable,
                    // whose variance is larger than the true one [1]
  /// True if neither chance nor slightly understated noise explains the misfit: tail < 1e-4, and
  /// the noise factor is more than one prior sd too large, times_noise > exp(0.5) = 1.65.
  bool beyond_chance = false;
};

/// Computes the misfit from a sum of squares.
/// @param chi_square  sum of squared residuals [1]
/// @param numbers     number of measured components [1]
/// @param effective   number of effective parameters that the experiment determines [1]
[[nodiscard]] Misfit compute_misfit(double chi_square, int numbers, double effective);

/// Computes the misfit of every experiment of a fit at z, from residuals without robust loss;
/// effective parameters sum to those of the covariance.
/// @param z  the fitted point (size)
[[nodiscard]] std::vector<Misfit> misfits(const FitProblem& problem, const Eigen::VectorXd& z,
                                          const Covariance& covariance);

/// Sentence that advises what to check if force errors are large.
extern const char* const kMisfitAdvice;

/// Describes a misfit: "the fit misses the forces by 7.0 times the stated noise ..: what to look
/// at"; "" if it may be due to chance.
[[nodiscard]] std::string describe(const Misfit& misfit);

}  // namespace thenar
