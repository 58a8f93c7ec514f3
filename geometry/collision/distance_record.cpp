#include "geometry/collision/distance_record.h"

#include <cmath>

namespace thenar::internal {

double DistanceRecord::distance(const Eigen::Vector3d& p) {
  ++evaluations_;
  return b_.distance(p);
}

NearestSurface DistanceRecord::nearest_surface(const Eigen::Vector3d& p) {
  ++evaluations_;
  NearestSurface seen = b_.nearest(p);
  if (seen.supports) empty_.add_plane(seen.normal, seen.normal.dot(p) - seen.distance);
  return seen;
}

double DistanceRecord::bound_by_lifted_ball(const TrianglePiece& piece) {
  ++evaluations_;
  const Ball empty =
      lifted_ball(b_, piece.corners, piece.ball, piece.seen, sufficient_bound() + piece.radius);
  if (!std::isfinite(empty.r)) return kNoBound;
  empty_.add_ball(empty);
  return triangle_bound(empty, piece.corners) - piece.radius;
}

void DistanceRecord::update_best(const Eigen::Vector3d& core, const NearestSurface& seen,
                                 const TrianglePiece& piece) {
  if (seen.distance - piece.radius >= best_.distance) return;
  best_ = {seen.distance - piece.radius, core, seen, piece.radius, piece.triangle};
}

}  // namespace thenar::internal
