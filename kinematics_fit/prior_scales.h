#pragma once

/// Prior scales inferred from the forces: empirical Bayes.

#include <vector>

#include <Eigen/Core>

#include "kinematics_fit/fit_problem.h"
#include "solvers/least_squares.h"

namespace thenar {

/// Forces of one specimen, linearised in the whitened entries at a fit:
///   b = J_0 z_0 + sum_g s_g J_g z_g + noise,   all z ~ N(0, 1),   noise ~ N(0, 1),
/// with s_g the factor of prior scale g, and group 0 for entries without a scale.
struct LinearForces {
  Eigen::VectorXd b;                    // J z - r at the fit, in noise sds [1] (numbers)
  Eigen::MatrixXd unscaled;             // J_0 J_0' [1] (numbers, numbers)
  std::vector<Eigen::MatrixXd> scaled;  // J_g J_g' of each scale [1] (numbers, numbers)
};

/// Linearises the forces of every specimen of a problem at z.
[[nodiscard]] std::vector<LinearForces> linear_forces(const FitProblem& problem,
                                                      const Eigen::VectorXd& z);

/// Computes the marginal likelihood of the forces, without the constant,
///   log N(b; 0, V),   V = noise^2 I + J_0 J_0' + sum_g s_g^2 J_g J_g'   [nat].
/// @param factors  s_g [1] (scales)
/// @param noise    factor on the stated noise [1]
[[nodiscard]] double log_evidence(const LinearForces& forces, const std::vector<double>& factors,
                                  double noise = 1);

/// Returns the scale of each entry of z that moves a specimen, the population's entries first; -1:
/// none.
[[nodiscard]] std::vector<int> scale_of_entries(const FitCoordinates& coordinates);

/// Gain in log evidence above which inferred prior scales replace the stated ones [nat].
inline constexpr double kScaleGain = 10;

/// Fit with its problem, which includes the inferred prior scales.
struct ScaledFit {
  FitProblem problem;
  Solution solution;
  double gain = 0;      // gain in log evidence over the stated scales [nat]
  bool settled = true;  // another iteration would choose the same factors
};

/// Fits with the stated priors, all factors 1, and finds the factors that maximise
///   sum over specimens of log N(b; 0, V(s)) - 1/2 sum_g (log(s_g / likeliest_g) / spread_g)^2
/// among preferred numbers, ten per decade, from 0.01 to the maximum of each scale. The model is
/// only linear near a fit, so fitting and choosing factors alternate until the factors stay the
/// same. If they gain more than kScaleGain, the forces contradict the stated widths: a second
/// search starts with the narrowest scales and draws from their prior, and the likelier result is
/// returned. Otherwise the result is the fit with stated priors. Each specimen is treated as if
/// fitted alone. A problem without scales is fitted once.
/// @param options  options of the final fit; earlier fits use Ceres
[[nodiscard]] ScaledFit fit_with_scales(const FitProblem& problem,
                                        const SolveOptions& options = {});

/// Noise level that the forces of one specimen suggest.
struct NoiseEvidence {
  double factor = 1;  // most likely factor on the stated noise, with its own prior scales [1]
  double gain = 0;    // gain in log evidence over the stated noise [nat]

  /// Returns whether the stated noise is at least two times too small, by a likelihood ratio test
  /// at 5 %.
  [[nodiscard]] bool understated() const { return factor >= 2 && gain > 1.92; }
};

/// Computes the noise evidence of every specimen at z. Prior scales are optimised together with the
/// noise: wide priors absorb any force, so that the sum of squared residuals alone does not
/// determine the noise.
[[nodiscard]] std::vector<NoiseEvidence> noise_evidence(const FitProblem& problem,
                                                        const Eigen::VectorXd& z);

}  // namespace thenar
