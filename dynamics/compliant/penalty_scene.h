#pragma once

/// Scenes whose contacts are springs, integrated by CVODE under error control.

#include "base/progress.h"
#include "dynamics/stepping/moving_scene.h"
#include "dynamics/stepping/scene_run.h"

namespace thenar {

/// Simulates a scene with the laws of ContactCompliance on our own machine and contacts:
///   M(q) v' = tau - h(q, v) + J(q)' f(q, v),
/// by backward differentiation (StiffOde). Every point of CollisionWorld that overlaps is a spring;
/// it is Hertz's where both parts there are balls, or a ball and a box. Joint limits are springs,
/// and dry friction of joints has the ramp of contacts.
///
/// Speeds are kept to a hundredth of the transition speed even where the tolerance is larger, as
/// what creeps would else be noise.
///
/// An accuracy reference for methods whose contacts are rigid: it tends to their answer as
/// stiffness grows and the transition speed falls, but what sticks there creeps here, at
/// creep_speed().
///
/// Fails: where the points of a contact change while they press (a rolling mesh), forces jump and
/// steps become short; kFailed says so where CVODE gives up. A step during which surfaces would
/// move farther than half of the thinner body's thickness is made again, shorter.
///
/// The same scene and options give the same bits.
/// @param options  `method` is not looked at
/// @throws InputError as check_scene(), or if an option is impossible, a pair has a restitution, or
/// the scene has force elements (ligaments, tendons, joints that give).
[[nodiscard]] SceneRun simulate_penalty_scene(const MovingScene& scene, const SceneOptions& options,
                                              const Progress& progress = {});

}  // namespace thenar
