#pragma once

/// The largest fingertip force under nonlinear constraints.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "solvers/nonlinear_program.h"
#include "solvers/status.h"
#include "tendons/forces/force_constraints.h"
#include "tendons/tip_statics.h"

namespace thenar {

/// Meaning of the direction given to constrained_force().
enum class ForceDirection {
  kAlong,     // the force has this direction exactly
  kComponent  // the force is free; its component along the direction is what grows
};

struct ConstrainedForce {
  Status status;               // read this first
  Eigen::Vector3d force;       // of the tip on the world, world frame          [N] (3)
  double component;            // of `force` along the direction, d' f          [N]
  Eigen::VectorXd tension;     // that makes it                                 [N] (m)
  Eigen::VectorXd activation;  // tension / F0, 0 where F0 is infinite or zero  [1] (m)
  double excess;               // largest g of all limits; <= 1e-8 if solved    [unit of g]
  std::string message;         // how it ended
  int iterations;              // of the interior-point method
  KktResidual kkt_residual;    // complementarity [N]: with convex limits and no slope left, no
                               // allowed force is larger by more
  double imbalance;            // largest of |J' f - R' t - tau_0|, NaN without tensions [N m]
};

/// The largest force of a pinned tip along a direction, under further limits:
///
///   maximise d' f  subject to  J' f = R' t + tau_0,  0 <= t <= F0,  g(f, t) <= 0.
///
/// Balance is kept exactly by parametrising its null space. With convex limits the answer is the
/// global optimum to about 1e-7; otherwise it is a local one, found from the middle of the set that
/// has no limits. First-order conditions are checked in arithmetic of our own before a result is
/// called solved; kInfeasible says that the search ended where limits are violated (`excess`),
/// which proves that there is no allowed force only if limits are convex. Without limits
/// max_tip_force() does the same exactly and a hundred times faster.
///
/// @param statics    one posture; W is not looked at
/// @param direction  any length but zero   3   [1]
/// @param aim        whether the force must lie along the direction
/// @param limits     any number; smooth on the feasible set
/// @throws InputError as max_tip_force(), or if a limit returns wrong shapes.
/// Source: [Wachter2006] for the interior-point method.
[[nodiscard]] ConstrainedForce constrained_force(const TipStatics& statics,
                                                 const Eigen::Vector3d& direction,
                                                 ForceDirection aim,
                                                 const std::vector<ForceConstraint>& limits);

}  // namespace thenar
