#pragma once

/// Where a hand begins its approach, at random.

#include <random>

#include <Eigen/Core>

#include "grasp/closing/collision_hand.h"
#include "grasp/closing/scene.h"
#include "hand/hand.h"

namespace thenar {

/// A pose clear of the object from which the palm looks at it. Two kinds, equally likely:
///
/// along axes: the hand comes along one of the six half-axes of the object's box, each as likely,
///   aims at a point uniform in a ball of a tenth of the object's reach about its centre of mass,
///   and closes (closing_axis()) across the shorter of the other two axes, one way round or the
///   other. Jaws then lie flat on flat sides, as they would turn the object to.
/// any: the direction of approach is uniform on the sphere, the roll about it uniform, and it aims
///   at a point uniform in a ball of half the object's reach about its centre of mass.
///
/// The same generator gives every hand the same nine draws, whatever its build.
/// @param q  posture of the approach (coordinates)
[[nodiscard]] Pose<double> sample_approach_pose(const CollisionHand& hand, const Eigen::VectorXd& q,
                                                const SceneBody& object, std::mt19937& random);

/// The way from such a start past the object [m].
[[nodiscard]] double approach_distance(const CollisionHand& hand, const Eigen::VectorXd& q,
                                       const SceneBody& object);

/// GraspOptions::stand_off: 0 for half of all grasps, uniform in [0, 1) for the others. One draw.
[[nodiscard]] double sample_stand_off(std::mt19937& random);

/// The posture in which approach `number` goes at an object: open_posture() for every fourth. For
/// the others coordinates that nothing drives are drawn uniformly within their limits, but for
/// those that move all digits alike, as wrists and arms do: they would turn the palm away from its
/// approach.
[[nodiscard]] Eigen::VectorXd sample_preshape(const CollisionHand& hand, int number,
                                              std::mt19937& random);

// Uniform draws, the same on every machine: std::uniform_real_distribution is not.

/// In [0, 1).
[[nodiscard]] inline double sample_uniform(std::mt19937& random) { return random() * 0x1p-32; }

/// In [lower, upper).
[[nodiscard]] inline double sample_between(double lower, double upper, std::mt19937& random) {
  return lower + sample_uniform(random) * (upper - lower);
}

/// A posture within a hand's limits. (coordinates)
[[nodiscard]] inline Eigen::VectorXd sample_posture(const HandLayout& layout,
                                                    std::mt19937& random) {
  Eigen::VectorXd q(layout.lower.size());
  for (Eigen::Index j = 0; j < q.size(); ++j)
    q[j] = sample_between(layout.lower[j], layout.upper[j], random);
  return q;
}

}  // namespace thenar
