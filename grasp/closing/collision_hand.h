#pragma once

/// A hand ready to touch things: what is worked out once and asked for in every grasp.

#include <vector>

#include <Eigen/Core>

#include "data/io/world/materials.h"
#include "geometry/collision/collision_tree.h"
#include "hand/hand.h"

namespace thenar {

using MovedBy = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

/// Two surfaces of a hand.
struct SurfacePair {
  int a, b;          // of Hand::surfaces()
  double yield = 0;  // how deep they may go into each other [m]
  double stick = 0;  // least share of its speed into the other with which one sticks to it [1]
};

/// Constant once built; the hand must outlive it.
struct CollisionHand {
  const Hand* hand;
  std::vector<CollisionTree> touch;  // of each surface, hand frame, reference posture
  MovedBy moved_by;                  // which coordinates move which surface (surfaces, coordinates)
  std::vector<SurfacePair> self;     // that may meet: all but near ones of one limb
};

/// How deep the soft layer of a surface can be pressed: to its thickness, Material::layer_thickness
/// [m]; 0 of materials that are not in the table. Of skin 3 mm in the built-in one.
[[nodiscard]] double soft_layer(const LinkSurface& surface,
                                const Materials& materials = built_in_materials());

/// Which coordinates move a surface is read off the Jacobians, so that no tree need be known.
///
/// Surfaces of one link never meet, nor those of a link and of the next one towards the base that
/// has a surface. Two soft ones yield by both their layers, and stick where one goes into the other
/// within the cone of their friction: with a share of  1 / sqrt(1 + mu^2)  or more of its speed,
/// 0.74 of skin on skin by the built-in table. Moreover soft ones do not meet
/// - on a link and the next but one: flesh folds between them as the joints flex (what lies under
///   the thumb's phalanx is its own eminence, though the palm carries it); limits of joints stand
///   for contact there;
/// - where both turn the same way in closing, about axes within 45 deg of each other: fingers that
///   curl side by side part sideways, for which no drive is needed; here they overlap instead.
/// @param materials  of the world that the hand is in, Scene::materials
/// @throws InputError if the hand has no surface, or two soft materials of it no friction.
[[nodiscard]] CollisionHand collision_hand(const Hand& hand,
                                           const Materials& materials = built_in_materials());

}  // namespace thenar
