#pragma once

/// Approximation of a contact problem by friction pyramids, a linear complementarity problem.

#include <Eigen/Core>

#include "contact/scaled_contacts.h"
#include "solvers/linear_complementarity.h"

namespace thenar::internal {

/// Contact problem with friction pyramids. Its impulses are  f = origin + generators z_1,  where
/// z_1 >= 0 are the first unknowns of the complementarity problem.
struct PyramidProblem {
  LinearComplementarity lcp;   // complementarity problem of z
  Eigen::MatrixXd generators;  // impulse of each unknown (rows, unknowns z_1)
  Eigen::VectorXd origin;      // impulses at z = 0 (rows)
};

/// Builds the problem with friction pyramids. The disc of each cone is replaced by the polygon of m
/// directions d_k, ft = sum beta_k d_k:
///   0 <= fn     _|_  un >= 0
///   0 <= beta_k _|_  d_k . ut + lambda >= 0
///   0 <= lambda _|_  mu fn - sum beta_k >= 0
/// and the ball of a soft finger by a polyhedron with m directions on the equator and on each
/// circle of latitude in steps of 2 pi / m, and both poles if m is a multiple of 4. Bilateral
/// impulses are differences of two unknowns; boxes have a multiplier for their upper bound. The
/// polygon is inscribed in the disc: the friction is too small by up to 1 - cos(pi / m) between its
/// corners, and its direction deviates from that of the slip by up to pi / m.
/// @param edges  number of edges m, even and at least 4
/// Source: [StewartTrinkle1996], [AnitescuPotra1997].
[[nodiscard]] PyramidProblem friction_pyramids(const ScaledContacts& contacts, int edges);

}  // namespace thenar::internal
