#include "data/io/robot/link_poses.h"

#include <set>

#include "base/error.h"

namespace thenar {

double joint_value(const RobotJoint& joint, double u) {
  // Horner's scheme.
  double bent = 0;
  for (auto c = joint.curve.rbegin(); c != joint.curve.rend(); ++c) bent = (bent + *c) * u;
  return joint.offset + (joint.ratio + bent) * u;
}

double joint_value(const RobotJoint& joint, const DofValues& dofs) {
  const auto found = joint.dof.empty() ? dofs.end() : dofs.find(joint.dof);
  return joint_value(joint, found == dofs.end() ? 0 : found->second);
}

Pose<double> joint_motion(const RobotJoint& joint, double value) {
  if (joint.kind == RobotJointKind::kRevolute)
    return {rotation_about<double>(joint.axis, value), Eigen::Vector3d::Zero()};
  if (joint.kind == RobotJointKind::kPrismatic)
    return {Eigen::Matrix3d::Identity(), value * joint.axis};
  return {};
}

std::vector<Pose<double>> link_poses(const RobotSpec& robot, const DofValues& dofs) {
  // Poses from the base outwards.
  std::map<std::string, Pose<double>> placed;
  if (!robot.links.empty()) placed[robot.links.front().name] = {};
  for (const RobotJoint& joint : robot.joints) {
    const auto parent = placed.find(joint.parent);
    require(parent != placed.end(),
            "joint '{}' appears before the one that carries its parent '{}'", joint.name,
            joint.parent);
    placed[joint.child] =
        parent->second * joint.X_PJ * joint_motion(joint, joint_value(joint, dofs)) * joint.X_JC;
  }
  // In the order of the links.
  std::vector<Pose<double>> poses;
  for (const RobotLink& link : robot.links) {
    const auto found = placed.find(link.name);
    require(found != placed.end(), "link '{}' is carried by no joint", link.name);
    poses.push_back(found->second);
  }
  return poses;
}

std::vector<std::size_t> leaf_links(const RobotSpec& robot) {
  std::set<std::string> parents;
  for (const RobotJoint& joint : robot.joints) parents.insert(joint.parent);
  std::vector<std::size_t> leaves;
  for (std::size_t i = 0; i < robot.links.size(); ++i)
    if (parents.count(robot.links[i].name) == 0) leaves.push_back(i);
  return leaves;
}

}  // namespace thenar
