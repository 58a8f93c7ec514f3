#pragma once

/// Contact of one floating node with the bones on its list.

#include <array>
#include <vector>

#include "tendons/net/net_energy.h"

namespace thenar::internal {

// Surfaces posed with their bones.

/// Signed distance of a point from a surface, and its direction.
struct SurfaceGap {
  double gap = 0;          // negative inside [m]
  Eigen::Vector3d normal;  // out of the bone, world (3)
};

/// Computes the signed distance of a world point from a posed surface.
[[nodiscard]] SurfaceGap gap_world(const Net& net, const NetScene& scene, int surface,
                                   const Eigen::Vector3d& x);

/// Computes the signed distance of a world point with its curvature.
[[nodiscard]] SurfaceProbe probe_world(const Net& net, const NetScene& scene, int surface,
                                       const Eigen::Vector3d& x);

/// Contact state of a node: the surfaces that it touches, and their forces.
struct NodeContact {
  int touching = 0;            // number of surfaces touched, at most 3
  int pressed = 0;             // number of these, from the first, that exert a force
  int pinned = 0;              // number of rows of Q along which the node does not move
  double collapsed = 0;        // pull that holds it in an exit; 0: not in an exit [N]
  std::array<int, 3> surface;  // indices in Net::surfaces
  std::array<Eigen::Vector3d, 3> normal;
  /// Forces of the pressed surfaces; < 0 where bands clasp the node [N].
  std::array<double, 3> force;
  Eigen::Matrix3d Q;          // rows: a basis of the pressed normals, then of the tangents
  Eigen::Matrix3d curvature;  // sum of force * curvature [N/m]
  Eigen::Vector3d residual;   // residual: gradient of E that no contact balances [N]
};

/// Computes the contact forces that balance a node whose energy has gradient g, and the residual:
/// least squares over forces >= -slop.
/// @param slop  largest apparent tensile force of each touching surface [N]
void balance_node(const Net& net, const NetScene& scene, const Eigen::Vector3d& x,
                  const Eigen::Vector3d& g, const std::array<double, 3>& slop,
                  NodeContact& contact);

/// Moves x onto the pressed surfaces and out of all others on its list; sets `touching`.
/// @return whether such a position was found
[[nodiscard]] bool project_node(const Net& net, const NetScene& scene, const NetNode& node,
                                Eigen::Vector3d& x, NodeContact& contact);

}  // namespace thenar::internal
