#include "geometry/manifold/collision_body.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "geometry/mass_properties.h"
#include "geometry/mesh_parts.h"
#include "geometry/primitives.h"
#include "geometry/shape_union.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// Builds the hull of two balls in the part's frame; a ball that contains the other is the whole
/// part.
CollisionPart round_part(double lower, double upper, double length) {
  CollisionPart part;
  part.form = PartForm::kRound;
  part.half_length = length / 2;
  part.radius = {lower, upper};
  if (std::abs(lower - upper) >= length) {
    part.X_BP.p.z() = (lower > upper ? -1 : lower < upper ? 1 : 0) * length / 2;
    part.half_length = 0;
    part.radius = {std::max(lower, upper), std::max(lower, upper)};
  }
  const double reach = std::max(part.radius[0], part.radius[1]);
  part.ball = {{0, 0, 0}, part.half_length + reach};
  part.shape = part.half_length > 0
                   ? build_tapered_capsule(part.radius[0], part.radius[1], 2 * part.half_length)
                   : build_sphere(reach);
  return part;
}

/// Builds a primitive by its sizes. @param core  its tessellated surface, in the body's frame
CollisionPart primitive_part(const SolidPart& given, const TriangleMesh& core) {
  const ShapeSpec& spec = given.spec;
  const Vector3d& size = spec.size;
  CollisionPart part;
  switch (spec.kind) {
    case ShapeKind::kSphere:
      part = round_part(size(0), size(0), 0);
      break;
    case ShapeKind::kCapsule:
      part = round_part(size(0), size(0), size(1));
      break;
    case ShapeKind::kTaperedCapsule:
      part = round_part(size(0), size(1), size(2));
      break;
    case ShapeKind::kBox:
      part.form = PartForm::kBox;
      part.half = size / 2;
      break;
    case ShapeKind::kCylinder:
      part.form = PartForm::kCylinder;
      part.half = {size(0), size(0), size(1) / 2};
      break;
    case ShapeKind::kEllipsoid:
      part.form = PartForm::kSmooth;
      part.half = size;
      part.is_ellipsoid = true;
      break;
    case ShapeKind::kSuperellipsoid:
      part.form = PartForm::kSmooth;
      part.half = size;
      break;
    case ShapeKind::kMesh:
      break;
  }
  if (part.form != PartForm::kRound) {
    part.shape = given.shape;
    part.ball = {{0, 0, 0}, part.half.norm()};
    TriangleMesh surface = core;
    move_by(surface, spec.X_BS.inverse());
    part.polyhedron = build_polyhedron(surface);
  }
  part.X_BP = spec.X_BS * part.X_BP;
  return part;
}

/// Builds a ball or a capsule from a collision surface without a spec.
CollisionPart swept_part(const RoundedMesh& swept) {
  const Eigen::Matrix3Xd& v = swept.core.vertices;
  require(swept.core.triangles.cols() == 1, "a rounded surface of {} triangles is not a primitive",
          swept.core.triangles.cols());
  // Take the two corners farthest apart as ends; the third must be one of them.
  const Eigen::Vector3i t = swept.core.triangles.col(0);
  const Vector3d from = v.col(t(0)), to = v.col(t(1)) == from ? v.col(t(2)) : v.col(t(1));
  require(v.col(t(2)) == from || v.col(t(2)) == to, "a rounded triangle is not a primitive");
  const double length = (to - from).norm();
  CollisionPart part = round_part(swept.radius, swept.radius, length);
  part.X_BP.p = (from + to) / 2;
  if (length > 0) {
    part.X_BP.R = basis_along((to - from) / length);
  }
  return part;
}

/// Computes CollisionBody::thickness.
double thickness_of(const Solid& solid, const std::vector<CollisionPart>& parts) {
  double least = std::numeric_limits<double>::infinity();
  for (const CollisionPart& part : parts) {
    if (part.form == PartForm::kRound)
      least = std::min(least, 2 * std::max(part.radius[0], part.radius[1]));
    else if (part.form != PartForm::kPolyhedron)
      least = std::min(least, 2 * part.half.minCoeff());
  }
  for (const RoundedMesh& mesh : solid.collision) {
    if (mesh.radius > 0) continue;
    const double area = area_of(mesh.core), volume = signed_moments(mesh.core).mass;
    if (volume > 0 && area > 0) least = std::min(least, 2 * volume / area);
  }
  return least;
}

}  // namespace

std::shared_ptr<const CollisionBody> collision_body(const Solid& solid) {
  require(!solid.collision.empty(), "a solid without a collision surface touches nothing");
  const bool known = solid.parts.size() == solid.collision.size();
  auto body = std::make_shared<CollisionBody>();
  // Make a part of each primitive, and one part of all meshes.
  std::vector<TriangleMesh> meshes;
  std::vector<std::shared_ptr<const Shape>> shapes;
  for (std::size_t i = 0; i < solid.collision.size(); ++i) {
    const RoundedMesh& swept = solid.collision[i];
    if (known && solid.parts[i].spec.kind != ShapeKind::kMesh) {
      body->parts.push_back(primitive_part(solid.parts[i], swept.core));
    } else if (!known && swept.radius > 0) {
      body->parts.push_back(swept_part(swept));
    } else {
      meshes.push_back(swept.core);
      shapes.push_back(known ? place(solid.parts[i].shape, solid.parts[i].spec.X_BS) : solid.shape);
    }
  }
  if (!meshes.empty()) {
    require(shapes.front() != nullptr, "a solid of triangles needs a shape");
    if (!known) shapes.resize(1);
    CollisionPart part;
    part.form = PartForm::kPolyhedron;
    part.polyhedron = build_polyhedron(joined(meshes));
    part.ball = part.polyhedron->nodes.front().ball;
    part.shape = join(std::move(shapes));
    body->parts.push_back(std::move(part));
  }
  body->thickness = thickness_of(solid, body->parts);
  // Compute the bounding box and ball of all parts.
  for (const CollisionPart& part : body->parts) {
    const Vector3d c = part.X_BP * part.ball.c;
    const Eigen::AlignedBox3d box(c.array() - part.ball.r, c.array() + part.ball.r);
    // Intersect with the shape's own bounds, which may be smaller.
    body->box.extend(box.intersection(place(part.shape, part.X_BP)->bounds()));
  }
  body->ball.c = body->box.center();
  for (const CollisionPart& part : body->parts)
    body->ball.r =
        std::max(body->ball.r, (part.X_BP * part.ball.c - body->ball.c).norm() + part.ball.r);
  body->ball.r = std::min(body->ball.r, body->box.diagonal().norm() / 2);
  return body;
}

Eigen::AlignedBox3d world_box(const CollisionBody& body, const Pose<double>& X_WB, double margin) {
  const Vector3d centre = X_WB * body.box.center();
  const Vector3d half = (X_WB.R.cwiseAbs() * (body.box.sizes() / 2)).array() + margin;
  return {centre - half, centre + half};
}

}  // namespace thenar
