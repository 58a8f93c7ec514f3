#pragma once

/// From where contacts are best seen.

#include <vector>

#include "grasp/contact/contact.h"
#include "viewer/hand_picture.h"

namespace thenar {

/// The direction, from the grasp towards the eye, from which most contacts are seen past the links
/// of the hand, in orthographic view; of nearly equal ones that nearest `usual`. Tried are 10
/// directions around the back of the hand at each of four heights, and `usual` itself. A contact is
/// seen if the ray from a point `inside` the object, along the contact's normal, meets no link; the
/// object is seen through, at a discount. Of many contacts 12 are asked.
/// @param contacts  world frame
/// @param inside    [m]
/// @param usual     world frame (3)
/// @return unit, world frame (3)
[[nodiscard]] Eigen::Vector3d clear_view(const HandPicture& picture,
                                         const std::vector<Contact>& contacts, double inside,
                                         const Eigen::Vector3d& usual);

}  // namespace thenar
