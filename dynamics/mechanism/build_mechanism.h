#pragma once

/// Construction of mechanisms from skeletons, robots and objects.

#include <string>
#include <vector>

#include "data/io/robot/robot.h"
#include "dynamics/mechanism/mechanism.h"
#include "hand/skeleton.h"

namespace thenar {

/// Mechanism with warnings about assumed masses and inertias.
struct BuiltMechanism {
  Mechanism mechanism;
  std::vector<std::string> warnings;
};

/// Builds the mechanism of a skeleton, with one body on a hinge for each of its links. The world
/// frame and, at the reference posture, all body frames are the skeleton's base frame. Limits,
/// springs and dampers of a coordinate are those of the hinge whose name is the coordinate's.
/// @throws InputError if a segment has mass but unknown moments of inertia.
[[nodiscard]] Mechanism skeleton_mechanism(const Skeleton& skeleton);

/// Density of links of unknown mass, and of the ball that replaces a link without shapes: that of
/// water [kg/m^3].
inline constexpr double kAssumedDensity = 1000;

/// Builds the mechanism of a robot. The first link is welded to the world, the others are in the
/// order of their joints. Coordinates are the degrees of freedom that move a joint; a joint without
/// one has a coordinate of its own. An unknown mass is that of the shapes at kAssumedDensity; an
/// unknown inertia is that of the shapes, or of a ball; both cause a warning. Couplings are rigid
/// even if the robot has clutches or springs, and a gear that cannot be back-driven has no holding
/// effort; build_scene() warns of these.
/// @throws InputError if the robot has an open kinematic loop.
[[nodiscard]] BuiltMechanism robot_mechanism(const RobotSpec& robot);

/// Builds the mechanism of one object: on a free joint, or welded to the world at its pose. A free
/// body has frame M at its centre of mass, so that its velocity is that of the centre;
/// set_free_pose() sets its pose.
/// @throws InputError if a free body's mass is unknown.
[[nodiscard]] Mechanism body_mechanism(const PlacedBody& placed,
                                       const Materials& materials = built_in_materials());

}  // namespace thenar
