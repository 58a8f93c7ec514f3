#pragma once

/// Largest fingertip force under nonlinear constraints.

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
  kAlong,     // the force has exactly this direction
  kComponent  // the force is free; its component along the direction is maximised
};

/// Result of constrained_force().
struct ConstrainedForce {
  Status status = Status::kStalled;  // read this first
  Eigen::Vector3d force{0, 0, 0};    // force of the tip on the world, world frame [N] (3)
  double component = 0;              // component of `force` along the direction, d' f [N]
  Eigen::VectorXd tension;           // tensions that produce it [N] (m)
  Eigen::VectorXd activation;        // tension / F0, 0 where F0 is infinite or zero [1] (m)
  double excess = 0;                 // largest g of all constraints; <= 1e-8 if solved [unit of g]
  std::string message;               // reason for the end of the search
  int iterations = 0;                // iterations of the interior-point method
  KktResidual kkt_residual;  // first-order residuals. With convex constraints and no gradient left,
                             // complementarity bounds how much larger an allowed force can be [N]
  double imbalance =
      KktResidual::kUnknown;  // largest of |J' f - R' t - tau_0|, NaN without tensions [N m]
};

/// Maximises the force of a pinned tip along a direction, under further constraints:
///
///   maximise d' f  subject to  J' f = R' t + tau_0,  0 <= t <= F0,  g(f, t) <= 0.
///
/// Balance holds exactly, by a parametrisation of its null space. With convex constraints the
/// result is the global optimum to about 1e-7; otherwise it is a local one, found from the centre
/// of the set without constraints. First-order conditions are checked independently of the solver
/// before a result is called solved. kInfeasible means that the search ended where constraints are
/// violated (`excess`), which proves that no force is allowed only if the constraints are convex.
/// Without constraints max_tip_force() gives the same result exactly and a hundred times faster.
///
/// @param statics    one posture; W is not used
/// @param direction  any length but zero   3   [1]
/// @param aim        whether the force must lie along the direction
/// @param limits     any number of constraints; smooth on the feasible set
/// @throws InputError as max_tip_force(), or if a constraint returns wrong shapes.
/// Source: [Wachter2006] for the interior-point method.
[[nodiscard]] ConstrainedForce constrained_force(const TipStatics& statics,
                                                 const Eigen::Vector3d& direction,
                                                 ForceDirection aim,
                                                 const std::vector<ForceConstraint>& limits);

}  // namespace thenar
