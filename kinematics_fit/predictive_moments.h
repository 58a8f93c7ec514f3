#pragma once

/// Mean and variance of predicted forces where the parameters of the digit are uncertain.

#include <vector>

#include "kinematics_fit/force_jacobian.h"

namespace thenar {

/// Largest unevenness of steps, in sds of a force [1], and number of draws for a force beyond it.
inline constexpr double kMaxUnevenness = 0.1;
inline constexpr int kMomentDraws = 1000;

/// Median and width of the draws of a number, insensitive to their tails.
struct RobustMoments {
  double median;
  double
      sd;  // half the width of the central 95 % over that of a standard normal: the sd, if normal
};

/// Computes the moments of the finite values; NaN if there are none.
[[nodiscard]] RobustMoments robust_moments(const Eigen::VectorXd& draws);

/// Moments of each force component, without noise.
struct PredictiveMoments {
  Eigen::Matrix3Xd mean;       // [N] (3, trials)
  Eigen::VectorXd variance;    // [N^2] (3 trials)
  std::vector<bool> by_draws;  // whose forces bend too much for the expansion (trials)
};

/// Moments of f(u), u ~ N(center, V), to second order. With V = L L', l a column of L, and
/// d_l = (f(center + l) - 2 f(center) + f(center - l)) / 2:
///   mean = f(center) + sum_l d_l,   variance = diag(J V J') + 2 sum_l d_l^2.
/// The mean is that of the quadratic that f is taken for (1/2 tr H V beyond f); of its variance the
/// part of mixed second derivatives is left out. A load cell tilted by an unknown angle of 12
/// degrees about each of two axes shortens the mean force by 4 %.
/// Steps end at the bounds of their parameters, alike on both sides: what a bound holds stays
/// there, as data push it, and the mean does not hang on which root L is.
///
/// Near a posture in which the tip is singular that expansion may point the opposite way. A trial
/// in which odd parts of the steps differ from their slopes, or even parts exceed them,
///   sum_l |(f(center + l) - f(center - l)) / 2 - J l|^2 > kMaxUnevenness^2 tr(J V J')   or
///   sum_l |d_l|^2 > tr(J V J'),
/// or a step has no force, is told by kMomentDraws draws of u: the median of each component, and
/// half the width of its central 95 % over that of a standard normal. Such forces need have no
/// mean.
/// @param V  [SI^2] (coordinates, coordinates), positive semidefinite
[[nodiscard]] PredictiveMoments predictive_moments(const TendonDigit& digit,
                                                   const FitParameters& parameters,
                                                   const ExperimentPlan& plan,
                                                   const Eigen::VectorXd& center,
                                                   const Eigen::MatrixXd& V);

}  // namespace thenar
