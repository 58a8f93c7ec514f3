#pragma once

/// Bodies for tests of contacts in motion.

#include <memory>
#include <vector>

#include "geometry/manifold/collision_pair.h"
#include "geometry/solid.h"

namespace thenar {

inline ShapeSpec spec_of(ShapeKind kind, const Eigen::Vector3d& size) {
  ShapeSpec spec;
  spec.kind = kind;
  spec.size = size;
  return spec;
}

/// A solid with the body that contacts see.
struct SampleBody {
  Solid solid;
  std::shared_ptr<const CollisionBody> body;

  explicit SampleBody(const std::vector<ShapeSpec>& specs)
      : solid(build_solid(specs)), body(collision_body(solid)) {}
  SampleBody(ShapeKind kind, const Eigen::Vector3d& size)
      : SampleBody(std::vector<ShapeSpec>{spec_of(kind, size)}) {}
};

inline Pose<double> placed(double x, double y, double z) {
  return {Eigen::Matrix3d::Identity(), Eigen::Vector3d(x, y, z)};
}

inline double least_gap(const ContactManifold& manifold) {
  double least = 1e30;
  for (const ManifoldPoint& point : manifold) least = std::min(least, point.gap);
  return least;
}

}  // namespace thenar
