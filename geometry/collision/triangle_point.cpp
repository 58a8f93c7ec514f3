#include "geometry/collision/triangle_point.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace thenar {

Eigen::Vector3d nearest_in_segment(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                   const Eigen::Vector3d& p) {
  const Eigen::Vector3d way = to - from;
  const double square = way.squaredNorm();
  if (!(square > 0)) return from;
  return from + std::clamp((p - from).dot(way) / square, 0.0, 1.0) * way;
}

Eigen::Vector3d nearest_in_triangle(const Eigen::Matrix3d& corners, const Eigen::Vector3d& p) {
  const Eigen::Vector3d a = corners.col(0), b = corners.col(1), c = corners.col(2);
  const Eigen::Vector3d n = (b - a).cross(c - a);
  // Inside the prism over the triangle: straight down.
  const double square = n.squaredNorm();
  if (square > 0 && n.cross(b - a).dot(p - a) >= 0 && n.cross(c - b).dot(p - b) >= 0 &&
      n.cross(a - c).dot(p - c) >= 0)
    return p - n.dot(p - a) / square * n;
  // Else on a side.
  Eigen::Vector3d best = nearest_in_segment(a, b, p);
  for (const Eigen::Vector3d& q : {nearest_in_segment(b, c, p), nearest_in_segment(c, a, p)})
    if ((q - p).squaredNorm() < (best - p).squaredNorm()) best = q;
  return best;
}

std::array<Eigen::Matrix3d, 2> halves(const Eigen::Matrix3d& corners) {
  int from = 0;
  double longest = -1;
  for (int k = 0; k < 3; ++k) {
    const double square = (corners.col(k) - corners.col((k + 1) % 3)).squaredNorm();
    if (square > longest) longest = square, from = k;
  }
  const int to = (from + 1) % 3;
  std::array<Eigen::Matrix3d, 2> halves{corners, corners};
  halves[0].col(to) = halves[1].col(from) = (corners.col(from) + corners.col(to)) / 2;
  return halves;
}

}  // namespace thenar
