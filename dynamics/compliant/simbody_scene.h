#pragma once

/// Simulation of scenes with compliant contacts by Simbody.

#include "base/progress.h"
#include "dynamics/stepping/contact_step.h"
#include "dynamics/stepping/scene_run.h"

namespace thenar {

/// Simulates a scene with Simbody: its multibody dynamics, CompliantContactSubsystem and the CPodes
/// integrator (backward differentiation). Thenar only translates the scene (SimbodyMechanism,
/// plan_simbody_pairs()), computes the efforts of drives and dry friction (drive_effort(),
/// friction_ratio()) and the energies of motion, weight and joint springs in samples, and checks
/// the motion of surfaces in a step (ContactStep). The contact laws are those of ContactCompliance
/// with the quintic ramp for balls, ellipsoids (elliptical patches) and boxes (each corner a
/// spring); meshes are elastic foundations. Joint springs, dampers and limits are Simbody's, with
/// springs for limits. Source: [Sherman2011].
///
/// The status is kFailed if CPodes gives up, a contact leaves the box face that a half space
/// represents, or surfaces move farther in a step than half of the thinner body's thickness, so
/// that bodies may have passed through each other.
///
/// @param options  options of the run; `method` is ignored
/// @throws InputError as check_scene() and plan_simbody_pairs(), or if an option is invalid, the
/// ramp is linear, the modulus is zero, a pair has a restitution or a torsion radius, the scene has
/// force elements (ligaments, tendons, compliant joints), or Simbody refuses the mass or surface of
/// a body, such as an open mesh.
[[nodiscard]] SceneRun simulate_simbody_scene(const MovingScene& scene, const SceneOptions& options,
                                              const Progress& progress = {});

}  // namespace thenar
