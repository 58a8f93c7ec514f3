#pragma once

/// Simulation of a digit moved by its muscles' excitations.

#include "base/progress.h"
#include "tendons/muscle/excitation.h"
#include "tendons/muscle/finger_motion.h"
#include "tendons/muscle/trajectory.h"

namespace thenar {

/// Initial state of a motion.
struct MotionStart {
  Eigen::VectorXd q;           // posture [rad] (coordinates)
  Eigen::VectorXd q_dot;       // [rad/s] (coordinates); empty: at rest
  Eigen::VectorXd activation;  // [1] (muscles); empty: that of the first excitation
};

struct SimulateOptions {
  double seconds = 1;       // how long [s]
  double sample = 0.005;    // between the instants that are kept [s]
  double tolerance = 1e-6;  // error of one step, of each state's size [1]
  int max_steps = 1000000;  // of one integration
  long max_effort = 0;    // evaluations of a net's energy, of both integrations together; 0: of its
                          // length, see allowed_effort()
  int stall_steps = 500;  // steps that must advance it by kStallTime; where they do not, errors of
                          // steps may be larger for a while, and if that does not help it gives up
  Progress progress{};
};

/// Time by which `stall_steps` steps must advance a motion [s]: a hundredth of the fastest time
/// constant of a finger.
inline constexpr double kStallTime = 2e-5;

/// Evaluations of a net's energy that a motion may take without being asked, and more for each
/// second of it [1], [1/s]: 10 s of processor time for half a second.
inline constexpr long kLeastEffort = 400'000;
inline constexpr double kEffortPerSecond = 800'000;

/// Integrates to the tolerance. If energy then does not balance, or excursions have drifted by more
/// than 0.1 mm from their lines though no net snapped, it integrates once more, to a hundredth of
/// the tolerance. A motion that is stopped, stalls or has done all the work that it may keeps all
/// instants up to then, and `warning` says why.
/// @throws InputError if the model or the start does not fit, a joint moves nothing that has mass,
/// or an option is not positive.
Trajectory simulate(const MotionModel& model, const Excitation& excitation,
                    const MotionStart& start, const SimulateOptions& options = {});

/// Evaluations of a net's energy that a motion may take.
[[nodiscard]] long allowed_effort(const SimulateOptions& options);

}  // namespace thenar
