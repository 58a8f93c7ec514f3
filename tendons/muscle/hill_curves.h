#pragma once

/// Dimensionless curves of a Hill-type muscle: force over F0, by normalised length and speed.
///
/// Closed forms of [DeGroote2016], eqs. S1-S4 of its supplement. Where its rounded constants miss a
/// value that defines a muscle, one constant each is solved for instead: active force 1 at the
/// optimal length (b11, 0.8157 instead of 0.815), force 1 at rest and 0 at the largest speed (d1
/// and d4, -0.3211 and 0.8825 instead of -0.318 and 0.886).

#include <Eigen/Core>

namespace thenar {

/// Strain of a tendon that carries F0, log(1.25 / 0.2) / 35 - 0.005 by the published curve [1].
inline constexpr double kTendonStrain = 0.047359470392808856;

/// Computes the active force [1], the sum of three bells  sum b1 exp(-(l - b2)^2 / (2 (b3 + b4
/// l)^2)).
/// @param length  fibre length / optimal length, >= 0 [1]
[[nodiscard]] double active_force(double length);

/// Computes d active_force / d length [1].
[[nodiscard]] double active_force_derivative(double length);

/// Computes the force-velocity factor [1],  d1 asinh(d2 v + d3) + d4:  0 at v = -1, the largest
/// speed of shortening, and 1 at v = 0. Unbounded in lengthening, as a logarithm; negative beyond v
/// = -1.
/// @param velocity  speed of lengthening / largest speed of shortening [1]
[[nodiscard]] double force_velocity(double velocity);

/// Computes d force_velocity / d velocity, positive [1].
[[nodiscard]] double force_velocity_derivative(double velocity);

/// Computes the passive force of the fibre [1],  (exp(4 (l - 1) / 0.6) - 1) / (exp(4) - 1),  0
/// where l < 1: there the published curve pushes, which fibres cannot.
/// @param length  l, fibre length / optimal length [1]
[[nodiscard]] double passive_force(double length);

/// Computes d passive_force / d length [1].
[[nodiscard]] double passive_force_derivative(double length);

/// Computes the force of the tendon [1],  0.2 exp(35 (l - 0.995)) - 0.25,  0 where that is
/// negative, that is up to a strain of 0.0014. Another strain at F0 stretches the curve along the
/// strain.
/// @param length  tendon length / slack length [1]
/// @param strain  strain at F0, > 0 [1]
[[nodiscard]] double tendon_force(double length, double strain = kTendonStrain);

/// Computes d tendon_force / d length [1].
[[nodiscard]] double tendon_force_derivative(double length, double strain = kTendonStrain);

/// Computes the integral of tendon_force over the length from 0 on [1].
[[nodiscard]] double tendon_energy(double length, double strain = kTendonStrain);

/// Computes the length up to which tendon_force is 0, over the slack length [1].
[[nodiscard]] double taut_tendon(double strain = kTendonStrain);

// Curves of many fibres together, by exponentials of whole arrays: equal to the functions above
// to rounding, about 1e-15 of F0, and faster. Memory is reused.

/// Force-length factors of many fibres.
struct LengthForces {
  Eigen::VectorXd active, active_slope;    // active_force() and its derivative [1] (fibres)
  Eigen::VectorXd passive, passive_slope;  // passive_force() and its derivative [1] (fibres)
  Eigen::VectorXd workspace;               // workspace of set_length_forces()
};

/// Computes all force-length factors. @param length  as in active_force() (fibres)
void set_length_forces(const Eigen::VectorXd& length, LengthForces& out);

/// Force-velocity factors of many fibres.
struct SpeedForces {
  Eigen::VectorXd force;  // force_velocity() [1] (fibres)
  Eigen::VectorXd slope;  // its derivative [1] (fibres)
};

/// Computes all force-velocity factors. @param velocity  as in force_velocity() (fibres)
void set_speed_forces(const Eigen::VectorXd& velocity, SpeedForces& out);

}  // namespace thenar
