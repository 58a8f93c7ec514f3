#include "geometry/solid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/units.h"
#include "geometry/mesh_distance.h"
#include "geometry/mesh_parts.h"
#include "geometry/primitives.h"
#include "geometry/shape_union.h"
#include "geometry/superellipsoid.h"
#include "geometry/tessellate.h"

namespace thenar {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;

// Sizes and places beyond these are of no thing that a hand meets, and lose all their digits.
constexpr double kMinSize = 1e-9, kMaxSize = 1e6;  // range of valid sizes [m]

void check(const ShapeSpec& spec) {
  // Check that sizes and exponents are in range.
  for (int i = 0; i < size_entries(spec.kind); ++i)
    require(spec.size(i) >= kMinSize && spec.size(i) <= kMaxSize,
            "size {} of a {}: wanted {:g} to {:g} m, got {} m", i, name_of(spec.kind), kMinSize,
            kMaxSize, spec.size(i));
  if (spec.kind == ShapeKind::kSuperellipsoid)
    require(spec.exponents.minCoeff() >= 0.1 && spec.exponents.maxCoeff() <= 2,
            "exponents of a superellipsoid must lie in [0.1, 2], got {} and {}", spec.exponents(0),
            spec.exponents(1));
  // Check that the pose has a proper rotation.
  const Pose<double>& X = spec.X_BS;
  require(X.R.allFinite() && (X.R * X.R.transpose()).isIdentity(1e-9) && X.R.determinant() > 0,
          "a {} must be placed by a rotation", name_of(spec.kind));
  require((X.p.array().abs() <= kMaxSize).all(), "a {} must be placed at most {:g} m away",
          name_of(spec.kind), kMaxSize);
}

std::shared_ptr<const Shape> shape_of(const ShapeSpec& spec) {
  const Vector3d& size = spec.size;
  switch (spec.kind) {
    case ShapeKind::kSphere:
      return build_sphere(size(0));
    case ShapeKind::kBox:
      return build_box(size);
    case ShapeKind::kCylinder:
      return build_cylinder(size(0), size(1));
    case ShapeKind::kCapsule:
      return build_tapered_capsule(size(0), size(0), size(1));
    case ShapeKind::kTaperedCapsule:
      return build_tapered_capsule(size(0), size(1), size(2));
    case ShapeKind::kEllipsoid:
      return build_ellipsoid(size);
    case ShapeKind::kMesh:
      return build_mesh_distance(spec.mesh);
    case ShapeKind::kSuperellipsoid:
      return build_superellipsoid(size, spec.exponents);
  }
  throw InputError("no such kind of shape");
}

TriangleMesh cylinder_mesh(double radius, double height, double tolerance) {
  const int sides = sides_of_circle(radius, tolerance);
  const double rho = radius * (1 + corner_overshoot(sides)), z = height / 2;
  return surface_of_revolution({{0, -z}, {rho, -z}, {rho, z}, {0, z}}, sides);
}

/// The profile's arcs have corners where the side's line begins and ends.
TriangleMesh tapered_capsule_mesh(const Vector3d& size, double tolerance) {
  const double lower = size(0), upper = size(1), half = size(2) / 2;
  // Give half of the error to each of the two curved directions.
  const int sides = sides_of_circle(std::max(lower, upper), tolerance / 2);
  const double slope = std::asin(std::clamp((lower - upper) / size(2), -1.0, 1.0));
  const int below = std::max(2, static_cast<int>(std::ceil((kPi / 2 + slope) * sides / (2 * kPi))));
  const int above = std::max(2, static_cast<int>(std::ceil((kPi / 2 - slope) * sides / (2 * kPi))));
  const double swell = 1 + 2 * corner_overshoot(sides);
  // Profile from pole to pole: two arcs, whose ends the side's line joins.
  std::vector<Vector2d> profile;
  const auto arc = [&](double radius, double z, double from, double to, int steps) {
    if (to - from < 1e-9) return;
    for (int i = 0; i <= steps; ++i) {
      const double angle = from + (to - from) * i / steps;
      profile.emplace_back(swell * radius * Vector2d(std::cos(angle), std::sin(angle)) +
                           Vector2d(0, z));
    }
  };
  arc(lower, -half, -kPi / 2, slope, below);
  arc(upper, half, slope, kPi / 2, above);
  return surface_of_revolution(profile, sides);
}

/// Surface in the shape's own frame, within `tolerance` of it on either side
/// [m].
TriangleMesh surface_of(const ShapeSpec& spec, const Shape& shape, double tolerance) {
  switch (spec.kind) {
    case ShapeKind::kBox:
      return box_mesh(spec.size);
    case ShapeKind::kCylinder:
      return cylinder_mesh(spec.size(0), spec.size(1), tolerance);
    case ShapeKind::kCapsule:
      return tapered_capsule_mesh({spec.size(0), spec.size(0), spec.size(1)}, tolerance);
    case ShapeKind::kTaperedCapsule:
      return tapered_capsule_mesh(spec.size, tolerance);
    case ShapeKind::kMesh:
      return spec.mesh;
    default:
      return tessellate(shape, tolerance);
  }
}

/// Error of a touch surface: 0.02 mm for what a hand holds, more for what is
/// larger [m].
double touch_tolerance(const Shape& shape) {
  return std::max(2e-5, 1.5e-4 * shape.bounds().sizes().maxCoeff());
}

/// Returns the core of a shape that a ball sweeps along it, with the ball's radius; for other
/// shapes their surface.
RoundedMesh touch_of(const ShapeSpec& spec, const Shape& shape) {
  RoundedMesh touch;
  // Keep the core of spheres and capsules; tessellate others.
  if (spec.kind == ShapeKind::kSphere) {
    touch = {{Vector3d::Zero(), Eigen::Vector3i::Zero()}, spec.size(0)};
  } else if (spec.kind == ShapeKind::kCapsule) {
    Eigen::Matrix3Xd ends = Eigen::Matrix3Xd::Zero(3, 2);
    ends.row(2) << -spec.size(1) / 2, spec.size(1) / 2;
    touch = {{ends, Eigen::Vector3i(0, 1, 1)}, spec.size(0)};
  } else {
    touch.core = surface_of(spec, shape, touch_tolerance(shape));
  }
  return touch;
}

/// A spec without its triangles.
ShapeSpec without_mesh(const ShapeSpec& spec) {
  return {spec.kind, spec.size, spec.exponents, {}, spec.mesh_file, spec.mesh_scale, spec.X_BS};
}

/// A mesh as one shape for each solid that it bounds; others as they are.
std::vector<ShapeSpec> parts_of(const ShapeSpec& spec) {
  check(spec);
  if (spec.kind != ShapeKind::kMesh) return {spec};
  std::vector<ShapeSpec> parts;
  for (TriangleMesh& mesh : solid_parts(spec.mesh)) {
    parts.emplace_back();
    parts.back().kind = ShapeKind::kMesh;
    parts.back().mesh = std::move(mesh);
    parts.back().X_BS = spec.X_BS;
  }
  return parts;
}

}  // namespace

Solid build_solid(const std::vector<ShapeSpec>& shapes) {
  require(!shapes.empty(), "a solid needs at least one shape");
  Solid solid;
  std::vector<std::shared_ptr<const Shape>> parts;
  std::vector<TriangleMesh> pictures;
  // Build each shape, a mesh as the solids that it bounds.
  for (const ShapeSpec& given : shapes)
    for (const ShapeSpec& spec : parts_of(given)) {
      const std::shared_ptr<const Shape> shape = shape_of(spec);
      solid.collision.push_back(touch_of(spec, *shape));
      pictures.push_back(surface_of(spec, *shape, 4 * touch_tolerance(*shape)));
      move_by(solid.collision.back().core, spec.X_BS);
      move_by(pictures.back(), spec.X_BS);
      parts.push_back(place(shape, spec.X_BS));
      solid.parts.push_back({without_mesh(spec), shape});
    }
  // Join the pictures, and unite the shapes.
  solid.visual = joined(pictures);
  solid.shape = join(std::move(parts));
  return solid;
}

}  // namespace thenar
