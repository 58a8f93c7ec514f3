#pragma once

/// A digit over time, as a simulation gives it: postures, tensions, tip, energy.

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/fidelity.h"
#include "solvers/stiff_ode.h"

namespace thenar {

/// Strain over which the bands of a net go from slack to taut in motion, a choice of ours [1]: see
/// docs/theory/muscles.md for what it changes.
inline constexpr double kBlend = 1e-3;

/// Numerical energy drift that is accepted: a share of the energy turned over [1], and a rest [J].
inline constexpr double kEnergyShare = 1e-4, kNoEnergy = 1e-9;

enum class MotionStatus {
  kCompleted,         // all the time that was asked for, and its energy balances
  kStopped,           // the caller asked to stop; holds all up to then
  kLimit,             // max_steps or max_effort are done; holds all up to then
  kIntegratorFailed,  // the integrator found no step; holds all up to then, `warning` says why
  kNoProgress,        // see SimulateOptions::stall_steps; holds all up to then
  kUnbalanced         // all the time, but energy is not conserved: not to be believed
};

/// Energy balance of an integration, over all its steps and not only the instants kept.
struct EnergyBalance {
  double error = 0;        // largest |energy - energy at the start - work + dissipated|, or, if
                           // more, of a net: |sum of NetStep::unexplained| [J]
  double turned_over = 0;  // largest kinetic energy, plus loss, plus all |work| of the steps [J]
  [[nodiscard]] bool holds() const { return error <= kEnergyShare * turned_over + kNoEnergy; }
};

/// A jump of a net to another equilibrium.
struct MotionSnap {
  double time;       // [s]
  std::string band;  // whose tension changed most
  double moved;      // furthest way of a knot [m]
  double released;   // energy that net and muscles lost [J]
};

/// A digit over time; one row an instant.
struct [[nodiscard]] Trajectory {
  MotionStatus status = MotionStatus::kIntegratorFailed;  // read this first
  std::string warning;                                    // why not to trust it; may be empty
  Fidelity fidelity;                                      // what was simulated
  std::vector<std::string> joints, muscles;
  Eigen::VectorXd time;         // [s] (instants)
  Eigen::MatrixXd angle;        // posture [rad] (instants, joints)
  Eigen::MatrixXd speed;        // [rad/s] (instants, joints)
  Eigen::MatrixXd excitation;   // [1] (instants, muscles)
  Eigen::MatrixXd activation;   // [1] (instants, muscles)
  Eigen::MatrixXd tension;      // [N] (instants, muscles)
  Eigen::MatrixXd excursion;    // lengthening since the reference posture [m] (instants, muscles)
  Eigen::MatrixXd fibre;        // length over optimal length [1] (instants, muscles); empty: bounds
  Eigen::MatrixX4d slips;       // central, radial, ulnar, terminal [N] (instants, 4)
  Eigen::MatrixX3d tip;         // world [m] (instants, 3)
  Eigen::VectorXd energy;       // of motion, weights, springs and stops [J] (instants)
  Eigen::VectorXd work;         // of the tendons on the joints [J] (instants)
  Eigen::VectorXd dissipated;   // in the dampers of the joints [J] (instants)
  EnergyBalance balance;        // of the whole integration
  std::optional<double> drift;  // largest of an excursion from the length of its line, over all
                                // steps; absent where nothing measures it:
                                // FingerMotion::Accepted [m]
  std::vector<MotionSnap> snaps;  // of a net, the first one first
  double tolerance = 0;           // that it was integrated to [1]
  OdeCounts counts;               // work of the integrator
  long effort = 0;                // evaluations of a net's energy
};

/// energy - energy at the start - work + dissipated:  the numerical energy drift up to each instant
/// [J] (instants).
[[nodiscard]] Eigen::VectorXd energy_drift(const Trajectory& trajectory);

/// Energy that all snaps of a net released [J].
[[nodiscard]] double released_energy(const Trajectory& trajectory);

/// Largest absolute energy drift [J].
[[nodiscard]] double energy_error(const Trajectory& trajectory);

}  // namespace thenar
