#include "data/io/robot/robot.h"

namespace thenar {

std::string name_of(RobotJointKind kind) {
  switch (kind) {
    case RobotJointKind::kFixed:
      return "fixed";
    case RobotJointKind::kRevolute:
      return "revolute";
    case RobotJointKind::kPrismatic:
      break;
  }
  return "prismatic";
}

bool slides(const RobotJoint& joint) { return joint.kind == RobotJointKind::kPrismatic; }

bool slides(const RobotSpec& robot, const RobotDof& dof) {
  for (const RobotJoint& joint : robot.joints)
    if (joint.dof == dof.name) return slides(joint);
  return false;
}

}  // namespace thenar
