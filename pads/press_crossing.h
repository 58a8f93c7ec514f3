#pragma once

/// Detection of solutions in which object and tissue have passed through each other.

#include <string>

#include <Eigen/Core>

#include "pads/press_iterate.h"

namespace thenar {

/// Returns a description of where object and tissue have passed through each other in this step; ""
/// if nowhere. Hanging nodes of the surface may penetrate the object slightly, like points between
/// nodes.
/// @param u  displacements of all nodes [m] (3, nodes)
[[nodiscard]] std::string describe_crossing(const PressIterate& iterate, const Eigen::Matrix3Xd& u);

}  // namespace thenar
