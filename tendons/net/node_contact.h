#pragma once

/// Contact of one floating node with the bones it may rest on.

#include <array>
#include <vector>

#include "tendons/net/net_energy.h"

namespace thenar::internal {

// Surfaces posed with their bones.

/// Signed distance of a point from a surface, and its direction.
struct SurfaceGap {
  double gap;              // negative inside [m]
  Eigen::Vector3d normal;  // out of the bone, world (3)
};

[[nodiscard]] SurfaceGap gap_world(const Net& net, const NetScene& scene, int surface,
                                   const Eigen::Vector3d& x);

/// Signed distance with its curvature.
[[nodiscard]] SurfaceProbe probe_world(const Net& net, const NetScene& scene, int surface,
                                       const Eigen::Vector3d& x);

/// Surfaces that a node lies on, and the forces that press it on them.
struct NodeContact {
  int touching = 0;            // surfaces it lies on, at most 3
  int pressed = 0;             // the first of them bear on it
  int pinned = 0;              // rows of Q along which it does not move
  double collapsed = 0;        // pull that holds it in an exit; 0: it is not there [N]
  std::array<int, 3> surface;  // their numbers in the net
  std::array<Eigen::Vector3d, 3> normal;
  std::array<double, 3> force;  // of the pressed ones; < 0 where bands clasp it [N]
  Eigen::Matrix3d Q;            // rows: a basis of the pressed normals, then of the tangents
  Eigen::Matrix3d bend;         // sum force * curvature [N/m]
  Eigen::Vector3d left;         // slope of E that no bone balances [N]
};

/// Contact forces of the touching surfaces that balance a node whose energy has gradient g, and the
/// rest of g: least squares over forces >= -slop.
/// @param slop  how hard each touching surface may seem to pull the node [N]
void balance_node(const Net& net, const NetScene& scene, const Eigen::Vector3d& x,
                  const Eigen::Vector3d& g, const std::array<double, 3>& slop,
                  NodeContact& contact);

/// Moves x onto the surfaces that are pressed and out of all others that it may rest on; sets
/// `touching`. @return whether such a place was found
[[nodiscard]] bool project_node(const Net& net, const NetScene& scene, const NetNode& node,
                                Eigen::Vector3d& x, NodeContact& contact);

}  // namespace thenar::internal
