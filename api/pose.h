#pragma once

/// Poses of the joints, segments or links, and tips of a subject or a robot.

#include <string>
#include <variant>
#include <vector>

#include "api/named/posture.h"
#include "api/robot_pose.h"
#include "base/progress.h"
#include "hand/tip_manipulability.h"
#include "base/provenance.h"

namespace thenar {

/// Options of a question for poses: a model and its postures.
struct PoseRequest {
  std::string model;                // a subject or a robot: its name, or its file
  std::string data;                 // folder with subjects/, robots/ ..; empty: the usual ones
  std::vector<std::string> digits;  // to keep, of a subject; empty: all
  PostureRequest posture;           // joints not named are at 0
  PostureRequest frozen;            // joints of a subject that are welded there
  std::vector<Vary> vary;           // in the unit of the posture; the last one varies fastest
};

/// A joint at one posture.
struct JointNow {
  std::string name;
  double angle;           // [rad]
  Eigen::Vector3d axis;   // unit, world (3)
  Eigen::Vector3d point;  // of the axis, world [m] (3)
  std::string led_by;     // coordinate that drives a coupled joint; empty: itself
};

/// A segment at one posture.
struct SegmentNow {
  std::string name;
  Pose<double> X;            // displacement from the reference posture
  Eigen::Vector3d proximal;  // end nearer the wrist, world [m] (3)
  Eigen::Vector3d distal;    // end nearer the tip, world [m] (3)
};

/// A tip at one posture, and how it can move from there.
struct TipNow {
  std::string digit;
  Eigen::Vector3d p;                // world [m] (3)
  Eigen::Matrix3d axes;             // columns proximal, dorsal, radial, world (3, 3)
  std::vector<std::string> joints;  // free joints that move it, columns of J
  Eigen::Matrix3Xd J;               // position Jacobian, world [m/rad] (3, joints)
  TipManipulability mobility;       // not set if no joint moves the tip
};

/// A subject at one posture.
struct SubjectPose {
  Eigen::VectorXd q;  // [rad] (coordinates)
  std::vector<JointNow> joints;
  std::vector<SegmentNow> segments;
  std::vector<TipNow> tips;
};

/// A subject posture by posture, in the order of the grid; as many as were done.
struct SubjectPoses {
  std::string subject;
  std::vector<std::string> coordinates;  // names of free joints
  PostureGrid grid;                      // postures asked for
  std::vector<SubjectPose> points;
  std::vector<SourceText> sources;
  std::vector<std::string> warnings;  // of limits
};

/// Poses of a subject or of a robot, depending on the request's model.
using PoseAnswer = std::variant<SubjectPoses, RobotPoses>;

/// Poses of a subject or a robot.
/// @throws InputError for what is unknown, a subject without joints, and digits or frozen joints of
/// a robot; DataError for a wrong file.
[[nodiscard]] PoseAnswer ask_pose(const PoseRequest& request, const Progress& progress = {});

/// One posture of a subject. @param q  (coordinates) [rad]
[[nodiscard]] SubjectPose pose_of(const Subject& subject, const Skeleton& skeleton,
                                  const Eigen::VectorXd& q);

}  // namespace thenar
