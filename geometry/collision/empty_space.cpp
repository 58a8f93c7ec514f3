#include "geometry/collision/empty_space.h"

#include <algorithm>
#include <limits>

#include "geometry/collision/lifted_bound.h"

namespace thenar {

void EmptySpace::add_ball(const Ball& ball) {
  if (balls_.size() < kMost) balls_.push_back(ball);
}

void EmptySpace::add_plane(const Eigen::Vector3d& n, double offset) {
  planes_[planes_seen_ % kMost] = {n, offset};
  ++planes_seen_;
}

double EmptySpace::bound(const Ball& ball) const {
  double bound = -std::numeric_limits<double>::infinity();
  for (const Ball& empty : balls_)
    bound = std::max(bound, empty.r - (ball.c - empty.c).norm() - ball.r);
  for (std::size_t i = 0; i < planes(); ++i)
    bound = std::max(bound, planes_[i].n.dot(ball.c) - planes_[i].offset - ball.r);
  return bound;
}

double EmptySpace::bound(const Eigen::Matrix3d& corners, double radius) const {
  double bound = -std::numeric_limits<double>::infinity();
  for (const Ball& empty : balls_) bound = std::max(bound, bound_by(empty, corners) - radius);
  for (std::size_t i = 0; i < planes(); ++i)
    bound = std::max(bound,
                     (planes_[i].n.transpose() * corners).minCoeff() - planes_[i].offset - radius);
  return bound;
}

}  // namespace thenar
