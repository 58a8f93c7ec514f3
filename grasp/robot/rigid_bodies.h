#pragma once

/// Rigid bodies of a robot: groups of links without moving joints between them.

#include <map>
#include <string>
#include <vector>

#include "data/io/robot/robot.h"

namespace thenar {

/// Links without a moving joint between them.
struct RigidBody {
  std::vector<std::size_t>
      links;               // entries of RobotSpec::links; the one that a joint carries first
  std::size_t parent = 0;  // body that carries it; 0, itself, for the base
  const RobotJoint* joint = nullptr;  // joint that carries it; null: the base
  int branches = 0;                   // number of bodies on it that have, or carry, shapes
  bool shaped = false;                // whether it, or a body that it carries, has a shape
};

/// Rigid bodies of a robot, which must outlive them; the first contains the base, and parents
/// precede children.
struct RigidBodies {
  std::vector<RigidBody> bodies;
  std::map<std::string, std::size_t> body_of_link;  // body of each link, by name
};

/// Groups the links of a robot into rigid bodies.

[[nodiscard]] RigidBodies find_rigid_bodies(const RobotSpec& robot);

}  // namespace thenar
