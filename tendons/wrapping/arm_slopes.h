#pragma once

/// Posture derivatives of the moment arms of wrapped tendons: second derivatives of length.
///
/// With touch points x that keep the path tangent, f(x, q) = 0, the arms are R(x, q) and
///   dR/dq = R_q - R_x f_x^-1 f_q      (implicit function theorem),
/// which is -d2L/dq2 and symmetric. Where a string just touches a surface the arms are continuous
/// and their derivatives jump; the result is one of the two one-sided derivatives. Derivation:
/// docs/theory/wrapping.md.

#include <vector>

#include "tendons/wrapping/path_solver.h"

namespace thenar {

/// Derivatives of the moment arms of one path.
struct [[nodiscard]] ArmDerivatives {
  /// False: the path is not taut, or touch points are not determined; dR is then zero.
  bool exist = true;
  Eigen::MatrixXd dR;  // d R_j / d q_k  [m/rad^2] (coordinates, coordinates)
};

/// Computes the derivatives of the moment arms of path_arms(), for every path. An origin that rides
/// on another tendon follows that tendon's excursion. Where its carrier bends there
/// (PathStatus::kRidesOnBend) its arms are not the gradient of a length, and no derivatives exist.
[[nodiscard]] std::vector<ArmDerivatives> arm_derivatives(const Tree<double>& tree,
                                                          const TreeState<double>& state,
                                                          const PathSet& set,
                                                          const std::vector<PathShape>& shapes,
                                                          int coordinates);

}  // namespace thenar
