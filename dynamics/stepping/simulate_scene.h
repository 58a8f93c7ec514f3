#pragma once

/// Simulation of a scene from its initial state to an end time.

#include "base/progress.h"
#include "dynamics/stepping/moving_scene.h"
#include "dynamics/stepping/scene_run.h"

namespace thenar {

/// Simulates a scene by kEvents or kTimeStepping; dynamics/compliant/ has the other methods.
///
/// kEvents: columns of 1, 2, .. n substeps (ContactStep::take_euler_substep()) of a step of length
/// H are extrapolated to H / n = 0; the two highest orders may differ by a tenth of the tolerance.
/// n and H minimise the number of substeps per unit of time (Extrapolation). This applies while all
/// contacts keep their modes. If a mode changes within the step, the finest of four columns is
/// accepted if it differs from the previous one by at most the tolerance; otherwise the step is
/// shortened to end just before the change, or halved if the change is in its second half. If a gap
/// closes, the step ends at that instant, and an impact ends the approach. Without contacts
/// FreeStep takes the step. Source: [Deuflhard1983] for extrapolation of one-step methods.
///
/// A step with an unsolved contact problem is repeated up to three times with a shorter length. If
/// it stays unsolved, the following steps are not repeated, until one of them is solved.
///
/// If 200 steps advance the time by less than 0.1 ms (a rim that rattles on an edge), ten midpoint
/// steps advance it by 1 ms; SceneCost::chatter_bursts counts these bursts.
///
/// kTimeStepping: ContactStep::take_midpoint_step(), without restitution; steps also end at the
/// switching times of forces, drives and elements. Gaps and penetrations are those at the midpoint.
///
/// Both methods divide a step in which surfaces would move by more than half of the thinner body's
/// thickness (ContactStep::tunnelling_ratio()). The thickness of a mesh is twice its volume over
/// its area; bodies may pass through places that are thinner than that.
///
/// Results are bitwise reproducible for the same scene and options.
/// @param progress  receives the fraction of simulated time before each step, and may request a
///         stop
/// @throws InputError as ContactStep; if an option is out of range, or for another method.
[[nodiscard]] SceneRun simulate_scene(const MovingScene& scene, const SceneOptions& options = {},
                                      const Progress& progress = {});

}  // namespace thenar
