#pragma once

/// Joint torques of weights and external forces, by virtual work on the chain.

#include <vector>

#include <Eigen/Core>

#include "hand/skeleton.h"

namespace thenar {

/// A force on a point of a link.
struct PointForce {
  int link;             // -1: the base, which feels nothing
  Eigen::Vector3d p;    // where it acts, at the reference posture [m] (3)
  Eigen::Vector3d f_W;  // force on the link, base frame           [N] (3)
};

/// All external loads of a hand.
struct Loads {
  Eigen::Vector3d gravity{0, 0, 0};  // acceleration of free fall, base frame [m/s^2] (3)
  std::vector<PointForce> forces;
};

/// Torque of the loads about every coordinate:
///   tau = sum over links  J_com' m g  +  sum over forces  J_p' f.
/// Joints that make -tau hold the hand still.
/// @param q  (coordinates) [rad]
/// @return   (coordinates) [N m]
/// @throws InputError if q has the wrong length or a force acts on a link that is not there.
[[nodiscard]] Eigen::VectorXd load_torque(const Skeleton& skeleton,
                                          const Eigen::Ref<const Eigen::VectorXd>& q,
                                          const Loads& loads);

}  // namespace thenar
