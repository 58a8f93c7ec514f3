#pragma once

/// The least squeezing that holds a load.

#include "grasp/limits/force_set.h"

namespace thenar {

/// What is kept small.
enum class GraspForceObjective {
  kSum,     // the sum of all normal forces: effort in all
  kLargest  // the largest normal force of a patch, summed over its points: what the most loaded
            // finger must press
};

struct [[nodiscard]] GraspForce {
  ConeStatus status;     // kInfeasible: these contacts and limits cannot hold the load, proven
  double objective;      // sum of the normal forces, or that of the most loaded patch [N]; infinite
                         // where infeasible
  ContactForces forces;  // one optimal choice
  ScaledWrench unbalanced;  // wrench of the contacts plus load: zero but for rounding [N] (6)
  double residual;          // largest of the scaled KKT conditions [1]
};

/// Smallest contact forces in equilibrium with a load:
///   minimise  sum of f_n, or max over patches of their sums,
///   subject to  W y = -load,  y in the force set.
///
/// How finely a patch is cut into points changes neither: a point between others of one normal and
/// friction makes no wrench that they do not make together, at the same sum.
/// A load of zero is held by no force at all. free_forces() asks of friction alone, hand_forces()
/// also of the hand's efforts.
/// @param load  on the object, torque / scale (6) [N]
/// @throws InputError if the load is not finite.
/// Source: [Boyd2007], section II, whose friction cones are second-order cones, too.
GraspForce minimum_grasp_force(const ForceSet& forces, const ScaledWrench& load,
                               GraspForceObjective objective);

}  // namespace thenar
