#pragma once

/// Tendon lengths as polynomials of posture, with a certificate of their error.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "hand/skeleton.h"
#include "tendons/wrapping/wrapped_path.h"

namespace thenar {

/// Ranges of the coordinates over which a path is fitted.
struct FitBox {
  Eigen::VectorXd lower, upper;  // of each coordinate [rad] (coordinates)
};

/// The limits of a skeleton's coordinates.
[[nodiscard]] FitBox fit_box(const Skeleton& skeleton);

/// Difference between a fit and the wrapped path, in the box.
struct FitError {
  double length = 0;        // largest on the test grid [m]
  double arm = 0;           // largest of any moment arm on it [m/rad]
  double length_bound = 0;  // between the grid's points too [m]
  double arm_bound = 0;     // [m/rad]
};

/// One run between two points of a path, as a tensor of Chebyshev polynomials
///   L = sum c_{i..k} T_i(x_1) .. T_k(x_d),   x in [-1, 1] over the range of each coordinate.
struct FittedRun {
  std::vector<int> coordinates;  // that the run crosses (d)
  int order = 0;                 // of the polynomials
  Eigen::VectorXd c;             // first coordinate fastest ((order + 1)^d) [m]
};

/// The whole path; runs that cross no joint are summed in `constant`.
struct FittedPath {
  std::string name;
  FitBox box;
  double constant = 0;  // [m]
  std::vector<FittedRun> runs;
  FitError error;
};

struct FittedLength {
  double length;            // [m]
  Eigen::RowVectorXd arms;  // -dL/dq, exactly [m/rad] (coordinates)
};

/// Interpolates every run in Chebyshev points and measures the error on an even, denser grid.
/// Between its points the error of an arm may exceed the largest seen by as much as it differs at
/// worst between neighbours, summed over the coordinates; that of the length by half a mesh times
/// the bound of the arms. Derivation: docs/theory/wrapping.md.
/// @param order  of the polynomials in each coordinate, 1 to 40
/// @throws InputError if a coordinate that the path crosses has no range, or the path is not taut
/// somewhere in the box.
/// Source: [Trefethen2013] for interpolation in Chebyshev points.
[[nodiscard]] FittedPath fit_path(const Tree<double>& tree, const PathSet& set, std::size_t path,
                                  const FitBox& box, int order);

/// @param q  posture; outside the box the polynomials run wild (coordinates) [rad]
[[nodiscard]] FittedLength fitted_length(const FittedPath& path, const Eigen::VectorXd& q);

/// Computes the slopes of these arms by posture,  -d2L/dq2, exactly and symmetric [m/rad^2]
/// (coordinates, coordinates).
/// @param q  (coordinates) [rad]
[[nodiscard]] Eigen::MatrixXd arm_derivatives(const FittedPath& path, const Eigen::VectorXd& q);

}  // namespace thenar
