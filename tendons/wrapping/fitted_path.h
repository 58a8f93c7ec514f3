#pragma once

/// Tendon lengths as polynomials of posture, with bounds of their error.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "hand/skeleton.h"
#include "tendons/wrapping/wrapped_path.h"

namespace thenar {

/// Ranges of the coordinates over which a path is fitted.
struct FitBox {
  Eigen::VectorXd lower, upper;  // bounds of each coordinate [rad] (coordinates)
};

/// Returns the limits of a skeleton's coordinates.
[[nodiscard]] FitBox fit_box(const Skeleton& skeleton);

/// Difference between a fit and the wrapped path, within the box.
struct FitError {
  double length = 0;        // largest length error on the test grid [m]
  double arm = 0;           // largest error of any moment arm on the test grid [m/rad]
  double length_bound = 0;  // length error that also covers points between those of the grid [m]
  /// Moment-arm error that also covers points between those of the grid [m/rad].
  double arm_bound = 0;
};

/// Run between two points of a path, as a tensor product of Chebyshev polynomials
///   L = sum c_{i..k} T_i(x_1) .. T_k(x_d),   x in [-1, 1] over the range of each coordinate.
struct FittedRun {
  std::vector<int> coordinates;  // coordinates whose joints the run crosses (d)
  int order = 0;                 // order of the polynomials in each coordinate
  Eigen::VectorXd c;             // coefficients, first coordinate fastest ((order + 1)^d) [m]
};

/// Fitted path; runs that cross no joint are summed in `constant`.
struct FittedPath {
  std::string name;
  FitBox box;
  double constant = 0;  // length of the runs that cross no joint [m]
  std::vector<FittedRun> runs;
  FitError error;
};

/// Length of a fitted path, with its moment arms.
struct FittedLength {
  double length = 0;  // [m]
  /// Moment arms -dL/dq, the exact gradient of the fit [m/rad] (coordinates).
  Eigen::RowVectorXd arms;
};

/// Interpolates every run at Chebyshev points and measures the error on an even, denser grid.
/// Between grid points the error of an arm may exceed the largest measured one by as much as it
/// differs at most between neighbours, summed over the coordinates; that of the length by half a
/// mesh width times the bound of the arms. Derivation: docs/theory/wrapping.md.
/// @param order  order of the polynomials in each coordinate, 1 to 40
/// @throws InputError if a coordinate that the path crosses has no range, or the path is not taut
/// somewhere in the box.
/// Source: [Trefethen2013] for interpolation at Chebyshev points.
[[nodiscard]] FittedPath fit_path(const Tree<double>& tree, const PathSet& set, std::size_t path,
                                  const FitBox& box, int order);

/// Evaluates length and moment arms of a fitted path.
/// @param q  posture; outside the box the polynomials diverge (coordinates) [rad]
[[nodiscard]] FittedLength fitted_length(const FittedPath& path, const Eigen::VectorXd& q);

/// Computes the derivatives of the fitted moment arms,  -d2L/dq2, exact for the fit and symmetric
/// [m/rad^2] (coordinates, coordinates).
/// @param q  posture (coordinates) [rad]
[[nodiscard]] Eigen::MatrixXd arm_derivatives(const FittedPath& path, const Eigen::VectorXd& q);

}  // namespace thenar
