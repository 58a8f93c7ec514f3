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

}  // namespace thenar
