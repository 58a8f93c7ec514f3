#pragma once

/// Rigid bodies of a robot.

#include <map>
#include <string>
#include <vector>

#include "data/io/robot/robot.h"

namespace thenar {

/// Links that nothing moves against each other.
struct RigidBody {
  std::vector<std::size_t> links;  // entries of RobotSpec::links; that which a joint carries first
  std::size_t parent = 0;          // body on which it hangs; of the base 0, itself
  const RobotJoint* joint = nullptr;  // that carries it; null: the base
  int branches = 0;                   // number of bodies with shapes, or that carry such, on it
  bool shaped = false;                // whether it, or a body that it carries, has a shape
};

/// The bodies of a robot, which must outlive them; the first holds the base, parents come before
/// children.
struct RigidBodies {
  std::vector<RigidBody> list;
  std::map<std::string, std::size_t> of;  // body of each link, by name
};

[[nodiscard]] RigidBodies find_rigid_bodies(const RobotSpec& robot);

}  // namespace thenar
