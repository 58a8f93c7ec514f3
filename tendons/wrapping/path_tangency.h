#pragma once

/// Tangency of a string to several surfaces in a row, solved for all of them at once.

#include <vector>

#include <Eigen/LU>

#include "hand/tree_velocity.h"
#include "tendons/wrapping/wrap_arc.h"

namespace thenar {

/// Largest number of surfaces between two points of a path.
inline constexpr int kMaxWraps = 8;

/// Surface that the string lies on, with its arc.
struct ChainArc {
  const BoneSurface* surface;
  Pose<double> X;  // X_WS: present pose of frame S
  WrapArc arc;     // contact of the string, frame S
};

/// Errors of tangency between a chain of arcs and its straight runs.
struct ChainFit {
  /// Largest angle between a run and the plane or line in which it should lie [rad].
  double error = 0;
  int iterations = 0;  // Newton steps
};

/// Solves the tangency conditions by Newton's method, four conditions per surface:
///   e . n = 0  and  e . b = 0  at both ends of its arc,
/// where e is the run that arrives or leaves, n the normal and b the direction across the string.
/// The exact Jacobian comes from the natural variations of a geodesic (shift along, shift across,
/// turn, lengthen) through its Jacobi fields. Derivation: docs/theory/wrapping.md. Source:
/// [Scholz2016].
/// An end of the string may lie on the surface of the adjacent arc: there the arc begins or ends.
/// @param from, to  ends of the string, world [m] (3)
/// @param chain     initial guess, overwritten by the last iterate; 1 to kMaxWraps arcs
[[nodiscard]] ChainFit solve_tangency(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                      std::vector<ChainArc>& chain);

namespace internal {

/// End of an arc, world frame: position, direction of the string, surface normal and direction
/// across, with their derivatives by the natural variations of the arc.
struct ArcEnd {
  Eigen::Vector3d p, t, n, b;  // position [m], tangent, normal and binormal, unit (3)
  Eigen::Matrix<double, 3, 4> dp, dn,
      db;  // derivatives by shift along, shift across, turn and lengthening (3, 4)
};
/// Ends of one arc: where the string meets the surface and where it leaves.
struct ArcEnds {
  ArcEnd on, off;
};

/// Velocities of the touch points of one arc, where the string meets and leaves it, world [m/s]
/// (3).
struct TouchRate {
  Eigen::Vector3d on, off;
};

/// Linearisation of a tangent chain: velocities of its touch points from those of its ends and
/// surfaces.
///
/// The tangency conditions f(x, y) = 0 hold at all times, with x the natural variations of all arcs
/// and y the poses:  df/dx x' = -df/dy y'  (implicit function theorem).
class ChainTangent {
 public:
  /// Factors the linear system of a chain.
  /// @param a, b   ends of the string, world [m] (3)
  /// @param chain  tangent already, as solve_tangency() leaves it; at most kMaxWraps
  ChainTangent(Eigen::Vector3d a, Eigen::Vector3d b, const std::vector<ChainArc>& chain);

  /// Returns whether the touch points are determined. They are not if a free run has no length, nor
  /// for a string half round a sphere.
  [[nodiscard]] bool regular() const { return regular_; }

  /// Computes the velocities of all touch points.
  /// @param a_dot, b_dot  velocities of the ends [m/s] (3)
  /// @param on            velocities of the surfaces (arcs)
  /// @param out           result, overwritten (arcs)
  void rates(const Eigen::Vector3d& a_dot, const Eigen::Vector3d& b_dot,
             const std::vector<BodyTwist>& on, std::vector<TouchRate>& out) const;

 private:
  static constexpr int kMax = 4 * kMaxWraps;
  using System = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMax, kMax>;

  Eigen::Vector3d a_, b_;
  std::vector<ArcEnds> ends_;  // ends of all arcs
  Eigen::PartialPivLU<System> factor_;
  bool regular_ = false;
};

}  // namespace internal

// Contraction of a string of beads over surfaces: slow, but it converges from any start.

/// Replaces `chain` by the arcs on which a string from a to b comes to rest. The string starts over
/// the side of every surface and contracts: each bead moves to the midpoint of its neighbours and
/// out of the surfaces (Gauss-Seidel with over-relaxation). It may slip off a round surface, as a
/// string does. The arcs are only an initial guess for solve_tangency(); surfaces that the string
/// leaves are removed.
/// @param a, b    ends of the string, world [m] (3)
/// @param sweeps  number of passes over all beads; a few hundred
/// @param chain   surfaces with their frames, in order; the start point of each arc is its `side`
void contract_beads(const Eigen::Vector3d& a, const Eigen::Vector3d& b, int sweeps,
                    std::vector<ChainArc>& chain);

}  // namespace thenar
