#pragma once

/// Poses of the joints, segments or links, and tips of a subject or a robot.
///
///     PoseRequest request;
///     request.model = "an_chao_index";
///     request.posture.named = {{"PIP2", 0.5}};
///     const auto poses = std::get<SubjectPoses>(compute_poses(request));

#include <string>
#include <variant>
#include <vector>

#include "api/pose_request.h"
#include "api/robot_pose.h"
#include "base/progress.h"
#include "base/provenance.h"
#include "hand/tip_manipulability.h"

namespace thenar {

/// Joint at one posture.
struct JointPose {
  std::string name;       // as in the subject's file
  double angle;           // [rad]
  Eigen::Vector3d axis;   // unit, world (3)
  Eigen::Vector3d point;  // point on the axis, world [m] (3)
  std::string led_by;     // coordinate that drives a coupled joint; empty: itself
};

/// Segment at one posture.
struct SegmentPose {
  std::string name;          // as in the subject's file
  Pose<double> X;            // displacement from the reference posture
  Eigen::Vector3d proximal;  // end nearer the wrist, world [m] (3)
  Eigen::Vector3d distal;    // end nearer the tip, world [m] (3)
};

/// Tip at one posture, with its Jacobian and manipulability.
struct TipPose {
  std::string digit;                // name of the digit
  Eigen::Vector3d p;                // world [m] (3)
  Eigen::Matrix3d axes;             // columns proximal, dorsal, radial, world (3, 3)
  std::vector<std::string> joints;  // free joints that move it, columns of J
  Eigen::Matrix3Xd J;               // position Jacobian, world [m/rad] (3, joints)
  TipManipulability mobility;       // empty if no joint moves the tip
};

/// Subject at one posture.
struct SubjectPose {
  Eigen::VectorXd q;                  // [rad] (coordinates)
  std::vector<JointPose> joints;      // joints that turn, coupled ones too
  std::vector<SegmentPose> segments;  // segments of the chosen digits
  std::vector<TipPose> tips;          // tips of the chosen digits
};

/// Poses of a subject, posture by posture, in the order of the grid; fewer if stopped.
struct SubjectPoses {
  PoseRequest request;                   // request that was answered
  Outcome outcome;                       // warnings: angles outside limits
  std::string subject;                   // name of the subject
  std::vector<std::string> coordinates;  // names of free joints
  PostureGrid grid;                      // requested postures
  std::vector<SubjectPose> points;       // one pose for each posture
  std::vector<SourceText> sources;       // text of the subject
};

/// Poses of a subject or of a robot, depending on the request's model.
using PoseResult = std::variant<SubjectPoses, RobotPoses>;

/// Computes the poses of a subject or a robot.
/// @throws InputError for unknown names, a subject without joints, and digits or frozen joints of a
/// robot; DataError for a wrong file.
[[nodiscard]] PoseResult compute_poses(const PoseRequest& request, const Progress& progress = {});

/// Computes the pose of a subject at one posture. @param q  [rad] (coordinates)
[[nodiscard]] SubjectPose pose_of(const Subject& subject, const Skeleton& skeleton,
                                  const Eigen::VectorXd& q);

}  // namespace thenar
