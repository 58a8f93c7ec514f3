#pragma once

/// Scenes whose contacts are springs, all by Simbody.

#include "base/progress.h"
#include "dynamics/stepping/simulate_scene.h"

namespace thenar {

/// Simulates a scene with Simbody's multibody, CompliantContactSubsystem and CPodes (backward
/// differentiation): a program that shares with ours the laws and nothing else. Its laws are those
/// of ContactCompliance with the quintic ramp for balls, ellipsoids (elliptical patches) and boxes
/// (each corner a spring); meshes are elastic foundations of a layer. simbody_pairs() says which
/// geometry stands for which shape. Joint springs, dampers and limits are Simbody's own; its limits
/// are springs. Source: [Sherman2011].
///
/// kFailed: CPodes gave up; a contact has left the face of a box that a half space stands for; or
/// surfaces moved farther in a step than half of the thinner body's thickness, so that they may
/// have passed each other.
///
/// @param options  `method` is not looked at
/// @throws InputError as check_scene() and simbody_pairs(), or if an option is impossible, the ramp
/// is linear, the modulus zero, or a pair has a restitution or a torsion radius.
[[nodiscard]] SceneRun simulate_simbody_scene(const MovingScene& scene, const SceneOptions& options,
                                              const Progress& progress = {});

}  // namespace thenar
