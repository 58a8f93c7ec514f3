#pragma once

/// Going at an object along the palm.

#include <string>
#include <vector>

#include "grasp/closing/close_hand.h"

namespace thenar {

struct [[nodiscard]] ApproachResult {
  Pose<double> X_WH;              // where the hand came to
  bool touches = false;           // false: it went all the way and met nothing
  std::string surface, body;      // that met first
  double clearance = 0;           // between them [m]
  std::vector<Overlap> overlaps;  // at the start; not empty: it was not moved
};

/// Moves the hand along its approach direction until a link is within `accuracy` of the object or
/// of an obstacle and would go into it, by conservative advancement as in close_hand().
/// @param way  farthest it may go [m]
/// @throws InputError as close_hand() does.
ApproachResult approach(const CollisionHand& hand, const Pose<double>& X_WH,
                        const Eigen::VectorXd& q, const Scene& scene, double way,
                        const CloseOptions& options = {});

// Going at an object that a finger meets before the palm does.

/// approach(), but where a digit meets the object the hand gives way and goes on: by steps of a
/// twentieth of the object's reach across the approach d, to where the digit is pushed by the
/// normal n of the contact, n - (n'd) d. It ends where the palm or an obstacle is met, where a
/// digit meets the object head-on (|n - (n'd) d| < 0.2), where another step would go into
/// something, or when it has given way by `most`.
/// @param most  farthest it gives way [m]; 0: as approach()
/// @throws InputError as approach(), or if `most` is negative.
ApproachResult yielding_approach(const CollisionHand& hand, const Pose<double>& X_WH,
                                 const Eigen::VectorXd& q, const Scene& scene, double way,
                                 double most, const CloseOptions& options = {});

}  // namespace thenar
