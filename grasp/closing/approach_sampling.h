#pragma once

/// Random approaches: poses, postures and stand-offs at which grasps start.

#include <random>

#include <Eigen/Core>

#include "grasp/closing/collision_hand.h"
#include "grasp/closing/setup.h"
#include "hand/hand.h"

namespace thenar {

/// Samples a collision-free hand pose whose palm faces the object. Two kinds are equally likely:
///
/// along an axis: the approach direction is one of the six half-axes of the object's box, all
///   equally likely; it points to an aim, uniform in a ball of 1/10 of the object's radius about
///   the
///   centre of mass. The hand closes (closing_axis()) across the shorter of the other two axes, in
///   either sense, so that jaws lie flat on flat sides.
/// free: the approach direction is uniform on the sphere, the roll about it uniform, and the aim
///   uniform in a ball of half the object's radius about its centre of mass.
///
/// Each call draws nine random numbers, so that hands of any kind keep the same random sequence.
/// @param q  posture of the approach (coordinates)
[[nodiscard]] Pose<double> sample_approach_pose(const CollisionHand& hand, const Eigen::VectorXd& q,
                                                const GraspBody& object, std::mt19937& random);

/// Returns the distance that takes a hand from a sampled pose to beyond the object [m].
[[nodiscard]] double approach_distance(const CollisionHand& hand, const Eigen::VectorXd& q,
                                       const GraspBody& object);

/// Samples GraspOptions::stand_off [1]: 0 with probability 1/2, otherwise uniform in [0, 1). Draws
/// one number.
[[nodiscard]] double sample_stand_off(std::mt19937& random);

/// Samples the posture of approach `number` [rad], of sliding joints [m]. Every fourth starts at
/// open_posture(). In the others, coordinates without drives are uniform within their limits,
/// except those that move all digits together, such as wrists and arms: these would turn the palm
/// away from its approach direction.
[[nodiscard]] Eigen::VectorXd sample_preshape(const CollisionHand& hand, int number,
                                              std::mt19937& random);

/// Samples a number uniform in [0, 1), identical on every platform, unlike
/// std::uniform_real_distribution.
[[nodiscard]] inline double sample_uniform(std::mt19937& random) { return random() * 0x1p-32; }

/// Samples a number uniform in [lower, upper).
[[nodiscard]] inline double sample_between(double lower, double upper, std::mt19937& random) {
  return lower + sample_uniform(random) * (upper - lower);
}

/// Samples a posture uniform within a hand's limits [rad], of sliding joints [m] (coordinates)
[[nodiscard]] inline Eigen::VectorXd sample_posture(const HandLayout& layout,
                                                    std::mt19937& random) {
  Eigen::VectorXd q(layout.lower.size());
  for (Eigen::Index j = 0; j < q.size(); ++j)
    q[j] = sample_between(layout.lower[j], layout.upper[j], random);
  return q;
}

}  // namespace thenar
