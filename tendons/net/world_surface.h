#pragma once

/// Surfaces where the bones have carried them.

#include "tendons/net/net_energy.h"

namespace thenar::internal {

/// How far a point is from a surface, and which way.
struct SurfaceGap {
  double gap;              // negative inside [m]
  Eigen::Vector3d normal;  // out of the bone, world (3)
};

[[nodiscard]] SurfaceGap gap_world(const Net& net, const NetScene& scene, int surface,
                                   const Eigen::Vector3d& x);

/// The same with the curvature of the gap.
[[nodiscard]] SurfaceProbe probe_world(const Net& net, const NetScene& scene, int surface,
                                       const Eigen::Vector3d& x);

}  // namespace thenar::internal
