#pragma once

/// Mean and variance of predicted forces if the parameters of the digit are uncertain.

#include <vector>

#include "kinematics_fit/force_jacobian.h"

namespace thenar {

/// Largest nonlinearity of steps for which the expansion is used, in sds of a force [1].
inline constexpr double kMaxUnevenness = 0.1;
inline constexpr int kMomentDraws = 1000;  // number of draws for a force beyond it

/// Median and width of the draws of a number, insensitive to outliers.
struct RobustMoments {
  double median = 0;
  double sd = 0;  // half the width of the central 95 % over that of a standard normal
};

/// Computes the moments of the finite values; NaN if there are none.
[[nodiscard]] RobustMoments robust_moments(const Eigen::VectorXd& draws);

/// Moments of each force component, without noise.
struct PredictiveMoments {
  Eigen::Matrix3Xd mean;       // [N] (3, trials)
  Eigen::VectorXd variance;    // [N^2] (3 trials)
  std::vector<bool> by_draws;  // trials whose forces are too nonlinear for the expansion (trials)
};

/// Computes the moments of f(u), u ~ N(center, V), to second order. With V = L L', l a column of L,
/// and d_l = (f(center + l) - 2 f(center) + f(center - l)) / 2:
///   mean = f(center) + sum_l d_l,   variance = diag(J V J') + 2 sum_l d_l^2.
/// The mean is that of the quadratic approximation of f (1/2 tr H V added to f); its variance
/// neglects mixed second derivatives. For example, a load cell tilted by an unknown angle of 12
/// degrees about each of two axes shortens the mean force by 4 %. Steps end at the bounds of their
/// parameters, symmetrically: a parameter that the data push against a bound stays there, and the
/// mean does not depend on the choice of the root L.
///
/// Near a posture with a singular tip the expansion may point in the opposite direction. A trial in
/// which odd parts of the steps differ from the linear ones, or even parts exceed them,
///   sum_l |(f(center + l) - f(center - l)) / 2 - J l|^2 > kMaxUnevenness^2 tr(J V J')   or
///   sum_l |d_l|^2 > tr(J V J'),
/// or in which a step has no force, is evaluated by kMomentDraws draws of u: the median of each
/// component, and half the width of its central 95 % over that of a standard normal. Such forces
/// may have no mean.
/// @param V  [SI^2] (coordinates, coordinates), positive semidefinite
[[nodiscard]] PredictiveMoments predictive_moments(const TendonDigit& digit,
                                                   const FitParameters& parameters,
                                                   const ExperimentPlan& plan,
                                                   const Eigen::VectorXd& center,
                                                   const Eigen::MatrixXd& V);

}  // namespace thenar
