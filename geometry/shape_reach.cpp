#include "geometry/shape_reach.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "geometry/superellipsoid.h"

namespace thenar {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Maximum distance to a superellipsoid, by ascent from one direction: repeatedly to the point
/// that is farthest along the direction from `from` to the last one.
double ascend(const Vector3d& size, const Vector2d& exponents, const Vector3d& from,
              Vector3d direction) {
  constexpr int kMaxSteps = 3000;  // maximum number of steps of the ascent
  double reach = 0;
  for (int step = 0; step < kMaxSteps; ++step) {
    direction = superellipsoid_support(size, exponents, direction) - from;
    if (!(direction.norm() > reach)) break;
    reach = direction.norm();
  }
  return reach;
}

double reach_of_superellipsoid(const Vector3d& size, const Vector2d& exponents,
                               const Vector3d& from) {
  // The distance has several maxima: from the faces, edges and corners of a cube, and away from
  // the point.
  double farthest = ascend(size, exponents, from, -from);
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0)
          farthest = std::max(farthest, ascend(size, exponents, from, Vector3d(x, y, z)));
  return farthest;
}

}  // namespace

double reach_of(const ShapeSpec& shape, const Vector3d& from) {
  require(from.allFinite(), "wanted a finite point, got ({}, {}, {})", from.x(), from.y(),
          from.z());
  const Vector3d p = shape.X_BS.inverse() * from;
  // Compute the largest distance from a circle about z.
  const auto to_circle = [&](double radius, double z) {
    return std::hypot(p.head<2>().norm() + radius, p.z() - z);
  };
  const auto to_ball = [&](double radius, double z) {
    return (p - Vector3d(0, 0, z)).norm() + radius;
  };
  switch (shape.kind) {
    case ShapeKind::kSphere:
      return to_ball(shape.size[0], 0);
    case ShapeKind::kBox:
      return (p.cwiseAbs() + shape.size / 2).norm();
    case ShapeKind::kCylinder:
      return std::max(to_circle(shape.size[0], shape.size[1] / 2),
                      to_circle(shape.size[0], -shape.size[1] / 2));
    case ShapeKind::kCapsule:
      return std::max(to_ball(shape.size[0], shape.size[1] / 2),
                      to_ball(shape.size[0], -shape.size[1] / 2));
    case ShapeKind::kTaperedCapsule:
      return std::max(to_ball(shape.size[0], -shape.size[2] / 2),
                      to_ball(shape.size[1], shape.size[2] / 2));
    case ShapeKind::kEllipsoid:
      return reach_of_superellipsoid(shape.size, {1, 1}, p);
    case ShapeKind::kSuperellipsoid:
      return reach_of_superellipsoid(shape.size, shape.exponents, p);
    case ShapeKind::kMesh:
      return (shape.mesh.vertices.colwise() - p).colwise().norm().maxCoeff();
  }
  return 0;
}

}  // namespace thenar
