#include "geometry/collision/empty_space.h"

#include <cmath>
#include <limits>

namespace thenar {

void EmptySpace::add_ball(const Ball& ball) {
  if (balls_.size() < kMaxKept) balls_.push_back(ball);
}

void EmptySpace::add_plane(const Eigen::Vector3d& n, double offset) {
  planes_[planes_seen_ % kMaxKept] = {n, offset};
  ++planes_seen_;
}

double EmptySpace::bound(const Ball& ball) const {
  double bound = -std::numeric_limits<double>::infinity();
  for (const Ball& empty : balls_)
    bound = std::max(bound, empty.r - (ball.c - empty.c).norm() - ball.r);
  for (std::size_t i = 0; i < plane_count(); ++i)
    bound = std::max(bound, planes_[i].n.dot(ball.c) - planes_[i].offset - ball.r);
  return bound;
}

double EmptySpace::bound(const Eigen::Matrix3d& corners, double radius) const {
  double bound = -std::numeric_limits<double>::infinity();
  for (const Ball& empty : balls_) bound = std::max(bound, triangle_bound(empty, corners) - radius);
  for (std::size_t i = 0; i < plane_count(); ++i)
    bound = std::max(bound,
                     (planes_[i].n.transpose() * corners).minCoeff() - planes_[i].offset - radius);
  return bound;
}

namespace {

constexpr double kMaxLift = 10;  // maximum lift; beyond it rounding errors matter [m]

}  // namespace

Ball lifted_ball(const Shape& b, const Eigen::Matrix3d& corners, const Ball& ball,
                 const NearestSurface& seen, double wanted) {
  // Compute the triangle's height above the plane of the nearest surface, less the wanted bound.
  const double lowest =
      seen.distance + (seen.normal.transpose() * (corners.colwise() - ball.c)).minCoeff();
  const double margin = lowest - wanted;
  if (!(margin > 0)) return {ball.c, -std::numeric_limits<double>::infinity()};
  // Lift at which the rim of the ball lies below that plane by less than the margin.
  const double h = std::min(ball.r * ball.r / margin, kMaxLift);
  const Eigen::Vector3d above = ball.c + h * seen.normal;
  return {above, b.distance(above)};
}

double triangle_bound(const Ball& empty, const Eigen::Matrix3d& corners) {
  return empty.r - std::sqrt((corners.colwise() - empty.c).colwise().squaredNorm().maxCoeff());
}

}  // namespace thenar
