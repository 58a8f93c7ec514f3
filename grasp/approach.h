#pragma once

/// Going at an object along the palm.

#include <string>
#include <vector>

#include "grasp/close_hand.h"

namespace thenar {

struct [[nodiscard]] Approached {
  Pose<double> X_WH;              // where the hand came to
  bool touches = false;           // false: it went all the way and met nothing
  std::string surface, body;      // that met first
  double gap = 0;                 // between them [m]
  std::vector<Overlap> overlaps;  // at the start; not empty: it was not moved
};

/// Moves the hand along its approach direction until a link is within `accuracy` of the object or
/// of an obstacle and would go into it, by conservative advancement as in close_hand().
/// @param way  farthest it may go [m]
/// @throws InputError as close_hand() does.
Approached approach(const TouchingHand& hand, const Pose<double>& X_WH, const Eigen::VectorXd& q,
                    const Scene& scene, double way, const CloseOptions& options = {});

}  // namespace thenar
