#pragma once

/// From where a grasp is seen best.

#include "grasp/contact/contact.h"
#include "grasp/gaps.h"
#include "grasp/scene.h"

namespace thenar {

/// The direction that shows most of the contacts' normals, as near to a given one as that leaves.
///
/// A contact is seen where a ray towards the eye, from 5 mm along its normal in the object, which
/// is drawn translucent, meets neither hand nor obstacle; it counts by the sine between ray and
/// normal, so that normals are seen from the side. Of directions all round, 10 to 40 deg above the
/// horizon, and the given one, the best has the largest
///   sum of sines / contacts + 0.15 cos(angle to the given).
/// @param contacts  in the object's frame
/// @param from      direction from the scene towards the eye, world frame (3)
/// @returns unit (3)
[[nodiscard]] Eigen::Vector3d view_of_contacts(const PosedHand& posed, const Scene& scene,
                                               const std::vector<HandContact>& contacts,
                                               const Eigen::Vector3d& from);

}  // namespace thenar
