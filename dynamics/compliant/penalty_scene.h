#pragma once

/// Simulation of scenes with compliant contacts by CVODE.

#include "base/progress.h"
#include "dynamics/stepping/moving_scene.h"
#include "dynamics/stepping/scene_run.h"

namespace thenar {

/// Simulates a scene with the contact laws of ContactCompliance:
///   M(q) v' = tau - h(q, v) + J(q)' f(q, v),
/// integrated with backward differentiation formulas under error control (StiffOde). Each
/// overlapping contact point of CollisionWorld is a spring, a Hertzian one between two balls or a
/// ball and a box. Joint limits are springs, and dry friction of joints is regularized like that of
/// contacts.
///
/// The error of speeds is kept below a hundredth of the transition speed, whatever the tolerance,
/// so that creep is resolved.
///
/// This is an accuracy reference for methods with rigid contacts: its result converges to theirs as
/// the stiffness grows and the transition speed decreases, but sticking contacts creep, at
/// the speed at which friction_ratio() gives their friction.
///
/// Limitation: where the points of a contact change under load (a rolling mesh), forces jump and
/// steps become short; the status is kFailed if CVODE gives up. A step in which surfaces move
/// farther than half of the thinner body's thickness is repeated with a shorter length.
///
/// Results are deterministic to the bit.
/// @param options  options of the run; `method` is ignored
/// @throws InputError as check_scene(), or if an option is invalid, a pair has a restitution, or
/// the scene has force elements (ligaments, tendons, compliant joints).
[[nodiscard]] SceneRun simulate_penalty_scene(const MovingScene& scene, const SceneOptions& options,
                                              const Progress& progress = {});

}  // namespace thenar
