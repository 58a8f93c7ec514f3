#include "geometry/collision/curvature.h"

#include <cmath>

#include "base/error.h"
#include "base/spatial.h"

namespace thenar {

using Eigen::Vector3d;

PrincipalCurvatures curvatures(const Shape& shape, const Vector3d& p, double step) {
  require(p.allFinite(), "a point of a surface must be finite");
  require(step > 0 && std::isfinite(step), "a step must be positive and finite, got {} m", step);
  // Take second differences of the distance in four directions.
  const NearestSurface at = shape.nearest(p);
  const auto second = [&](const Vector3d& v) {
    return (shape.distance(p + step * v) + shape.distance(p - step * v) - 2 * at.distance) /
           (step * step);
  };
  const Tangents t = tangents(at.normal);
  const double along1 = second(t.e1), along2 = second(t.e2);
  const double rising = second((t.e1 + t.e2).normalized());
  const double falling = second((t.e1 - t.e2).normalized());

  // Compute the principal curvatures by Mohr's circle.
  const double mean = (along1 + along2 + rising + falling) / 4;
  const double x = (along1 - along2) / 2, y = (rising - falling) / 2;
  const double turn = std::atan2(y, x) / 2, half = std::hypot(x, y);
  return {mean + half, mean - half, std::cos(turn) * t.e1 + std::sin(turn) * t.e2};
}

RelativeCurvatures relative_curvatures(const PrincipalCurvatures& a, const PrincipalCurvatures& b,
                                       double angle) {
  // Sum of both Hessians by Mohr's circle.
  const double A = a.k1 - a.k2, B = b.k1 - b.k2;
  const double mean = (a.k1 + a.k2 + b.k1 + b.k2) / 2;
  const double half = std::hypot(A + B * std::cos(2 * angle), B * std::sin(2 * angle)) / 2;
  return {mean + half, mean - half};
}

}  // namespace thenar
