#pragma once

/// Set of all forces that a pinned fingertip can exert.

#include <string>

#include <Eigen/Core>

#include "solvers/status.h"
#include "tendons/tip_statics.h"

namespace thenar {

/// Feasible force set, conv(vertices) + span(carried).
struct FeasibleForceSet {
  Status status = Status::kSolved;  // read this first. kInfeasible: the set is empty; all members
                                    // below are empty or zero
  int dimension = -1;          // dimension of conv(vertices): 3, or 2 1 0 if flat, -1 if empty
  double volume = 0;           // volume of conv(vertices) [N^dimension], 1 for a point
  Eigen::MatrixX3d vertices;   // corners; of a polygon in order [N] (k, 3)
  Eigen::MatrixX3i triangles;  // rows of vertices, counterclockwise from outside (l, 3)
  Eigen::MatrixX3d normals;    // outward, one per facet; empty unless dimension is 3 [1] (s, 3)
  Eigen::VectorXd offsets;     // normals f <= offsets [N] (s)
  Eigen::MatrixXd tension;     // tensions that produce each vertex, not unique [N] (k, m)
  Eigen::MatrixXd activation;  // tension / F0, 0 where F0 is 0 [1] (k, m)
  Eigen::Matrix3Xd carried;    // directions that the skeleton carries alone, orthonormal [1] (3, c)
  double excess = 0;     // amount by which forces may exceed a facet, over the set's extent [1]
  double imbalance = 0;  // largest of |J' f - R' t - tau_0| at the vertices [N m]
  std::string message;   // reason, if status is kStalled
};

/// Computes the feasible force set { f : J' f = R' t + tau_0, 0 <= t <= F0 } of a pinned tip,
/// exactly.
///
/// A straight or planar finger carries some directions without tendons (J' f = 0). The set is then
/// unbounded along those; `carried` holds them and the vertices describe the part across them.
/// Facets are certified: the largest force along each normal, by linear programming, exceeds the
/// facet by less than 1e-9 of the set's extent (1e-6 for a needle-like set); `excess` is the actual
/// value. The hull is closed, contains all its points, and has the same volume by integration along
/// x, y and z. A set thinner than 1e-9 of its size counts as flat.
///
/// @param statics  one posture; W is not used. An infinite F0 gives kUnbounded, without vertices,
/// wherever the set is then unbounded.
/// @throws InputError if the statics are inconsistent or not finite.
/// Source: [ValeroCuevas1998] for the set; growing a hull by support points is beneath-beyond with
/// an oracle [Barber1996]; derivation in docs/theory/feasible_force.md.
[[nodiscard]] FeasibleForceSet feasible_force_set(const TipStatics& statics);

}  // namespace thenar
