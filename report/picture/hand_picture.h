#pragma once

/// Hands, held objects and contacts as layers of a picture.

#include <vector>

#include "grasp/closing/setup.h"
#include "grasp/contact/contact.h"
#include "hand/hand.h"
#include "hand/skin/skin_landmarks.h"
#include "report/picture/mesh_table.h"

namespace thenar {

/// Hand with its posture and pose.
struct HandPicture {
  const Hand& hand;
  Eigen::VectorXd q;  // (coordinates) [rad] or [m]
  Pose<double> X_WH;
  std::vector<SkinPatch> patches;  // nails are drawn in their own colour; may be empty
  int carrier_surfaces = 0;  // number of leading surfaces of arm and base, which may be out of view
};

/// Returns a layer for every digit, one for the rest of the hand, and one for its carriers; skin
/// has the colour of skin, everything else one colour for each digit.
[[nodiscard]] Json hand_layers(const HandPicture& picture, MeshTable& meshes);

/// Returns layers of the object, translucent so that contacts are visible, and of the obstacles,
/// which may be out of view.
[[nodiscard]] Json setup_layers(const GraspSetup& setup, MeshTable& meshes);

/// Returns layers of contacts: points and normals in one, friction cones in another.
/// @param reach  reach of the object [m]: arrows and sides of cones are a quarter of it, at most 12
/// mm, the width of a pad
[[nodiscard]] Json contact_layers(const std::vector<HandContact>& contacts,
                                  const Pose<double>& X_WO, double reach);

/// Returns a block that shows layers. @param view  direction from the object towards the eye, world
/// frame (3)
[[nodiscard]] Json picture_block(const std::string& caption, const Eigen::Vector3d& view,
                                 Json layers);

/// Returns a block that shows layers as a thumbnail.
[[nodiscard]] Json thumbnail_block(const std::string& caption, const Eigen::Vector3d& view,
                                   Json layers);

}  // namespace thenar
