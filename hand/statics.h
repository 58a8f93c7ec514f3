#pragma once

/// Joint torques of weights, external forces and wrenches on links, by virtual work.

#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "hand/skeleton.h"

namespace thenar {

/// Force on a point of a link.
struct PointForce {
  int link;           // -1: the base; a force on it makes no joint torque
  Eigen::Vector3d p;  // point of application at the reference posture; moves with the link [m] (3)
  Eigen::Vector3d f_W;  // force of the world on the link, so minus a tip force; base frame, does
                        // not turn with the link [N] (3)
};

/// External loads of a hand.
struct Loads {
  Eigen::Vector3d gravity{0, 0, 0};  // acceleration of free fall, base frame: {0, 0, -9.81} if z
                                     // is up; 0: no weights [m/s^2] (3)
  std::vector<PointForce> forces;
};

/// Computes the torque of the loads about every coordinate:
///   tau = sum over links  J_com' m g  +  sum over forces  J_p' f.
/// J_com, J_p: position Jacobians of centre of mass and point. Joints that exert -tau hold the
/// hand.
/// @param q  (coordinates) [rad]
/// @return   (coordinates) [N m]
/// @throws InputError if q has the wrong length or a force acts on a link that does not exist.
[[nodiscard]] Eigen::VectorXd load_torque(const Skeleton& skeleton,
                                          const Eigen::Ref<const Eigen::VectorXd>& q,
                                          const Loads& loads);

/// Wrench on one link, world axes, moment about the world origin.
struct LinkWrench {
  int link = -1;  // -1: the base
  Wrench wrench;  // [N m], [N]; of a tendon per unit tension [m], [1]
};

/// Computes the joint torques of wrenches on links: about each hinge, the sum over all links that
/// it moves. Coupled joints share a coordinate by their ratios.
/// @return (coordinates) [N m]; moment arms [m] where the wrenches are per unit tension
[[nodiscard]] Eigen::VectorXd joint_torque(const Tree<double>& tree, const TreeState<double>& state,
                                           const std::vector<LinkWrench>& wrenches,
                                           int coordinates);

}  // namespace thenar
