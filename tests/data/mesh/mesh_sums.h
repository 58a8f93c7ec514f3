#pragma once

/// What a closed surface encloses, in tests.

#include <Eigen/Geometry>

#include "geometry/triangle_mesh.h"

namespace thenar {

/// Volume by the divergence theorem; negative if the surface is inside out [m^3].
inline double enclosed_volume(const TriangleMesh& mesh) {
  double six_volumes = 0;
  for (const auto& t : mesh.triangles.colwise())
    six_volumes += mesh.vertices.col(t(0)).dot(
        mesh.vertices.col(t(1)).cross(Eigen::Vector3d(mesh.vertices.col(t(2)))));
  return six_volumes / 6;
}

}  // namespace thenar
