#pragma once

/// Work-precision diagrams of the two steppers on scenes with an exact solution, and the exact
/// solution of a ball that rolls off another.

#include <functional>
#include <vector>

#include "dynamics/stepping/moving_scene.h"
#include "dynamics/stepping/scene_run.h"

namespace thenar {

/// Error and cost of a run.
struct WorkPoint {
  SteppingMethod method;
  double setting = 0;      // tolerance of kEvents [m], [rad]; step length of kTimeStepping [s]
  double error = 0;        // result of the caller's error function
  double cpu_seconds = 0;  // shortest processor time of all repeats [s]
  long steps = 0;          // number of steps
  SceneStatus status = SceneStatus::kDone;  // error and cost are only meaningful for kDone
};

/// Settings of a work-precision diagram.
struct WorkSettings {
  std::vector<double> tolerances;  // tolerances of kEvents [m], [rad]
  std::vector<double> steps;       // step lengths of kTimeStepping [s]
  int repeats = 5;  // repeats of each run; the shortest is least disturbed by other processes
};

/// Runs a scene with `events` at each tolerance, then with `time-stepping` at each step length.
/// Only the final state is sampled, so that no sample shortens a step.
/// @param error  function that returns the error of the final state, in any unit
/// @throws InputError if there are no repeats.
[[nodiscard]] std::vector<WorkPoint> work_precision(
    const MovingScene& scene, SceneOptions options, const WorkSettings& settings,
    const std::function<double(const SceneSample&)>& error);

/// Returns the angle from the top of a solid ball that rolls without slip on a fixed ball, after
/// it was at rest at the angle `start`, exact to rounding [rad]:
///   angle'' = k sin(angle),   k = (5 / 7) gravity / distance,
/// an inverted pendulum. With c = cos(start / 2) and the incomplete elliptic integral F of modulus
/// c
///   cos(angle / 2) = c sin(psi),   F(psi) = F(pi / 2) - sqrt(k) seconds.
/// @param start     initial angle, above 0 and below pi [rad]
/// @param seconds   elapsed time, while the angle is at most pi [s]
/// @param distance  distance of the centres [m]
/// @param gravity   gravitational acceleration [m/s^2]
/// @throws InputError if an argument is out of its range, or the ball would be past the bottom.
[[nodiscard]] double rolled_angle(double start, double seconds, double distance,
                                  double gravity = 9.81);

}  // namespace thenar
