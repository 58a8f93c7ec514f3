#pragma once

/// Mechanisms of human hands, robots and objects.

#include <optional>
#include <string>
#include <vector>

#include "data/io/robot/robot.h"
#include "dynamics/mechanism/mechanism.h"
#include "hand/skeleton.h"

namespace thenar {

/// A mechanism, with what had to be assumed for it.
struct BuiltMechanism {
  Mechanism mechanism;
  std::vector<std::string> warnings;
};

/// A skeleton on hinges. Its world is the base at the reference posture, and so is every body's
/// frame there: body i is link i. Coordinates and their limits, springs and dampers are the
/// skeleton's; they stand at the hinge that turns by the coordinate itself.
/// @throws InputError if a segment has mass but unknown moments of inertia.
[[nodiscard]] Mechanism skeleton_mechanism(const Skeleton& skeleton);

/// Density of a link whose mass nobody states, and of the ball that stands in for a link without
/// shapes: that of water [kg/m^3].
inline constexpr double kAssumedDensity = 1000;

/// A robot; the first link is welded to the world, the others stand in the order of their joints.
/// Coordinates are its degrees of freedom, and a free joint has one of its own; a degree of freedom
/// that moves nothing is left out. A link whose mass is unknown weighs its shapes at
/// kAssumedDensity; unknown inertia is that of the shapes, or of a ball. Both are warned of.
/// Couplings are rigid, also where the robot has clutches or springs, and a gear that cannot be
/// driven back holds nothing by itself: build_scene() warns of these.
/// @throws InputError if a loop of the robot is unsolved.
[[nodiscard]] BuiltMechanism robot_mechanism(const RobotSpec& robot);

/// One body of a world: free, or welded where it stands. Free bodies have frame M at the centre of
/// mass, so that their speeds are those of the centre; where they stand is a position, for
/// set_free_pose().
/// @throws InputError if a free body's mass is unknown.
[[nodiscard]] Mechanism body_mechanism(const PlacedBody& placed,
                                       const Materials& materials = built_in_materials());

}  // namespace thenar
