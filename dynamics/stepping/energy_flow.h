#pragma once

/// Energy flows into a scene and out of it.

#include <Eigen/Core>

#include "dynamics/mechanism/tree_motion.h"
#include "dynamics/stepping/moving_scene.h"

namespace thenar {

/// Energy flows since the start of a scene, each the integral of a power over the motion, and two
/// measures of the energy turned over, to which errors are related.
enum EnergyFlow : Eigen::Index {
  kAppliedWork,    // work of forces and drives on the scene
  kDamperLoss,     // energy dissipated by dampers of joints
  kPassiveWork,    // work of passive elements on the scene
  kFrictionLoss,   // energy dissipated by friction of contacts and dry friction of joints
  kImpactLoss,     // energy dissipated along contact normals and at joint limits
  kWorkMagnitude,  // sum over steps of |work| of forces and drives, and of active elements
  kMaxKinetic      // largest kinetic energy so far
};
inline constexpr Eigen::Index kFreeFlowCount =
    3;  // number of flows without contacts: the first ones
using EnergyFlows = Eigen::Matrix<double, 7, 1>;  // [J] (7)

/// Returns true if forces, drives or dampers of joints act in a scene at any time.
[[nodiscard]] bool has_powers(const MovingScene& scene);

/// State at which the efforts of a step were computed, and the velocities before and after it. A
/// step linearises efforts: a spring and damper of stiffness K and damping D with the effort tau at
/// (q, v) acts with  tau - (theta D + theta^2 h K) (v_end - v).  A single instant has v_end = v.
struct StepEfforts {
  double t, selection_time;              // instants as in ElementInput [s]
  double h, theta;                       // step length [s]; 1: implicit Euler, 1/2: midpoint [1]
  const Eigen::VectorXd &q, &v, &v_end;  // positions and velocities (q), (v), (v)
};

/// Mean powers over a step.
struct AppliedPowers {
  double applied = 0;  // of forces and drives on the scene, rate of kAppliedWork [W]
  double damped = 0;   // dissipated by dampers of joints, rate of kDamperLoss [W]
};

/// Computes the mean powers of forces and drives, and of joint dampers, over a step: linearised
/// efforts times the mean velocity.
/// @param motion  velocities of links and loads of the active forces, whose power it gives
[[nodiscard]] AppliedPowers applied_powers(const MovingScene& scene, const MechanismLayout& layout,
                                           const TreeMotion<double>& motion, const StepEfforts& at);

}  // namespace thenar
