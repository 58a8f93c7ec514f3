#include "grasp/robot/robot_tips.h"

#include <map>

#include "base/lists.h"
#include "geometry/solid.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// Origin of the moving joint that carries a link, in the base link [m] (3)
Vector3d joint_origin(const RobotSpec& robot, const std::vector<Pose<double>>& reference,
                      std::string link) {
  // Joints come parents first: walk back until a moving one carries the link.
  for (auto joint = robot.joints.rbegin(); joint != robot.joints.rend(); ++joint) {
    if (joint->child != link) continue;
    link = joint->parent;
    if (joint->kind == RobotJointKind::kFixed) continue;
    return reference[place_named(robot.links, link)] * joint->X_PJ.p;
  }
  return {0, 0, 0};
}

/// Centre of the face of the box that is farthest in the direction from a joint to the centre.
Vector3d far_end(const Eigen::AlignedBox3d& box, const Vector3d& joint) {
  Vector3d end = box.center();
  const Vector3d way = end - joint;
  Eigen::Index along = 0;
  way.cwiseAbs().maxCoeff(&along);
  end[along] = way[along] < 0 ? box.min()[along] : box.max()[along];
  return end;
}

/// Number of joints between each link and the base.
std::map<std::string, int> depths(const RobotSpec& robot) {
  std::map<std::string, int> depth;
  for (const RobotJoint& joint : robot.joints) depth[joint.child] = depth[joint.parent] + 1;
  return depth;
}

}  // namespace

std::vector<RobotTip> find_tips(const RobotSpec& robot,
                                const std::vector<Pose<double>>& reference) {
  std::map<std::string, int> depth = depths(robot);
  std::vector<RobotTip> tips;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const RobotLink& link = robot.links[i];
    if (link.digit.empty()) continue;
    // Outermost link of each digit.
    RobotTip* tip = nullptr;
    for (RobotTip& other : tips)
      if (other.digit == link.digit) tip = &other;
    if (tip == nullptr) tip = &tips.emplace_back(RobotTip{link.digit, static_cast<int>(i), {}});
    if (depth[link.name] > depth[robot.links[tip->link].name]) tip->link = static_cast<int>(i);
  }
  for (RobotTip& tip : tips) {
    // Far end of its shapes, or the origin of a link without shapes.
    const auto i = static_cast<std::size_t>(tip.link);
    const RobotLink& link = robot.links[i];
    const Vector3d end =
        link.shapes.empty()
            ? Vector3d(0, 0, 0)
            : far_end(build_solid(link.shapes).shape->bounds(),
                      reference[i].inverse() * joint_origin(robot, reference, link.name));
    tip.p = reference[i] * end;
  }
  return tips;
}

}  // namespace thenar
