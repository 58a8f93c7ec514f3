#pragma once

/// A string over several surfaces in a row, made tangent to all of them at once.

#include <vector>

#include <Eigen/LU>

#include "hand/tree_velocity.h"
#include "tendons/wrapping/wrap_arc.h"

namespace thenar {

/// Largest number of surfaces between two points of a path.
inline constexpr int kMaxWraps = 8;

/// One surface that the string lies on.
struct ChainArc {
  const BoneSurface* surface;
  Pose<double> X;  // X_WS: its frame now
  WrapArc arc;     // frame S
};

/// Errors of tangency between a chain of arcs and its straight runs.
struct ChainFit {
  double error;    // largest angle between a run and the plane or line it should lie in [rad]
  int iterations;  // Newton steps
};

/// Newton's method on the tangency conditions, four a surface:
///   e . n = 0  and  e . b = 0  at both ends of its arc,
/// where e is the run that arrives or leaves, n the normal and b the direction across the string.
/// The exact Jacobian comes from the natural variations of a geodesic (shift along, shift across,
/// turn, lengthen) by its Jacobi fields. Derivation: docs/theory/wrapping.md. Source: [Scholz2016].
/// An end of the string may lie on the surface of the arc next to it: there the arc begins or ends.
/// @param from, to  ends of the string, world [m] (3)
/// @param chain     start of the iteration, changed in place to where it ends; at least one arc, at
///                  most kMaxWraps
[[nodiscard]] ChainFit solve_tangency(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                      std::vector<ChainArc>& chain);

namespace internal {

/// An end of an arc in the world: its place, the string's direction, the surface's normal and the
/// direction across, with their derivatives by the natural variations of the arc.
struct ArcEnd {
  Eigen::Vector3d p, t, n, b;              // [m], unit (3)
  Eigen::Matrix<double, 3, 4> dp, dn, db;  // by shift along, across, turn and lengthening (3, 4)
};
struct ArcEnds {
  ArcEnd on, off;
};

/// Velocities of the touch points of one arc, world [m/s] (3).
struct TouchRate {
  Eigen::Vector3d on, off;
};

/// Linearisation of a tangent chain: how its touch points follow its ends and surfaces.
///
/// The tangency conditions f(x, y) = 0 hold at all times, with x the natural variations of all arcs
/// and y the poses:  df/dx x' = -df/dy y'  (implicit function theorem).
class ChainTangent {
 public:
  /// @param a, b   ends of the string, world [m] (3)
  /// @param chain  tangent already, as solve_tangency() leaves it; at most kMaxWraps
  ChainTangent(Eigen::Vector3d a, Eigen::Vector3d b, const std::vector<ChainArc>& chain);

  /// Returns whether the touch points are determined. They are not if a free run has no length, nor
  /// for a string half round a sphere.
  [[nodiscard]] bool regular() const { return regular_; }

  /// @param a_dot, b_dot  velocities of the ends [m/s] (3)
  /// @param on            of the surfaces (arcs)
  /// @param out           written over (arcs)
  void rates(const Eigen::Vector3d& a_dot, const Eigen::Vector3d& b_dot,
             const std::vector<BodyTwist>& on, std::vector<TouchRate>& out) const;

 private:
  static constexpr int kMax = 4 * kMaxWraps;
  using System = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMax, kMax>;

  Eigen::Vector3d a_, b_;
  std::vector<ArcEnds> ends_;  // of all arcs
  Eigen::PartialPivLU<System> factor_;
  bool regular_ = false;
};

}  // namespace internal

// Contraction of a string of beads over surfaces: slow, but it converges from any start.

/// Replaces `chain` by the arcs where a string from a to b comes to rest: it starts over the side
/// of every surface and contracts, each bead to the middle of its neighbours and out of the
/// surfaces (Gauss and Seidel, over-relaxed). From a round side it may slip, as a string does. The
/// arcs are a start for solve_tangency(), no answer; surfaces that the string leaves are left out.
/// @param a, b   world [m] (3)
/// @param sweeps  over all beads; a few hundred
/// @param chain  surfaces with their frames, in order; their arcs start at the point `side` each
void contract_beads(const Eigen::Vector3d& a, const Eigen::Vector3d& b, int sweeps,
                    std::vector<ChainArc>& chain);

}  // namespace thenar
