#pragma once

/// A body's geometry in the forms that contacts, inertia and pictures need.

#include <memory>
#include <vector>

#include "geometry/shape.h"
#include "geometry/shape_spec.h"

namespace thenar {

/// A surface swept by a ball: everything within `radius` of the core. A capsule is a segment (a
/// degenerate triangle) with a radius, a mesh has radius 0. A list of them stands for their union.
struct RoundedMesh {
  TriangleMesh core;
  double radius = 0;  // [m]
};

/// One of the shapes whose union a solid is.
struct SolidPart {
  ShapeSpec spec;                      // its mesh is empty: the triangles are in Solid::collision
  std::shared_ptr<const Shape> shape;  // its distance, in its own frame
};

/// A body; constant once built, all in one frame.
struct Solid {
  std::shared_ptr<const Shape> shape;  // asked for distances; shared: hands are copied, grids large
  std::vector<RoundedMesh> collision;  // what searches another shape's distance for contacts
  TriangleMesh visual;                 // for drawing and inertia; rounded shapes tessellated
  std::vector<SolidPart> parts = {};   // what each entry of `collision` is; empty: unknown
};

/// The union of some shapes in the frame of their body. A mesh of several closed surfaces is the
/// union of what solid_parts() finds in it, so that where they overlap is inside; repair_to_solid()
/// mends what that refuses.
/// @throws InputError if there is none, a size is not positive and finite, or a mesh has holes
/// (naming them) or no volume.
[[nodiscard]] Solid build_solid(const std::vector<ShapeSpec>& shapes);

}  // namespace thenar
