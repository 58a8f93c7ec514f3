#pragma once

/// A hand ready to touch things: what is worked out once and asked for in every grasp.

#include <vector>

#include <Eigen/Core>

#include "grasp/contact/touch_body.h"
#include "hand/hand.h"

namespace thenar {

using MovedBy = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

/// Two surfaces of a hand.
struct SurfacePair {
  int a, b;  // of Hand::surfaces()
};

/// Constant once built; the hand must outlive it.
struct TouchingHand {
  const Hand* hand;
  std::vector<TouchBody> touch;   // of each surface, hand frame, reference posture
  MovedBy moved_by;               // which coordinates move which surface (surfaces, coordinates)
  std::vector<SurfacePair> self;  // that may meet: all but those of one link, and of a link and the
                                  // next one towards the base that has a surface
};

/// Which coordinates move a surface is read off the Jacobians, so that no tree need be known.
/// @throws InputError if the hand has no surface.
[[nodiscard]] TouchingHand touching_hand(const Hand& hand);

}  // namespace thenar
