#pragma once

/// Collision model of a hand, built once for all grasps.

#include <vector>

#include <Eigen/Core>

#include "data/io/world/materials.h"
#include "geometry/collision/collision_tree.h"
#include "hand/hand.h"

namespace thenar {

/// Table of surfaces and the coordinates that move them (surfaces, coordinates).
using MovedBy = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

/// Two surfaces of a hand that may meet.
struct SurfacePair {
  int a, b;                    // of Hand::surfaces()
  double yield = 0;            // depth of overlap at which they stop each other [m]
  double sticking_cosine = 0;  // sticks if at least this share of the speed is into the other [1]
};

/// Surfaces of a hand as collision trees; constant once built. The hand must outlive it.
struct CollisionHand {
  const Hand* hand;
  std::vector<CollisionTree> trees;  // of each surface, hand frame, reference posture
  MovedBy moved_by;                  // (surfaces, coordinates)
  std::vector<SurfacePair> self;     // pairs that may meet: all but near ones of one limb
};

/// Depth to which the soft layer of a surface can be pressed: its thickness,
/// Material::layer_thickness [m]; 0 for materials that are not in the table. The built-in table has
/// 3 mm for skin.
[[nodiscard]] double soft_layer(const LinkSurface& surface,
                                const Materials& materials = built_in_materials());

/// Builds the collision model. The Jacobians tell which coordinates move a surface, so that no
/// kinematic tree is needed.
///
/// Surfaces of one link never meet; nor do those of a link and of the next link towards the base
/// that has a surface. Two soft surfaces yield by both their layers, and stick where one goes into
/// the other within their friction cone: with a share of  1 / sqrt(1 + mu^2)  or more of its speed,
/// 0.74 for skin on skin by the built-in table. Two soft surfaces do not meet, either,
/// - on a link and the next but one: flesh folds between them as the joints flex (under the thumb's
///   phalanx lies its own eminence, though the palm carries it); joint limits stand for contact
///   there;
/// - where both turn the same way in closing, about axes within 45 deg of each other: fingers that
///   curl side by side part sideways, without a drive; here they overlap instead.
/// @throws InputError if the hand has no surface, or two soft materials of it no friction.
[[nodiscard]] CollisionHand collision_hand(const Hand& hand,
                                           const Materials& materials = built_in_materials());

}  // namespace thenar
