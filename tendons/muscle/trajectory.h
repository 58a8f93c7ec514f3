#pragma once

/// Motion of a digit over time, the result of a simulation: postures, tensions, tip, energy.

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/fidelity.h"
#include "solvers/stiff_ode.h"

namespace thenar {

/// Strain over which the bands of a net change from slack to taut in motion [1]. Our choice: see
/// docs/theory/muscles.md for its effect.
inline constexpr double kBlendStrain = 1e-3;

/// Accepted numerical energy drift: a share of the energy turned over [1], plus an absolute floor
/// [J].
inline constexpr double kEnergyDriftRatio = 1e-4, kEnergyFloor = 1e-9;

/// Outcome of a simulated motion.
enum class MotionStatus {
  kCompleted,         // simulated to the end, and energy balances
  kStopped,           // stopped by the caller; holds all instants so far
  kLimit,             // max_steps or max_effort reached; holds all instants so far
  kIntegratorFailed,  // the integrator found no step; holds all instants so far, `warning` says why
  kNoProgress,        // stalled, see SimulateOptions::stall_steps; holds all instants so far
  kUnbalanced         // simulated to the end, but energy is not conserved: not reliable
};

/// Energy balance of an integration, over all its steps and not only the stored instants.
struct EnergyBalance {
  double error = 0;  // largest |energy - initial energy - work + dissipated|, or, if larger, |sum
                     // of NetStep::unexplained| of a net [J]
  /// Largest kinetic energy plus losses plus the sum of |work| over all steps [J].
  double turned_over = 0;
  [[nodiscard]] bool holds() const {
    return error <= kEnergyDriftRatio * turned_over + kEnergyFloor;
  }
};

/// Snap: a jump of a net to another equilibrium.
struct MotionSnap {
  double time = 0;      // [s]
  std::string band;     // name of the band whose tension changed most
  double moved = 0;     // largest displacement of a node [m]
  double released = 0;  // energy lost by net and muscles [J]
};

/// Motion of a digit over time; one row per instant.
struct [[nodiscard]] Trajectory {
  MotionStatus status = MotionStatus::kIntegratorFailed;  // read this first
  std::string warning;  // reason why it is unreliable; may be empty
  Fidelity fidelity;    // level of detail that was simulated
  std::vector<std::string> joints, muscles;
  Eigen::VectorXd time;        // [s] (instants)
  Eigen::MatrixXd angle;       // posture [rad] (instants, joints)
  Eigen::MatrixXd speed;       // joint velocities [rad/s] (instants, joints)
  Eigen::MatrixXd excitation;  // [1] (instants, muscles)
  Eigen::MatrixXd activation;  // [1] (instants, muscles)
  Eigen::MatrixXd tension;     // [N] (instants, muscles)
  Eigen::MatrixXd excursion;   // lengthening since the reference posture [m] (instants, muscles)
  Eigen::MatrixXd fibre;  // fibre length over optimal length [1] (instants, muscles); empty for the
                          // model `bounds`
  Eigen::MatrixX4d slips;      // hood tensions: central, radial, ulnar, terminal [N] (instants, 4)
  Eigen::MatrixX3d tip;        // tip position, world [m] (instants, 3)
  Eigen::VectorXd energy;      // energy of motion, weights, springs and stops [J] (instants)
  Eigen::VectorXd work;        // work of the tendons on the joints [J] (instants)
  Eigen::VectorXd dissipated;  // energy lost in the dampers of the joints [J] (instants)
  EnergyBalance balance;       // energy balance of the whole integration
  /// Largest difference between an excursion and its line length, over all steps [m]; absent where
  /// it is not measured: FingerMotion::Accepted.
  std::optional<double> drift;
  std::vector<MotionSnap> snaps;  // snaps of a net, in order of occurrence
  double tolerance = 0;           // tolerance of the integration [1]
  OdeCounts counts;               // work of the integrator
  long effort = 0;                // number of evaluations of a net's energy
};

/// Computes the numerical energy drift up to each instant,  energy - initial energy - work +
/// dissipated  [J] (instants).
[[nodiscard]] Eigen::VectorXd energy_drift(const Trajectory& trajectory);

/// Returns the energy released by all snaps of a net [J].
[[nodiscard]] double released_energy(const Trajectory& trajectory);

/// Computes the largest absolute energy drift [J].
[[nodiscard]] double energy_error(const Trajectory& trajectory);

}  // namespace thenar
