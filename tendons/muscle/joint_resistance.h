#pragma once

/// Passive torques of joints in motion: passive_moment(), stops at their limits, dampers.

#include "hand/skeleton.h"

namespace thenar {

/// Resistance of a joint at its stops. A joint that exceeds its limit by d resists with
///   stiffness d^2 / (2 toe) up to toe,  stiffness (d - toe / 2) beyond,
/// which has no corner. The numbers are our choice: under 1 N m, about the torque of the strongest
/// flexor of a finger, a joint exceeds its limit by 4 degrees; the damping brings a straight finger
/// of 25 g and 9 cm to rest within 0.1 s.
struct JointResistance {
  double stiffness = 20;   // stiffness of a stop [N m/rad]
  double toe = 0.035;      // angle beyond the limit at which the stop becomes linear [rad]
  double damping = 0.002;  // damping of joints where the subject states none [N m s/rad]
};

/// Computes the torque of one joint's stops at an angle, 0 within its range [N m].
[[nodiscard]] double stop_torque(const JointResistance& resistance, const CoordinateLimits& limits,
                                 double angle);

/// Computes d stop_torque / d angle [N m/rad].
[[nodiscard]] double stop_derivative(const JointResistance& resistance,
                                     const CoordinateLimits& limits, double angle);

/// Computes the torque of passive moments and stops, without damping [N m] (coordinates).
[[nodiscard]] Eigen::VectorXd resistance_torque(const Skeleton& skeleton,
                                                const JointResistance& resistance,
                                                const Eigen::VectorXd& q);

/// Computes d resistance_torque / d q, a diagonal [N m/rad] (coordinates).
[[nodiscard]] Eigen::VectorXd resistance_derivative(const Skeleton& skeleton,
                                                    const JointResistance& resistance,
                                                    const Eigen::VectorXd& q);

/// Computes the energy stored in passive joints and stops; its derivative is minus the torque [J].
[[nodiscard]] double resistance_energy(const Skeleton& skeleton, const JointResistance& resistance,
                                       const Eigen::VectorXd& q);

/// Returns the damping of every coordinate [N m s/rad] (coordinates).
[[nodiscard]] Eigen::VectorXd joint_damping(const Skeleton& skeleton,
                                            const JointResistance& resistance);

}  // namespace thenar
