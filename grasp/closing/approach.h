#pragma once

/// Approach: translation of a hand along the direction of its palm until it meets an object.

#include <string>
#include <vector>

#include "grasp/closing/close_hand.h"

namespace thenar {

/// Result of approach().
struct [[nodiscard]] ApproachResult {
  Pose<double> X_WH;              // final pose of the hand
  bool touches = false;           // false: the hand moved the whole distance without a contact
  std::string surface, body;      // first contact: surface of the hand, body of the setup
  double clearance = 0;           // distance between that surface and that body [m]
  std::vector<Overlap> overlaps;  // overlaps at the start; if there are any, the hand is not moved
};

/// Moves the hand along its approach direction until a link is within `accuracy` of the object or
/// an obstacle and would penetrate it, by conservative advancement as in close_hand().
/// @param distance  maximum distance of the motion [m]
/// @throws InputError as close_hand() does.
ApproachResult approach(const CollisionHand& hand, const Pose<double>& X_WH,
                        const Eigen::VectorXd& q, const GraspSetup& setup, double distance,
                        const CloseOptions& options = {});

/// Limits of the motion of yielding_approach().
struct ApproachLimits {
  double distance = 0;  // maximum distance along the approach direction [m]
  double sidestep = 0;  // maximum distance across it, to clear the object [m]; 0: none
};

/// Approaches the object, and steps aside where a digit meets it on the way. After such a contact
/// the hand moves by 1/20 of the object's radius across the approach direction d, along n - (n'd) d
/// with the contact normal n, and continues its approach. It ends where the palm or an obstacle is
/// met, where a digit meets the object head-on (|n - (n'd) d| < 0.2), where another step would
/// overlap something or slide past the object, or when the steps add up to `limits.sidestep`.
/// @throws InputError as approach(), or if `limits.sidestep` is negative.
ApproachResult yielding_approach(const CollisionHand& hand, const Pose<double>& X_WH,
                                 const Eigen::VectorXd& q, const GraspSetup& setup,
                                 const ApproachLimits& limits, const CloseOptions& options = {});

}  // namespace thenar
