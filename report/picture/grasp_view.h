#pragma once

/// Direction from which a grasp is seen best.

#include <vector>

#include "report/picture/hand_picture.h"

namespace thenar {

/// Limits of the eye's direction.
struct Eyes {
  Eigen::Vector3d usual;  // direction from the object towards the eye, kept if it is as good (3)
  Eigen::Vector3d up;     // upward direction of the picture, world frame (3)
  double lowest = 0;      // above the plane across `up`, of other directions than the usual [rad]
};

/// Returns the direction that shows most of the contacts, their normals and the object, as near to
/// the usual one as that leaves, in orthographic view.
///
/// A contact is seen where a ray towards the eye, from 4 mm along its normal in the object, which
/// is drawn translucent, meets neither hand nor obstacle; it counts by the sine between ray and
/// normal, so that normals are seen from the side, and 0.7 of that through the object. Of the
/// object up to 48 corners are asked. Of directions all round, at heights from -50 to 40 deg, the
/// best has the largest
///   (sum of counts / contacts) sqrt(corners seen / corners) + 0.15 cos(angle to the usual).
/// @param contacts  in the object's frame; none: the usual one
/// @returns unit, world frame (3)
[[nodiscard]] Eigen::Vector3d view_of_contacts(const HandPicture& hand, const GraspSetup& setup,
                                               const std::vector<HandContact>& contacts,
                                               const Eyes& eyes);

}  // namespace thenar
