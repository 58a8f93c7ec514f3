#pragma once

/// Hands, what they hold and where they touch it, as layers of a picture.

#include <vector>

#include "grasp/closing/setup.h"
#include "grasp/contact/contact.h"
#include "hand/hand.h"
#include "hand/skin/skin_landmarks.h"
#include "report/picture/mesh_table.h"

namespace thenar {

/// A hand in its place.
struct HandPicture {
  const Hand& hand;
  Eigen::VectorXd q;               // (coordinates) [rad] or [m]
  Pose<double> X_WH;               //
  std::vector<SkinPatch> patches;  // nails are drawn in their own colour; may be empty
  int carrier_surfaces = 0;        // the first so many are of arm and base, which the view need
                                   // not hold
};

/// Returns a layer for every digit, one for what is no digit, one for what carries the hand; skin
/// in the colour of skin, everything else in a colour for each digit.
[[nodiscard]] Json hand_layers(const HandPicture& picture, MeshTable& meshes);

/// Returns the object, seen through so that contacts are seen, and the obstacles, which the view
/// need not hold.
[[nodiscard]] Json setup_layers(const GraspSetup& setup, MeshTable& meshes);

/// Returns contacts: points and normals as one layer, friction cones as another.
/// @param reach  of the object: arrows and sides of cones are a quarter of it, and no longer than a
///               pad is wide, 12 mm [m]
[[nodiscard]] Json contact_layers(const std::vector<HandContact>& contacts,
                                  const Pose<double>& X_WO, double reach);

/// Returns a block that shows layers. @param view  from the object towards the eye, world frame (3)
[[nodiscard]] Json picture_block(const std::string& caption, const Eigen::Vector3d& view,
                                 Json layers);

/// Returns a block that shows layers as a thumbnail.
[[nodiscard]] Json thumbnail_block(const std::string& caption, const Eigen::Vector3d& view,
                                   Json layers);

/// Returns `more` after `layers`.
[[nodiscard]] Json joined(Json layers, const Json& more);

}  // namespace thenar
