#pragma once

/// Fit of a tapered capsule to a surface of triangles.

#include "geometry/shape_spec.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

/// A tapered capsule fitted to a surface, with its errors.
struct CapsuleFit {
  ShapeSpec shape;          // of kind kTaperedCapsule, in the frame of the mesh
  double max_distance = 0;  // maximum distance of a vertex from the capsule's surface [m]
  double rms_distance = 0;  // root mean square of the distances of all vertices [m]
};

/// Fits the tapered capsule with the least sum of squared signed distances of the vertices: two
/// ends and two radii by the Levenberg-Marquardt method, from the principal axis of the vertices.
/// The fit is exact for a mesh inscribed in a tapered capsule; for a body half as broad again as
/// deep the error is at least 1/8 of its depth.
/// @throws InputError if there are fewer than eight vertices, or all are in one line or point.
[[nodiscard]] CapsuleFit fit_tapered_capsule(const TriangleMesh& mesh);

}  // namespace thenar
