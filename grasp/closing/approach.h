#pragma once

/// Approach of a hand to an object along the direction of its palm.

#include <string>
#include <vector>

#include "grasp/closing/close_hand.h"

namespace thenar {

/// Result of approach().
struct [[nodiscard]] ApproachResult {
  Pose<double> X_WH;              // final pose of the hand
  bool touches = false;           // false: it moved the whole distance and met nothing
  std::string surface, body;      // first contact: surface of the hand, body of the setup
  double clearance = 0;           // between these two [m]
  std::vector<Overlap> overlaps;  // at the start; not empty: it was not moved
};

/// Moves the hand along its approach direction until a link is within `accuracy` of the object or
/// an obstacle and would go into it, by conservative advancement as in close_hand().
/// @param distance  largest distance to move [m]
/// @throws InputError as close_hand() does.
ApproachResult approach(const CollisionHand& hand, const Pose<double>& X_WH,
                        const Eigen::VectorXd& q, const GraspSetup& setup, double distance,
                        const CloseOptions& options = {});

/// Largest distances of yielding_approach(), and distances that it went.
struct ApproachReach {
  double distance = 0;  // along the approach direction [m]
  double aside = 0;     // across it, giving way to the object [m]; 0: as approach()
};

/// approach() that lets digits give way. Where a digit meets the object, the hand steps aside, by a
/// twentieth of the object's radius across the approach direction d, along n - (n'd) d with the
/// normal n of the contact, and goes on. It ends where the palm or an obstacle is met, where a
/// digit meets the object head-on (|n - (n'd) d| < 0.2), where another step would overlap
/// something or slide past the object, or after steps of `most.aside` in all.
/// @param most  largest distances
/// @throws InputError as approach(), or if `most.aside` is negative.
ApproachResult yielding_approach(const CollisionHand& hand, const Pose<double>& X_WH,
                                 const Eigen::VectorXd& q, const GraspSetup& setup,
                                 const ApproachReach& most, const CloseOptions& options = {});

}  // namespace thenar
