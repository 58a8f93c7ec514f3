#pragma once

/// A digit moved by its muscles' excitations.

#include "base/progress.h"
#include "tendons/muscle/excitation.h"
#include "tendons/muscle/finger_motion.h"
#include "tendons/muscle/stiff_ode.h"

namespace thenar {

/// Where a motion starts.
struct MotionStart {
  Eigen::VectorXd q;           // posture [rad] (coordinates)
  Eigen::VectorXd q_dot;       // [rad/s] (coordinates); empty: at rest
  Eigen::VectorXd activation;  // [1] (muscles); empty: that of the first excitation
};

struct SimulateOptions {
  double seconds = 1;       // how long [s]
  double sample = 0.005;    // between the instants that are kept [s]
  double tolerance = 1e-6;  // error of one step, of each state's size [1]
  int max_steps = 1000000;
  Progress progress{};
};

enum class MotionStatus {
  kDone,     // all the time that was asked for
  kStopped,  // asked to stop: all up to then
  kStuck     // the integrator found no step: all up to then, and `trouble` says why
};

/// A digit over time; one row an instant.
struct [[nodiscard]] Trajectory {
  MotionStatus status = MotionStatus::kStuck;  // read this first
  std::string trouble;                         // why not to trust this; empty: nothing
  Fidelity fidelity;                           // what was simulated
  std::vector<std::string> joints, muscles;
  Eigen::VectorXd time;        // [s] (instants)
  Eigen::MatrixXd angle;       // posture [rad] (instants, joints)
  Eigen::MatrixXd speed;       // [rad/s] (instants, joints)
  Eigen::MatrixXd excitation;  // [1] (instants, muscles)
  Eigen::MatrixXd activation;  // [1] (instants, muscles)
  Eigen::MatrixXd tension;     // [N] (instants, muscles)
  Eigen::MatrixXd excursion;   // lengthening since the reference posture [m] (instants, muscles)
  Eigen::MatrixXd fibre;       // length over optimal length [1] (instants, muscles); empty: bounds
  Eigen::MatrixX4d slips;      // central, radial, ulnar, terminal [N] (instants, 4)
  Eigen::MatrixX3d tip;        // world [m] (instants, 3)
  Eigen::VectorXd energy;      // of motion, weights, springs and stops [J] (instants)
  Eigen::VectorXd work;        // of the tendons on the joints [J] (instants)
  Eigen::VectorXd lost;        // in the dampers of the joints [J] (instants)
  OdeCounts counts;            // what it took
};

/// @throws InputError if the model or the start does not fit, a joint moves nothing that has mass,
/// or an option is not positive.
Trajectory simulate(const MotionModel& model, const Excitation& excitation,
                    const MotionStart& start, const SimulateOptions& options = {});

/// Largest |energy - energy at the start - work + lost|: what the integration made of nothing [J].
[[nodiscard]] double energy_error(const Trajectory& trajectory);

}  // namespace thenar
