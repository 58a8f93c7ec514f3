#pragma once

/// Simulation of a digit driven by muscle excitations.

#include "base/progress.h"
#include "tendons/muscle/excitation.h"
#include "tendons/muscle/finger_motion.h"
#include "tendons/muscle/trajectory.h"

namespace thenar {

/// Initial state of a motion.
struct MotionStart {
  Eigen::VectorXd q;           // posture [rad] (coordinates)
  Eigen::VectorXd q_dot;       // joint velocities [rad/s] (coordinates); empty: at rest
  Eigen::VectorXd activation;  // initial activation [1] (muscles); empty: the first excitation
};

/// Options of simulate().
struct SimulateOptions {
  double seconds = 1;       // duration [s]
  double sample = 0.005;    // interval between stored instants [s]
  double tolerance = 1e-6;  // error of one step, relative to each state's scale [1]
  int max_steps = 1000000;  // steps of one integration
  long max_effort = 0;      // evaluations of a net's energy, both integrations together; 0:
                            // allowed_effort() by duration
  /// Number of steps that must advance the motion by kStallTime; if they do not, the tolerance is
  /// relaxed for a while, and if that fails the motion ends.
  int stall_steps = 500;
  Progress progress{};
};

/// Time by which `stall_steps` steps must advance a motion [s]: a hundredth of the fastest time
/// constant of a finger.
inline constexpr double kStallTime = 2e-5;

/// Evaluations of a net's energy that any motion may take [1], and further ones per second of
/// motion [1/s]: together 10 s of processor time for half a second of motion.
inline constexpr long kMinEffort = 400'000;
inline constexpr double kEffortPerSecond = 800'000;

/// Integrates a motion to the tolerance. If energy then does not balance, or excursions have
/// drifted by more than 0.1 mm from their lines though no net snapped, it integrates once more, to
/// a hundredth of the tolerance. A motion that is stopped, stalls or exhausts its limits of work
/// keeps all instants so far, and `warning` states the reason.
/// @throws InputError if the model or the start does not fit, a joint moves nothing that has mass,
/// or an option is not positive.
Trajectory simulate(const MotionModel& model, const Excitation& excitation,
                    const MotionStart& start, const SimulateOptions& options = {});

/// Returns the number of evaluations of a net's energy that a motion may take.
[[nodiscard]] long allowed_effort(const SimulateOptions& options);

}  // namespace thenar
