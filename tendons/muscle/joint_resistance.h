#pragma once

/// Passive torques of joints in motion: passive_moment(), stops at their limits, dampers.

#include "hand/skeleton.h"

namespace thenar {

/// A joint pushed beyond its limit by d resists with
///   stiffness d^2 / (2 toe) up to toe,  stiffness (d - toe / 2) beyond,
/// which has no corner. The numbers are choices of ours: 1 N m, of the size of what the strongest
/// flexor of a finger makes, goes 4 degrees beyond; the damping brings a straight finger of 25 g
/// and 9 cm to rest within 0.1 s.
struct JointResistance {
  double stiffness = 20;   // of a stop [N m/rad]
  double toe = 0.035;      // [rad]
  double damping = 0.002;  // of joints whose subject gives none [N m s/rad]
};

/// Torque of one joint's stops at an angle, 0 within its range [N m].
[[nodiscard]] double stop_torque(const JointResistance& resistance, const CoordinateLimits& limits,
                                 double angle);

/// d stop_torque / d angle [N m/rad].
[[nodiscard]] double stop_derivative(const JointResistance& resistance,
                                     const CoordinateLimits& limits, double angle);

/// Torque of passive moments and stops [N m] (coordinates); the damping is apart.
[[nodiscard]] Eigen::VectorXd resistance_torque(const Skeleton& skeleton,
                                                const JointResistance& resistance,
                                                const Eigen::VectorXd& q);

/// d resistance_torque / d q, diagonal [N m/rad] (coordinates).
[[nodiscard]] Eigen::VectorXd resistance_derivative(const Skeleton& skeleton,
                                                    const JointResistance& resistance,
                                                    const Eigen::VectorXd& q);

/// Energy stored in passive joints and stops; its derivative is minus the torque [J].
[[nodiscard]] double resistance_energy(const Skeleton& skeleton, const JointResistance& resistance,
                                       const Eigen::VectorXd& q);

/// Damping of every coordinate [N m s/rad] (coordinates).
[[nodiscard]] Eigen::VectorXd joint_damping(const Skeleton& skeleton,
                                            const JointResistance& resistance);

}  // namespace thenar
