#pragma once

/// Collision model of a hand, built once for all grasps.

#include <vector>

#include <Eigen/Core>

#include "data/io/world/materials.h"
#include "geometry/collision/collision_tree.h"
#include "hand/hand.h"

namespace thenar {

/// Table of the coordinates that move each surface (surfaces, coordinates).
using MovedBy = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

/// Two surfaces of one hand between which contact is checked.
struct SurfacePair {
  int a = 0, b = 0;        // entries of Hand::surfaces()
  double yield_depth = 0;  // overlap at which they stop each other [m]
  /// Minimum share of the speed into the other surface at which they stick [1]
  double sticking_cosine = 0;
};

/// Surfaces of a hand as collision trees; constant after construction. The hand must outlive it.
struct CollisionHand {
  const Hand* hand = nullptr;
  std::vector<CollisionTree> trees;  // one for each surface, hand frame, reference posture
  MovedBy moved_by;  // whether each coordinate moves a surface (surfaces, coordinates)
  std::vector<SurfacePair> self_pairs;  // checked pairs: all but neighbours on one limb
};

/// Returns the depth to which the soft layer of a surface can be compressed: its thickness,
/// Material::layer_thickness [m]; 0 for materials that are not in the table. Skin has 3 mm in the
/// built-in table.
[[nodiscard]] double soft_layer_depth(const LinkSurface& surface,
                                      const Materials& materials = built_in_materials());

/// Builds the collision model. The Jacobians show which coordinates move a surface, so that no
/// kinematic tree is needed.
///
/// Contact is not checked between surfaces of one link, nor between those of a link and of the next
/// link towards the base that has a surface. Two soft surfaces stop each other when both layers are
/// compressed, and stick where one moves into the other within the friction cone: with a share of
/// 1 / sqrt(1 + mu^2)  or more of its speed, 0.74 for skin on skin in the built-in table. Contact
/// between soft surfaces is also ignored
/// - on a link and the next but one: flesh folds between them as the joints flex (the thumb's
///   phalanx lies on the thenar eminence, which the palm carries); joint limits replace contact
///   there;
/// - where both rotate in the same sense in closing, about axes within 45 deg of each other: such
///   fingers separate sideways, a motion that no drive makes; here they overlap.
/// @throws InputError if the hand has no surface, or no friction is known between two of its soft
///         materials.
[[nodiscard]] CollisionHand collision_hand(const Hand& hand,
                                           const Materials& materials = built_in_materials());

}  // namespace thenar
