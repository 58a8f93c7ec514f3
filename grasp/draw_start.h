#pragma once

/// Where a hand begins its approach, at random.

#include <random>

#include "grasp/scene.h"
#include "grasp/touching_hand.h"

namespace thenar {

/// A pose clear of the object from which the palm looks at it: the direction of approach is uniform
/// on the sphere, the roll about it uniform, and it aims at a point uniform in a ball of half the
/// object's reach about its centre of mass. The same generator gives every hand the same four
/// draws, whatever its build.
/// @param q  posture of the approach (coordinates)
[[nodiscard]] Pose<double> draw_start(const TouchingHand& hand, const Eigen::VectorXd& q,
                                      const SceneBody& object, std::mt19937& random);

/// The way from such a start past the object [m].
[[nodiscard]] double way_past(const TouchingHand& hand, const Eigen::VectorXd& q,
                              const SceneBody& object);

}  // namespace thenar
