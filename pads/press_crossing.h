#pragma once

/// Finds answers of a press in which object and tissue have gone through each other.

#include <string>

#include <Eigen/Core>

#include "pads/press_iterate.h"

namespace thenar {

/// Describes how the object came through skin, or skin through the object, since the step began; ""
/// if all is well. Hanging nodes of the surface may be inside a little, as all between nodes.
/// @param u  displacements of all nodes [m] (3, nodes)
[[nodiscard]] std::string describe_crossing(const PressIterate& iterate, const Eigen::Matrix3Xd& u);

}  // namespace thenar
