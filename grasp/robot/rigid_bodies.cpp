#include "grasp/robot/rigid_bodies.h"

namespace thenar {

RigidBodies find_rigid_bodies(const RobotSpec& robot) {
  RigidBodies bodies;
  bodies.bodies.resize(1);
  bodies.body_of_link[robot.links.front().name] = 0;
  // Links that a fixed joint connects form one body.
  for (const RobotJoint& joint : robot.joints) {
    const std::size_t parent = bodies.body_of_link[joint.parent];
    const bool moves = joint.kind != RobotJointKind::kFixed;
    bodies.body_of_link[joint.child] = moves ? bodies.bodies.size() : parent;
    if (moves) bodies.bodies.push_back({{}, parent, &joint, 0, false});
  }
  // Links of each body, the one that its joint carries first.
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    RigidBody& body = bodies.bodies[bodies.body_of_link[robot.links[i].name]];
    const bool carried = body.joint != nullptr && body.joint->child == robot.links[i].name;
    body.links.insert(carried ? body.links.begin() : body.links.end(), i);
    body.shaped = body.shaped || !robot.links[i].shapes.empty();
  }
  // Count shapes and branches from the leaves inwards.
  for (std::size_t b = bodies.bodies.size(); b-- > 1;) {
    if (!bodies.bodies[b].shaped) continue;
    RigidBody& parent = bodies.bodies[bodies.bodies[b].parent];
    parent.shaped = true;
    ++parent.branches;
  }
  return bodies;
}

}  // namespace thenar
