#pragma once

/// Best viewing direction of a grasp.

#include <vector>

#include "report/picture/hand_picture.h"

namespace thenar {

/// Preferred viewing direction, and its limits.
struct Eyes {
  Eigen::Vector3d usual_direction;  // from the object towards the eye, kept if it is as good (3)
  Eigen::Vector3d up;               // upward direction of the picture, world frame (3)
  double min_elevation = 0;         // of directions other than `usual_direction` [rad]
};

/// Returns the direction that shows most of the contacts, their normals and the object in an
/// orthographic view, with a preference for the usual one.
///
/// A contact is visible if a ray towards the eye, from 4 mm along its normal inside the translucent
/// object, meets neither hand nor obstacle. It counts with the sine between ray and normal, so that
/// normals are seen from the side, and with 0.7 of that through the object. Up to 48 corners of the
/// object are tested. The candidates are directions all round at elevations from -50 to 40 deg; the
/// best has the largest
///   (sum of counts / contacts) sqrt(corners seen / corners) + 0.15 cos(angle to the usual).
/// @param contacts  contacts in the object's frame; without contacts the usual direction is
///         returned
/// @returns unit, world frame (3)
[[nodiscard]] Eigen::Vector3d view_of_contacts(const HandPicture& hand, const GraspSetup& setup,
                                               const std::vector<HandContact>& contacts,
                                               const Eyes& eyes);

}  // namespace thenar
