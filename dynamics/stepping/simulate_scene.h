#pragma once

/// Scenes from a start to an end.

#include "base/progress.h"
#include "dynamics/stepping/moving_scene.h"
#include "dynamics/stepping/scene_run.h"

namespace thenar {

/// Simulates a scene by kEvents or kTimeStepping; dynamics/compliant/ has the other methods.
///
/// kEvents: a step of length H is made of 1, 2, .. n substeps (ContactStep::substep), and
/// extrapolated to H / n = 0, order by order; a tenth of the tolerance is what the last two orders
/// may differ by. n and H are those that ask for the least substeps (Extrapolation). That holds
/// while all contacts keep their modes. Where a mode changes within the step, the finest of four
/// columns is taken if it differs from the one before by no more than the tolerance, else the step
/// is cut shortly before the change, or halved if that is less; where a gap closes, it is cut at
/// that instant, and an impact ends the approach. Where nothing touches, FreeStep goes on. Source:
/// [Deuflhard1983] for extrapolation of one-step methods.
///
/// A step in which something is not solved is made again, shorter, up to three times; the steps
/// that follow one which stayed unsolved are not, until one is solved.
///
/// Where 200 steps pass less than 0.1 ms (a rim that rattles on an edge), ten midpoint steps go on
/// by 1 ms, and SceneCost::passed counts them.
///
/// kTimeStepping: ContactStep::time_step(), without bounces; steps end also where something begins
/// or ends to act. Gaps and depths are those of the middle of a step.
///
/// Either way a step is divided where surfaces would move farther than half of the thinner body's
/// thickness (ContactStep::motion_between). A mesh is as thick as twice its volume over its area;
/// what is thinner in one place may be passed there.
///
/// The same scene and options give the same bits.
/// @param progress  told the time reached; a step is not interrupted
/// @throws InputError as ContactStep, or if an option is impossible, or for another method.
[[nodiscard]] SceneRun simulate_scene(const MovingScene& scene, const SceneOptions& options = {},
                                      const Progress& progress = {});

}  // namespace thenar
