#pragma once

/// Collision geometry of a body in motion: primitives by their sizes, everything else by triangles.

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
  Pose<double> X_BP{};  // frame of the part in the frame of the body
  Ball ball{};          // bounding ball of the part, in its frame

  // Sizes, in the part's frame, about its origin.
  double half_length = 0;  // kRound: the balls are centred at z = -half_length and +half_length [m]
  std::array<double, 2> radius{};  // kRound: radii of the lower and the upper ball [m]
  Eigen::Vector3d half{0, 0,
                       0};    // half sizes of kBox, kCylinder (r, r, height / 2), kSmooth [m] (3)
  bool is_ellipsoid = false;  // kSmooth: an ellipsoid; false: a superellipsoid

  std::shared_ptr<const Shape> shape;  // distance, in the frame of the part
  /// Surface of all forms but kRound, tessellated if curved.
  std::shared_ptr<const Polyhedron> polyhedron;
};

/// Collision geometry of a body, in the frame of its solid; constant after construction.
struct CollisionBody {
  std::vector<CollisionPart> parts;
  Eigen::AlignedBox3d box;  // bounding box of all parts [m]
  Ball ball;                // bounding ball of all parts
  double thickness = 0;  // motion below which nothing passes through a part: the minimum extent of
                         // primitives, and twice volume over area of every surface of triangles [m]
};

/// Builds the collision geometry of a solid with `parts`, from build_solid(). A solid without them
/// is treated as polyhedra, or as balls and capsules if its collision surfaces are points or
/// segments.
/// @throws InputError if the solid has no shape or no collision surface, or a rounded triangle.
[[nodiscard]] std::shared_ptr<const CollisionBody> collision_body(const Solid& solid);

/// Returns a bounding box of a body at a pose, enlarged by a margin on all sides [m].
[[nodiscard]] Eigen::AlignedBox3d world_box(const CollisionBody& body, const Pose<double>& X_WB,
                                            double margin);

}  // namespace thenar
