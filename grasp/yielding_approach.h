#pragma once

/// Going at an object that a finger meets before the palm does.

#include "grasp/approach.h"

namespace thenar {

/// approach(), but where a digit meets the object the hand gives way and goes on: by steps of a
/// twentieth of the object's reach across the approach d, to where the digit is pushed by the
/// normal n of the contact, n - (n'd) d. It ends where the palm or an obstacle is met, where a
/// digit meets the object head-on (|n - (n'd) d| < 0.2), where another step would go into
/// something, or when it has given way by `most`.
/// @param most  farthest it gives way [m]; 0: as approach()
/// @throws InputError as approach(), or if `most` is negative.
Approached yielding_approach(const TouchingHand& hand, const Pose<double>& X_WH,
                             const Eigen::VectorXd& q, const Scene& scene, double way, double most,
                             const CloseOptions& options = {});

}  // namespace thenar
