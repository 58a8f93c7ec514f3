#include "grasp/contact/lifted_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thenar {
namespace {

constexpr double kHighest = 100;  // lift: farther off, rounding counts [m]

}  // namespace

double lifted_bound(const Shape& b, const Eigen::Matrix3d& corners, const Ball& ball,
                    const NearestSurface& seen, double wanted) {
  const double lowest =
      seen.distance + (seen.normal.transpose() * (corners.colwise() - ball.c)).minCoeff();
  const double spare = lowest - wanted;
  if (!(spare > 0)) return -std::numeric_limits<double>::infinity();
  const double h = std::min(ball.r * ball.r / spare, kHighest);
  const Eigen::Vector3d above = ball.c + h * seen.normal;
  const double r = std::sqrt((corners.colwise() - above).colwise().squaredNorm().maxCoeff());
  return b.distance(above) - r;
}

}  // namespace thenar
