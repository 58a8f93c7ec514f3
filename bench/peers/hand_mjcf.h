#pragma once

/// A skeleton with its tendons as a MuJoCo model.

#include <string>

#include "hand/skeleton.h"
#include "tendons/wrapping/wrapped_path.h"

namespace thenar::bench {

/// MJCF text: every link a body whose frame is the world's at the reference posture, every path a
/// spatial tendon of the same name through sites and round geoms, in the order of the set. Bodies
/// weigh 1 kg: nothing moves here. Origins that ride stay fixed.
/// @throws InputError for surfaces other than spheres and cylinders, which MuJoCo cannot wrap, and
/// for two surfaces between two points.
[[nodiscard]] std::string hand_mjcf(const Tree<double>& tree, const PathSet& set);

}  // namespace thenar::bench
