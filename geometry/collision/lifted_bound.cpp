#include "geometry/collision/lifted_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thenar {
namespace {

constexpr double kHighest = 10;  // lift: farther off, rounding counts [m]

}  // namespace

Ball lifted_ball(const Shape& b, const Eigen::Matrix3d& corners, const Ball& ball,
                 const NearestSurface& seen, double wanted) {
  const double lowest =
      seen.distance + (seen.normal.transpose() * (corners.colwise() - ball.c)).minCoeff();
  const double spare = lowest - wanted;
  if (!(spare > 0)) return {ball.c, -std::numeric_limits<double>::infinity()};
  const double h = std::min(ball.r * ball.r / spare, kHighest);
  const Eigen::Vector3d above = ball.c + h * seen.normal;
  return {above, b.distance(above)};
}

double bound_by(const Ball& empty, const Eigen::Matrix3d& corners) {
  return empty.r - std::sqrt((corners.colwise() - empty.c).colwise().squaredNorm().maxCoeff());
}

}  // namespace thenar
