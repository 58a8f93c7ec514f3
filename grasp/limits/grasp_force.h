#pragma once

/// Minimum grasp force that holds a load.

#include "grasp/limits/force_set.h"

namespace thenar {

/// Quantity that minimum_grasp_force() minimises.
enum class GraspForceObjective {
  kSum,     // sum of all normal forces: total effort
  kLargest  // largest normal force of a patch, summed over its points: force of the most loaded
            // finger
};

/// Result of minimum_grasp_force().
struct [[nodiscard]] GraspForce {
  /// kInfeasible: proof that contacts and limits cannot hold the load.
  Status status = Status::kStalled;
  double objective = 0;  // sum of the normal forces, or that of the most loaded patch [N]; infinite
                         // if infeasible
  ContactForces forces;  // an optimal choice
  ScaledWrench
      unbalanced;       // wrench of the contacts plus resistible_part() of the load: rounding error
  double residual = 0;  // largest of the scaled KKT conditions [1]
};

/// Finds the smallest contact forces in equilibrium with a load:
///   minimise  sum of f_n, or max over patches of their sums,
///   subject to  W y = -load,  y in the force set.
///
/// The objective does not depend on the number of points of a patch: a point between others with
/// the same normal and friction exerts no wrench that they cannot exert together, at the same sum.
/// A zero load needs no force. With free_forces() only friction limits the forces, with
/// hand_forces() the efforts of the hand do, too.
/// @param load  load on the object, torque / scale (6) [N]
/// @throws InputError if the load is not finite.
/// Source: [Boyd2007], section II, with friction as second-order cones.
GraspForce minimum_grasp_force(const ForceSet& forces, const ScaledWrench& load,
                               GraspForceObjective objective);

}  // namespace thenar
