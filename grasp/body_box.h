#pragma once

/// The box around a body: which way it is long.

#include <Eigen/Core>

#include "geometry/triangle_mesh.h"

namespace thenar {

/// In the frame of its mesh.
struct BodyBox {
  Eigen::Matrix3d axes{Eigen::Matrix3d::Identity()};  // columns, right-handed, longest first (3, 3)
  Eigen::Vector3d half{0, 0, 0};                      // of its sides along them, descending [m] (3)
};

/// The smaller of two boxes around a body's picture: one along its frame, one along its principal
/// axes of inertia at uniform density. Bodies whose principal axes are no axes at all, balls and
/// cubes, keep their frame: the other must be smaller by 1 % of the volume.
[[nodiscard]] BodyBox body_box(const TriangleMesh& picture);

}  // namespace thenar
