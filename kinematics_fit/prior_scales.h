#pragma once

/// Width of priors, decided by the forces themselves: empirical Bayes.

#include <vector>

#include <Eigen/Core>

#include "kinematics_fit/fit_problem.h"
#include "solvers/least_squares.h"

namespace thenar {

/// Forces of one specimen, linear in the whitened entries about a fit:
///   b = J_0 z_0 + sum_g s_g J_g z_g + noise,   all z ~ N(0, 1),   noise ~ N(0, 1),
/// with s_g the factor of prior scale g, and 0 for what belongs to none.
struct LinearForces {
  Eigen::VectorXd b;                    // J z - r at the fit, in noise sds [1] (numbers)
  Eigen::MatrixXd unscaled;             // J_0 J_0' [1] (numbers, numbers)
  std::vector<Eigen::MatrixXd> scaled;  // J_g J_g' of each scale [1] (numbers, numbers)
};

/// LinearForces of every specimen of a problem at z.
[[nodiscard]] std::vector<LinearForces> linear_forces(const FitProblem& problem,
                                                      const Eigen::VectorXd& z);

/// Marginal likelihood of the forces, without the constant,
///   log N(b; 0, V),   V = noise^2 I + J_0 J_0' + sum_g s_g^2 J_g J_g'   [nat].
/// @param factors  s_g [1] (scales)
/// @param noise    factor on the stated noise [1]
[[nodiscard]] double log_evidence(const LinearForces& forces, const std::vector<double>& factors,
                                  double noise = 1);

/// Scale of each entry of z that moves a specimen, the population's, then its own; -1: none.
[[nodiscard]] std::vector<int> scale_of_entries(const FitCoordinates& coordinates);

/// Log evidence by which other prior scales must beat the stated ones [nat].
inline constexpr double kScaleGain = 10;

/// A fit, and the problem that was fitted: with the prior scales that its forces ask for.
struct ScaledFit {
  FitProblem problem;
  Solution solution;
  double gain = 0;      // log evidence of other scales beyond that of the stated ones [nat]
  bool settled = true;  // one more round would choose the same factors
};

/// Fits with priors as stated, all factors 1, and looks for those that maximise
///   sum over specimens of log N(b; 0, V(s)) - 1/2 sum_g (log(s_g / likeliest_g) / spread_g)^2
/// among preferred numbers, ten a decade, from 0.01 to the largest of each scale. The model is
/// linear about a fit only, so a fit by some factors chooses them anew, until they stay. Where they
/// gain more than kScaleGain, forces speak against the stated widths; then the narrowest are a
/// second start, from draws of their prior, and the likelier of both is the answer. Else the answer
/// is the fit as stated. Each specimen counts by itself, as if it had been fitted alone. A problem
/// without scales is fitted once.
/// @param options  of the last fit; those before it are Ceres'
[[nodiscard]] ScaledFit fit_with_scales(const FitProblem& problem,
                                        const SolveOptions& options = {});

/// The noise that the forces of one specimen ask for.
struct NoiseEvidence {
  double factor = 1;  // on the stated noise, the likeliest beside its own prior scales [1]
  double gain = 0;    // log evidence beyond that of the stated noise [nat]

  /// Stated at least two times too small, by a likelihood ratio of 5 % chance.
  [[nodiscard]] bool understated() const { return factor >= 2 && gain > 1.92; }
};

/// Computes the noise evidence of every specimen at z. Prior scales are chosen anew beside the
/// noise: wide priors take up any force, so that the sum of squares of residuals alone says nothing
/// about noise.
[[nodiscard]] std::vector<NoiseEvidence> noise_evidence(const FitProblem& problem,
                                                        const Eigen::VectorXd& z);

}  // namespace thenar
