#pragma once

/// Energy flows into a scene and out of it.

#include <Eigen/Core>

#include "dynamics/mechanism/tree_motion.h"
#include "dynamics/stepping/moving_scene.h"

namespace thenar {

/// Flows of energy since the start of a scene, each the integral of a power over the motion, and
/// two measures of how much energy there was to keep account of.
enum EnergyFlow : Eigen::Index {
  kApplied,     // work of forces and drives on the scene
  kDamped,      // what dampers of joints took
  kPassive,     // work of passive elements on the scene
  kRubbed,      // what friction of contacts and dry friction of joints took
  kStruck,      // what contacts took along their normals, and joint limits: impacts
  kWorked,      // work of forces, drives and active elements, the size of that of each step
  kMostKinetic  // largest kinetic energy
};
inline constexpr Eigen::Index kFreeFlows = 3;     // those that go on where nothing touches
using EnergyFlows = Eigen::Matrix<double, 7, 1>;  // [J] (7)

/// Returns true if forces, drives or dampers of joints act in a scene at any time.
[[nodiscard]] bool has_powers(const MovingScene& scene);

/// State at which the efforts of a step were computed, and the speeds before and after the step. A
/// step has efforts with their slopes: of a spring and damper with stiffness K and damping D that
/// give tau at (q, v),
///   tau - (share D + share^2 h K) (v_end - v).
/// An instant by itself has v_end = v.
struct StepEfforts {
  double t, acting;                      // as ElementInput [s]
  double h, share;                       // length of the step [s]; 1: slopes at its end, 1/2: mean
  const Eigen::VectorXd &q, &v, &v_end;  // (q), (v), (v)
};

/// Mean powers of forces and drives, and what the dampers of joints take, over a step: efforts with
/// their slopes, times the mean of the speeds.
/// @param motion  with loads of the forces that act; these count at the speeds that it has
/// @return kApplied and kDamped [W] (2)
[[nodiscard]] Eigen::Vector2d applied_powers(const MovingScene& scene,
                                             const MechanismLayout& layout,
                                             const TreeMotion<double>& motion,
                                             const StepEfforts& at);

}  // namespace thenar
