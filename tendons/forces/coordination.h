#pragma once

/// Muscle coordination: tensions of minimal effort for a wanted fingertip force.

#include <string>

#include <Eigen/Core>

#include "base/numbers.h"
#include "solvers/status.h"
#include "tendons/tip_statics.h"

namespace thenar {

/// Options of coordinate().
struct CoordinationOptions {
  double p = 3;  // power of activation in the effort, >= 1; 3 from [Crowninshield1981] [1]
};

/// Result of coordinate().
struct Coordination {
  /// Read this first. kInfeasible: the force is out of reach; `force` is the nearest. kStalled
  /// without any result: `tension` and `force` are zero.
  Status status = Status::kStalled;
  /// Minimal-effort tensions; if infeasible, some that give `force` [N] (m).
  Eigen::VectorXd tension;
  Eigen::VectorXd activation;    // tension / F0 [1] (m)
  double effort = 0;             // sum activation^p [1]
  Eigen::Vector3d force;         // the wanted force, or the nearest within reach [N] (3)
  Eigen::VectorXd tau_residual;  // J' wanted - R' t - tau_0 [N m] (n)
  std::string message;           // reason for the end of the search, in words
  double gap = kNaN;  // upper bound of the effort that other tensions could save; if infeasible, of
                      // the decrease of |miss|^2 [N^2]; NaN if unknown
};

/// Computes the tensions of minimal effort for a wanted force of a pinned tip:
///
///   minimise sum (t_i / F0_i)^p  subject to  R' t + tau_0 = J' f,  0 <= t <= F0.
///
/// p = 1 is a linear program, whose solution uses as few muscles as joints; p > 1 is strictly
/// convex with a unique solution that shares load among synergists. Both are convex, so the
/// multipliers of the bounds give a duality gap, which is checked before a result is called solved.
/// Balance is exact; effort is minimal to about 1e-12, so a silent muscle shows an activation of up
/// to 1e-13^(1/p): 3e-7 for p = 2, 5e-5 for p = 3. A force out of reach gives kInfeasible, the
/// nearest force within reach and the residual torque; if no force at all balances tau_0, `force`
/// and tensions are zero.
///
/// @param statics  one posture; W is not used; every F0 finite. F0 = 0 removes a muscle.
/// @param f        wanted force of the tip on the world, world frame   3   [N]
/// @throws InputError if the statics are inconsistent or not finite, an F0 is infinite, f is not
/// finite, or p < 1.
/// Source: [Crowninshield1981], with F0 in proportion to physiological cross-section.
[[nodiscard]] Coordination coordinate(const TipStatics& statics, const Eigen::Vector3d& f,
                                      const CoordinationOptions& options = {});

}  // namespace thenar
