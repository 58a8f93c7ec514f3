#pragma once

/// The contact problem with friction pyramids, as a linear complementarity problem.

#include <Eigen/Core>

#include "contact/scaled_contacts.h"
#include "solvers/linear_complementarity.h"

namespace thenar::internal {

/// Impulses are  f = origin + generators z_1  of the first unknowns z_1 >= 0.
struct PyramidProblem {
  LinearComplementarity lcp;
  Eigen::MatrixXd generators;  // (rows, unknowns of impulses)
  Eigen::VectorXd origin;      // (rows)
};

/// Each cone's disc becomes the polygon of m directions d_k, ft = sum beta_k d_k:
///   0 <= fn     _|_  un >= 0
///   0 <= beta_k _|_  d_k . ut + lambda >= 0
///   0 <= lambda _|_  mu fn - sum beta_k >= 0
/// and a soft finger's ball a polyhedron, with m directions on the equator and on each circle of
/// latitude in steps of 2 pi / m, and both poles if m divides by 4. Bilateral impulses are
/// differences of two unknowns; boxes have a multiplier for their upper end. The polygon lies
/// within the disc: it loses up to 1 - cos(pi / m) of friction between its corners, and slip may be
/// aside from the friction force by pi / m.
/// @param edges  m, even and at least 4
/// Source: [StewartTrinkle1996], [AnitescuPotra1997].
[[nodiscard]] PyramidProblem friction_pyramids(const ScaledContacts& contacts, int edges);

}  // namespace thenar::internal
