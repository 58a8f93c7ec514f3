#pragma once

/// A string over several surfaces in a row, made tangent to all of them at once.

#include <vector>

#include "tendons/wrapping/wrap_arc.h"

namespace thenar {

/// Most surfaces between two points of a path.
inline constexpr int kMostBends = 8;

/// One surface that the string lies on.
struct ChainArc {
  const BoneSurface* surface;
  Pose<double> X;  // X_WS: its frame now
  WrapArc arc;     // frame S
};

/// How well a chain of arcs is tangent to its straight runs.
struct ChainFit {
  double error;    // largest angle between a run and the plane or line it should lie in [rad]
  int iterations;  // Newton steps
};

/// Newton's method on the tangency conditions, four a surface:
///   e . n = 0  and  e . b = 0  at both ends of its arc,
/// e the run that arrives or leaves, n the normal, b across the string. The exact Jacobian comes
/// from the natural variations of a geodesic (shift along, shift across, turn, lengthen) by its
/// Jacobi fields. Derivation: docs/theory/wrapping.md. Source: [Scholz2016].
/// @param a, b    ends of the string, world [m] (3)
/// @param chain   start of the iteration, changed in place to where it ends; at most kMostBends
[[nodiscard]] ChainFit straighten(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                  std::vector<ChainArc>& chain);

}  // namespace thenar
