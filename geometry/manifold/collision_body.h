#pragma once

/// A solid as contacts in motion see it: primitives by their sizes, all else by its triangles.

#include <array>
#include <memory>
#include <vector>

#include <Eigen/Geometry>

#include "base/spatial.h"
#include "geometry/collision/collision_tree.h"
#include "geometry/manifold/polyhedron.h"
#include "geometry/shape.h"
#include "geometry/solid.h"

namespace thenar {

/// Form of a part, which selects the contact algorithm.
enum class PartForm {
  kRound,       // the hull of two balls: spheres, capsules, tapered capsules
  kBox,         //
  kCylinder,    //
  kSmooth,      // ellipsoids and superellipsoids
  kPolyhedron,  // meshes
};

/// One convex primitive, or all meshes of a body.
struct CollisionPart {
  PartForm form = PartForm::kRound;
  Pose<double> X_BP{};  // the part's frame in the body's
  Ball ball{};          // holds the part, in its frame

  // Sizes, in the part's frame, about its origin.
  double half_length = 0;          // of kRound: balls stand at z = -half_length, +half_length [m]
  std::array<double, 2> radius{};  // of kRound: of the lower and the upper ball [m]
  Eigen::Vector3d half{0, 0, 0};   // of kBox, kCylinder (r, r, height / 2), kSmooth [m] (3)
  bool is_ellipsoid = false;       // of kSmooth; false: a superellipsoid

  std::shared_ptr<const Shape> shape;            // distance, in the part's frame
  std::shared_ptr<const Polyhedron> polyhedron;  // all but kRound: its surface, perhaps tessellated
};

/// A body as contacts see it, in the frame of its solid; constant once built.
struct CollisionBody {
  std::vector<CollisionPart> parts;
  Eigen::AlignedBox3d box;  // holds all parts [m]
  Ball ball;                // the same
  double thickness = 0;     // what moves less goes through no part: the least extent of primitives,
                            // and twice volume over area of every surface of triangles [m]
};

/// Builds it from a solid with `parts`, as build_solid() makes it. A solid without them is taken
/// for polyhedra, or for balls and capsules where its collision surfaces are points or segments.
/// @throws InputError if the solid has no shape or no collision surface, or a rounded triangle.
[[nodiscard]] std::shared_ptr<const CollisionBody> collision_body(const Solid& solid);

/// A box around a body at a pose, grown by a margin on all sides [m].
[[nodiscard]] Eigen::AlignedBox3d world_box(const CollisionBody& body, const Pose<double>& X_WB,
                                            double margin);

}  // namespace thenar
