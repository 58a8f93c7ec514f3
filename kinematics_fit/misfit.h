#pragma once

/// Misfit of a fit: the test whether it misses the forces by more than the stated noise allows.

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
  int numbers = 0;                // force components that are fitted [1]
  double degrees_of_freedom = 0;  // numbers - effective parameters of this experiment [1]
  double times_noise = 0;         // sqrt(chi_square / degrees_of_freedom) [1]
  double tail = 1;                // P(X >= chi_square), X chi-square of as many degrees of freedom
                                  // [1]; no less than the true one, whose variance is smaller
  /// Neither chance nor a noise that was stated somewhat too small: tail < 1e-4, and more than one
  /// prior sd of the factor on the noise, times_noise > exp(0.5) = 1.65.
  bool beyond_chance = false;
};

/// @param chi_square  [1]
/// @param numbers     measured components [1]
/// @param effective   effective parameters that the experiment determines [1]
[[nodiscard]] Misfit misfit(double chi_square, int numbers, double effective);

/// Misfit of every experiment of a fit at z, by its residuals without robust loss; effective
/// parameters sum to those of the covariance.
/// @param z  the fitted point (size)
[[nodiscard]] std::vector<Misfit> misfits(const FitProblem& problem, const Eigen::VectorXd& z,
                                          const Covariance& covariance);

/// Sentence that advises what to check if forces are missed by far.
extern const char* const kMisfitAdvice;

/// "the fit misses the forces by 7.0 times the stated noise ..: what to look at"; "" where chance
/// may be the cause.
[[nodiscard]] std::string describe(const Misfit& misfit);

}  // namespace thenar
