#pragma once

/// Accuracy over processor time of the two steppers, on a scene whose answer is known, and such an
/// answer with a contact that turns: a ball that rolls off another.

#include <functional>
#include <vector>

#include "dynamics/stepping/moving_scene.h"
#include "dynamics/stepping/scene_run.h"

namespace thenar {

/// Error of a run and its cost.
struct WorkPoint {
  SteppingMethod method;
  double setting = 0;      // kEvents: tolerance [m], [rad]; kTimeStepping: length of a step [s]
  double error = 0;        // as the caller measures it
  double cpu_seconds = 0;  // the least of all repeats [s]
  long steps = 0;
  SceneStatus status = SceneStatus::kDone;  // read it first
};

/// Tolerances and steps to try.
struct WorkSettings {
  std::vector<double> tolerances;  // of kEvents [m], [rad]
  std::vector<double> steps;       // of kTimeStepping [s]
  int repeats = 5;                 // of each run: others on the machine only add time
};

/// Runs a scene by `events` at each tolerance, then by `time-stepping` at each step. Only its end
/// is kept, so that no sample cuts a step.
/// @param error  of the last instant against the exact answer, in one unit of the caller's
[[nodiscard]] std::vector<WorkPoint> work_precision(
    const MovingScene& scene, SceneOptions options, const WorkSettings& settings,
    const std::function<double(const SceneSample&)>& error);

/// Angle from the top of a full ball that rolls without slip on a fixed one and was at rest at
/// `start`, in free fall of `gravity` downwards:
///   angle'' = k sin(angle),   k = (5 / 7) gravity / distance,
/// a pendulum upside down. With c = cos(start / 2) and incomplete elliptic integrals F of modulus c
///   cos(angle / 2) = c sin(psi),   F(psi) = F(pi / 2) - sqrt(k) seconds.
/// @param start     above 0, below pi [rad];  @param seconds  after which, up to pi of angle [s]
/// @param distance  of the centres [m];  @param gravity  [m/s^2]
/// @return [rad], to rounding
/// @throws InputError if a number is out of its range, or the ball would be beyond the bottom.
[[nodiscard]] double rolled_angle(double start, double seconds, double distance,
                                  double gravity = 9.81);

}  // namespace thenar
