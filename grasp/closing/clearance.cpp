#include "grasp/closing/clearance.h"

#include <cmath>

namespace thenar {
namespace {

// Relative error of a clearance; distant ones are measured again anyway [1]
constexpr double kClearanceError = 0.2;

const LinkSurface& surface_of(const PosedCollisionHand& posed, int surface) {
  return posed.collision_hand.hand->surfaces()[surface];
}

}  // namespace

Pose<double> PosedCollisionHand::surface_pose(int surface) const {
  const int link = surface_of(*this, surface).link;
  return link < 0 ? X_WH : X_WH * links[link];
}

SignedDistance measure_clearance(Clearance& clearance, const PosedCollisionHand& posed,
                                 double tolerance, double cutoff) {
  // A relative error is enough for large distances.
  SignedDistanceOptions options;
  options.tolerance = tolerance;
  options.relative = kClearanceError;
  options.cutoff = cutoff;
  options.start = clearance.nearest;
  const CollisionTree& touch = posed.collision_hand.trees[clearance.surface];
  const Pose<double> X = posed.surface_pose(clearance.surface);
  // Distance from a body of the setup, or from another surface of the hand.
  SignedDistance found =
      clearance.body != nullptr
          ? signed_distance(touch, X, clearance.body->solid, clearance.body->X_WB, options)
          : signed_distance(touch, X, *surface_of(posed, clearance.other).solid,
                            posed.surface_pose(clearance.other), options);
  // An infinite error marks a lower bound beyond the cutoff.
  clearance.bound = std::isfinite(found.error) ? found.distance - found.error : found.distance;
  clearance.nearest = found.triangle;
  return found;
}

double bounding_ball_clearance(const Clearance& clearance, const PosedCollisionHand& posed) {
  const Ball& ball = posed.collision_hand.trees[clearance.surface].nodes[0].ball;
  const Eigen::Vector3d c = posed.surface_pose(clearance.surface) * ball.c;
  // Distance between two balls, or of a ball from the body.
  if (clearance.body == nullptr) {
    const Ball& other = posed.collision_hand.trees[clearance.other].nodes[0].ball;
    return (c - posed.surface_pose(clearance.other) * other.c).norm() - ball.r - other.r;
  }
  const Shape& shape = *clearance.body->solid.shape;
  return shape.distance(clearance.body->X_WB.inverse() * c) - shape.accuracy() - ball.r;
}

std::vector<Clearance> find_clearances(const PosedCollisionHand& posed, const GraspSetup& setup) {
  std::vector<Clearance> clearances;
  const auto add = [&](int surface, const GraspBody& body) {
    clearances.push_back({surface, -1, &body});
    clearances.back().bound = bounding_ball_clearance(clearances.back(), posed);
  };
  // Pair every surface with the object and every obstacle.
  for (int s = 0; s < static_cast<int>(posed.collision_hand.trees.size()); ++s) {
    add(s, setup.object);
    for (const GraspBody& obstacle : setup.obstacles) add(s, obstacle);
  }
  return clearances;
}

SelfClearances find_self_clearances(const PosedCollisionHand& posed, double accuracy) {
  SelfClearances self;
  for (const SurfacePair& pair : posed.collision_hand.self_pairs) {
    // Bounding balls first, exact distances only where these are not enough.
    Clearance clearance{pair.a, pair.b};
    clearance.yield_depth = pair.yield_depth;
    clearance.sticking_cosine = pair.sticking_cosine;
    clearance.bound = bounding_ball_clearance(clearance, posed);
    double distance = clearance.bound;
    if (clearance.margin() <= accuracy)
      distance = measure_clearance(clearance, posed, accuracy / 4, 100 * accuracy).distance;
    // Keep clear pairs; overlapping ones cannot stop each other.
    if (clearance.margin() > accuracy)
      self.clearances.push_back(clearance);
    else if (distance + clearance.yield_depth < 0)
      self.overlaps.push_back(
          {surface_of(posed, pair.a).name, surface_of(posed, pair.b).name, -distance});
  }
  return self;
}

std::vector<Overlap> find_overlaps(const PosedCollisionHand& posed, const GraspSetup& setup,
                                   double accuracy) {
  std::vector<Overlap> overlaps;
  for (Clearance& clearance : find_clearances(posed, setup)) {
    if (clearance.bound > 0) continue;
    const double distance = measure_clearance(clearance, posed, accuracy / 4, accuracy).distance;
    if (distance < 0)
      overlaps.push_back(
          {surface_of(posed, clearance.surface).name, clearance.body->name, -distance});
  }
  return overlaps;
}

}  // namespace thenar
