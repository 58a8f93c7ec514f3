#pragma once

/// The box around a body: which way it is long.

#include "grasp/scene.h"

namespace thenar {

/// In the body's frame.
struct BodyBox {
  Eigen::Matrix3d axes;  // unit columns, right-handed, the longest side first (3, 3)
  Eigen::Vector3d half;  // of its sides along them, descending [m] (3)
};

/// The smaller of two boxes around the body's picture: one along its frame, one along its principal
/// axes of inertia at uniform density. Bodies whose principal axes are no axes at all, balls and
/// cubes, keep their frame: the other must be smaller by 1 % of the volume.
[[nodiscard]] BodyBox body_box(const SceneBody& body);

}  // namespace thenar
