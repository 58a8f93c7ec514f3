#pragma once

/// One grasp as a page.

#include <vector>

#include "api/close.h"
#include "report/picture/hand_picture.h"

namespace thenar {

/// Returns the page of a grasp: picture, quality, measures, wrenches, contacts, joints,
/// assumptions; empty sections are left out.
[[nodiscard]] Json page_of(const GraspResult& result);
[[nodiscard]] Json page_of(const CloseResult& result);

/// Returns the picture alone: hand, object, obstacles, contacts.
[[nodiscard]] Json grasp_layers(const HandPicture& picture, const GraspSetup& setup,
                                const std::vector<HandContact>& contacts, MeshTable& meshes);

}  // namespace thenar
