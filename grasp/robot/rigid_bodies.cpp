#include "grasp/robot/rigid_bodies.h"

namespace thenar {

RigidBodies find_rigid_bodies(const RobotSpec& robot) {
  RigidBodies bodies;
  bodies.list.resize(1);
  bodies.of[robot.links.front().name] = 0;
  // A fixed joint joins its links to one body.
  for (const RobotJoint& joint : robot.joints) {
    const std::size_t on = bodies.of[joint.parent];
    const bool moves = joint.kind != RobotJointKind::kFixed;
    bodies.of[joint.child] = moves ? bodies.list.size() : on;
    if (moves) bodies.list.push_back({{}, on, &joint, 0, false});
  }
  const auto holds = [&](std::size_t link) -> RigidBody& {
    return bodies.list[bodies.of[robot.links[link].name]];
  };
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    RigidBody& body = holds(i);
    const bool carried = body.joint != nullptr && body.joint->child == robot.links[i].name;
    body.links.insert(carried ? body.links.begin() : body.links.end(), i);
    body.shaped = body.shaped || !robot.links[i].shapes.empty();
  }
  // From the leaves inwards: shapes and branches.
  for (std::size_t b = bodies.list.size(); b-- > 1;) {
    if (!bodies.list[b].shaped) continue;
    RigidBody& parent = bodies.list[bodies.list[b].parent];
    parent.shaped = true;
    ++parent.branches;
  }
  return bodies;
}

}  // namespace thenar
