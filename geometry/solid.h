#pragma once

/// Geometry of a body in the forms that contacts, inertia and drawings need.

#include <memory>
#include <vector>

#include "geometry/shape.h"
#include "geometry/shape_spec.h"

namespace thenar {

/// A surface swept by a ball: all points within `radius` of the core. A capsule is a segment (a
/// degenerate triangle) with a radius, a mesh has radius 0. A list of them represents their union.
struct RoundedMesh {
  TriangleMesh core;
  double radius = 0;  // [m]
};

/// One of the shapes whose union a solid is.
struct SolidPart {
  ShapeSpec spec;  // shape without its mesh, whose triangles are in Solid::collision
  std::shared_ptr<const Shape> shape;  // distance in the frame of the shape
};

/// A body, constant after construction, with all members in one frame.
struct Solid {
  /// Signed distance; shared, as hands are copied and grids are large.
  std::shared_ptr<const Shape> shape;
  std::vector<RoundedMesh>
      collision;        // surfaces whose distance from another shape is searched for contacts
  TriangleMesh visual;  // surface for drawing and inertia; rounded shapes are tessellated
  std::vector<SolidPart> parts = {};  // shape of each entry of `collision`; empty: unknown
};

/// Builds the union of shapes in the frame of their body. A mesh of several closed surfaces is the
/// union of its solid_parts(), so that overlaps are inside; repair_to_solid() repairs meshes that
/// solid_parts() rejects.
/// @throws InputError if there is no shape, a size is not positive and finite, or a mesh has no
/// volume or holes (named in the message).
[[nodiscard]] Solid build_solid(const std::vector<ShapeSpec>& shapes);

}  // namespace thenar
