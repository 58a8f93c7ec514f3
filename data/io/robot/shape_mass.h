#pragma once

/// What shapes weigh.

#include <vector>

#include "base/shapes/shape_spec.h"

namespace thenar {

/// Mass of something rigid, about its own centre.
struct ShapeMass {
  double mass = 0;                                    // [kg]
  Eigen::Vector3d com{0, 0, 0};                       // [m] (3)
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about com [kg m^2] (3, 3)
};

/// Volume, centroid and inertia of a shape at density 1 kg/m^3, in the frame of its body. Of a
/// mesh, the signed sum over the tetrahedra from the origin to its triangles; nothing if that is
/// not positive.
/// @throws InputError for a tapered capsule or superellipsoid.
[[nodiscard]] ShapeMass mass_at_unit_density(const ShapeSpec& shape);

/// Several rigidly together.
[[nodiscard]] ShapeMass together(const std::vector<ShapeMass>& parts);

}  // namespace thenar
