#pragma once

/// A tapered capsule in place of a surface of triangles.

#include "geometry/shape_spec.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

/// A tapered capsule near a surface, and how near.
struct CapsuleFit {
  ShapeSpec shape;     // of kTaperedCapsule, in the frame of the mesh
  double largest = 0;  // distance of a vertex from the capsule's surface [m]
  double rms = 0;      // of the distances of all vertices [m]
};

/// The tapered capsule from which the vertices of a mesh have the least sum of squared signed
/// distances: two ends and two radii by the method of Levenberg and Marquardt, from the direction
/// in which vertices vary most. It is exact where the mesh is inscribed in a tapered capsule; a
/// body that is half as broad again as deep is missed by an eighth of its depth or more.
/// @throws InputError with fewer than eight vertices, or all in one line or point.
[[nodiscard]] CapsuleFit fit_tapered_capsule(const TriangleMesh& mesh);

}  // namespace thenar
