#pragma once

/// Doubts about joint axes that a fit leaves open.

#include <string>
#include <vector>

#include "kinematics_fit/covariance.h"

namespace thenar {

/// A tilt of an axis that the forces take for a tilt of the load cell, or the other way round.
struct TradedTilt {
  std::string axis, cell;  // entries of z
  double correlation;      // of both in the posterior, prior scales of both being 1 [1]
};

/// A tilt, or another number, that keeps more than this of its prior sd was not told by the data
/// [1].
inline constexpr double kUndecidedShare = 0.9;

/// Doubts about the tilts of axes that a fit reports.
struct AxisDoubts {
  int tilts = 0;                              // entries of z that tilt an axis [1]
  std::vector<CoordinateEstimate> undecided;  // tilts that keep more than kUndecidedShare
  std::vector<TradedTilt> traded;             // correlated by more than 0.8, the worst first
};

/// Looks for tilts that forces do not decide, and for those that trade places with the load cell:
/// there the prior alone says which of the two is tilted, be its scale inferred or not.
/// @param covariance  of the fit at z
[[nodiscard]] AxisDoubts find_axis_doubts(const FitProblem& problem, const Eigen::VectorXd& z,
                                          const Covariance& covariance);

/// The doubts as warnings, a sentence each; none without doubts.
[[nodiscard]] std::vector<std::string> describe(const AxisDoubts& doubts);

}  // namespace thenar
