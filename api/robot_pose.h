#pragma once

/// Poses of the joints, links and tips of a robot.

#include <map>
#include <string>
#include <vector>

#include "api/pose_request.h"
#include "base/progress.h"
#include "data/io/robot/robot.h"
#include "solvers/status.h"

namespace thenar {

/// A joint that moves, at one posture.
struct RobotJointNow {
  std::string name;
  std::string dof;  // degree of freedom that drives it; empty: none
  bool slides = false;
  double value = 0;       // [rad] or [m]
  Eigen::Vector3d axis;   // unit, in the base link (3)
  Eigen::Vector3d point;  // point on the axis, in the base link [m] (3)
};

/// A link at one posture.
struct RobotLinkNow {
  std::string name;
  int parent;         // link that carries it, as an index; -1: none
  Pose<double> X_BL;  // pose of its frame in the base link
};

/// A tip at one posture.
struct RobotTipNow {
  std::string digit;
  std::string link;
  Eigen::Vector3d p;  // position in the base link [m] (3)
};

/// A robot at one posture.
struct RobotPose {
  std::vector<double> varied;         // values of what varies [rad] or [m]
  std::vector<RobotJointNow> joints;  // joints that move
  std::vector<RobotLinkNow> links;
  std::vector<RobotTipNow> tips;
  std::vector<std::string> warnings;  // values outside limits
};

/// A degree of freedom or a joint that varies.
struct VariedDrive {
  std::string name;
  bool slides = false;
};

/// A robot posture by posture; as many as were done.
struct RobotPoses {
  PoseRequest request;
  Outcome outcome;  // warnings: values outside limits, of all postures
  std::string robot;
  std::vector<VariedDrive> varied;  // the last one varies fastest; empty: one posture
  std::size_t row = 1;              // postures that differ in the last one only
  std::vector<RobotPose> points;
  FileDigests files = {};  // digests of the robot's files
};

/// Computes the poses of a robot's joints, links and tips. Tips are those of find_tips(); digits
/// that no file states are those of infer_digits().
/// @param request  its posture is of degrees of freedom or joints by name, or of all degrees of
///                 freedom in order [rad], of slides [m], or as typed [deg], [mm]; what is left out
///                 stands at 0. What varies is in the same unit, by the same names
/// @throws InputError for an unknown name, a wrong count, a joint that nothing drives, one that
/// stands in two ways, or steps that do not lead to their end
[[nodiscard]] RobotPoses pose_robot(const RobotSpec& robot, const PoseRequest& request,
                                    const Progress& progress = {});

}  // namespace thenar
