#pragma once

/// Random approaches: poses, postures and stand-offs from which a hand starts.

#include <random>

#include <Eigen/Core>

#include "grasp/closing/collision_hand.h"
#include "grasp/closing/setup.h"
#include "hand/hand.h"

namespace thenar {

/// Samples a collision-free hand pose whose palm faces the object. Two kinds are equally likely:
///
/// along axes: the hand comes along one of the six half-axes of the object's box, all equally
/// likely,
///   aims at a point that is uniform in a ball of a tenth of the object's radius about its centre
///   of mass, and closes (closing_axis()) across the shorter of the other two axes, in either
///   sense. Jaws then lie flat on flat sides, as they would turn the object to.
/// any: the direction of approach is uniform on the sphere, the roll about it uniform, and the aim
///   uniform in a ball of half the object's radius about its centre of mass.
///
/// The same generator gives every hand the same nine random numbers, whatever its build.
/// @param q  posture of the approach (coordinates)
[[nodiscard]] Pose<double> sample_approach_pose(const CollisionHand& hand, const Eigen::VectorXd& q,
                                                const GraspBody& object, std::mt19937& random);

/// Distance of approach from such a start to beyond the object [m].
[[nodiscard]] double approach_distance(const CollisionHand& hand, const Eigen::VectorXd& q,
                                       const GraspBody& object);

/// Samples GraspOptions::stand_off: 0 in half of all grasps, otherwise uniform in [0, 1). One draw.
/// [1]
[[nodiscard]] double sample_stand_off(std::mt19937& random);

/// Samples the posture of approach `number` [rad], of sliding joints [m]: open_posture() for every
/// fourth. For the others, undriven coordinates are uniform within their limits. Those that move
/// all digits alike, as wrists and arms do, stay: they would turn the palm away from its approach.
[[nodiscard]] Eigen::VectorXd sample_preshape(const CollisionHand& hand, int number,
                                              std::mt19937& random);

/// Uniform in [0, 1), the same on every machine; std::uniform_real_distribution is not.
[[nodiscard]] inline double sample_uniform(std::mt19937& random) { return random() * 0x1p-32; }

/// Uniform in [lower, upper).
[[nodiscard]] inline double sample_between(double lower, double upper, std::mt19937& random) {
  return lower + sample_uniform(random) * (upper - lower);
}

/// Uniform posture within a hand's limits [rad], of sliding joints [m] (coordinates)
[[nodiscard]] inline Eigen::VectorXd sample_posture(const HandLayout& layout,
                                                    std::mt19937& random) {
  Eigen::VectorXd q(layout.lower.size());
  for (Eigen::Index j = 0; j < q.size(); ++j)
    q[j] = sample_between(layout.lower[j], layout.upper[j], random);
  return q;
}

}  // namespace thenar
