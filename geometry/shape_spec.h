#pragma once

/// Shapes as plain data, in the form of data files.

#include <array>
#include <string>

#include "base/enum_names.h"
#include "base/spatial.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

/// Kinds of shapes; ShapeSpec defines the meaning of `size`.
enum class ShapeKind {
  kSphere,
  kBox,
  kCylinder,
  kCapsule,
  kTaperedCapsule,
  kEllipsoid,
  kSuperellipsoid,
  kMesh
};
/// Names as in data files.
inline constexpr std::array kShapeKindNames{EnumName{ShapeKind::kSphere, "sphere"},
                                            EnumName{ShapeKind::kBox, "box"},
                                            EnumName{ShapeKind::kCylinder, "cylinder"},
                                            EnumName{ShapeKind::kCapsule, "capsule"},
                                            EnumName{ShapeKind::kTaperedCapsule, "tapered capsule"},
                                            EnumName{ShapeKind::kEllipsoid, "ellipsoid"},
                                            EnumName{ShapeKind::kSuperellipsoid, "superellipsoid"},
                                            EnumName{ShapeKind::kMesh, "mesh"}};
[[nodiscard]] inline std::string name_of(ShapeKind kind) { return name_in(kShapeKindNames, kind); }

/// One shape, placed in the frame of its body. In its own frame, centred at the origin:
///   sphere          radius size[0]
///   box             full edges size[0..2]
///   cylinder        radius size[0], full height size[1], about z
///   capsule         radius size[0] about the segment |z| <= size[1] / 2
///   tapered capsule radius size[0] at z = -size[2] / 2, size[1] at z = +size[2] / 2
///   ellipsoid       semi-axes size[0..2]
///   superellipsoid  semi-axes size[0..2], with (e1, e2) = exponents, each in [0.1, 2]:
///                   ((x/a)^(2/e2) + (y/b)^(2/e2))^(e2/e1) + (z/c)^(2/e1) = 1. Source: [Barr1981].
///   mesh            the surface of `mesh`, in the frame of its file, in metres
struct ShapeSpec {
  ShapeKind kind = ShapeKind::kSphere;
  Eigen::Vector3d size{0, 0, 0};    // [m] (3)
  Eigen::Vector2d exponents{1, 1};  // e1 (latitude), e2 (longitude) of a superellipsoid [1]
  TriangleMesh mesh;                // mesh of kMesh
  std::string mesh_file;            // path from which it was read, as written there; may be empty
  double mesh_scale = 1;            // [m] per unit of the file, already applied to `mesh`
  Pose<double> X_BS;                // frame of the shape in the frame of its body
};

/// Returns the number of entries of `size` that a kind uses.
[[nodiscard]] inline int size_entries(ShapeKind kind) {
  if (kind == ShapeKind::kMesh) return 0;
  if (kind == ShapeKind::kSphere) return 1;
  return kind == ShapeKind::kCylinder || kind == ShapeKind::kCapsule ? 2 : 3;
}

}  // namespace thenar
