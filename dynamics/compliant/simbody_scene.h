#pragma once

/// Scenes whose contacts are springs, all by Simbody.

#include "base/progress.h"
#include "dynamics/stepping/contact_step.h"
#include "dynamics/stepping/scene_run.h"

namespace thenar {

/// Simulates a scene with Simbody's multibody, CompliantContactSubsystem and CPodes (backward
/// differentiation). Ours are the translation of the scene (SimbodyMechanism, simbody_pairs()), the
/// efforts of drives and dry friction (drive_effort(), friction_share()), the energies that samples
/// tell of motion, weight and springs of joints, and how far surfaces move in a step (ContactStep):
/// motions and forces of contacts are all Simbody's. Its laws are those of ContactCompliance with
/// the quintic ramp for balls, ellipsoids (elliptical patches) and boxes (each corner a spring);
/// meshes are elastic foundations of a layer. simbody_pairs() says which geometry stands for which
/// shape. Joint springs, dampers and limits are Simbody's own; its limits are springs. Source:
/// [Sherman2011].
///
/// kFailed: CPodes gave up; a contact has left the face of a box that a half space stands for; or
/// surfaces moved farther in a step than half of the thinner body's thickness, so that they may
/// have passed each other.
///
/// @param options  `method` is not looked at
/// @throws InputError as check_scene() and simbody_pairs(), or if an option is impossible, the ramp
/// is linear, the modulus zero, a pair has a restitution or a torsion radius, the scene has force
/// elements (ligaments, tendons, joints that give), or naming the body whose mass or surface
/// Simbody refuses, as it does a mesh that is not closed.
[[nodiscard]] SceneRun simulate_simbody_scene(const MovingScene& scene, const SceneOptions& options,
                                              const Progress& progress = {});

}  // namespace thenar
