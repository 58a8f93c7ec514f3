#pragma once

/// The answer of `thenar pose`.

#include <string>
#include <vector>

#include "data/io/subject.h"
#include "hand/skeleton.h"
#include "hand/tip_manipulability.h"

namespace thenar {

struct JointNow {
  std::string name;
  double angle;           // [rad]
  Eigen::Vector3d axis;   // unit, world (3)
  Eigen::Vector3d point;  // of the axis, world [m] (3)
  std::string led_by;     // coordinate that drives a coupled joint; empty: itself
};

struct SegmentNow {
  std::string name;
  Pose<double> X;            // displacement from the reference posture
  Eigen::Vector3d proximal;  // end nearer the wrist, world [m] (3)
  Eigen::Vector3d distal;    // end nearer the tip, world [m] (3)
};

struct TipNow {
  std::string digit;
  Eigen::Vector3d p;                // world [m] (3)
  Eigen::Matrix3d axes;             // columns proximal, dorsal, radial, world (3, 3)
  std::vector<std::string> joints;  // free joints that move it, columns of J
  Eigen::Matrix3Xd J;               // position Jacobian, world [m/rad] (3, joints)
  TipManipulability mobility;       // not set if no joint moves the tip
};

struct PoseReport {
  std::string subject;
  std::vector<JointNow> joints;
  std::vector<SegmentNow> segments;
  std::vector<TipNow> tips;
};

/// @param q  (coordinates) [rad]
[[nodiscard]] PoseReport pose_report(const Subject& subject, const Skeleton& skeleton,
                                     const Eigen::VectorXd& q);

/// How a tip can move, in words: "moves any way, at best 3.2 times easier than at worst".
[[nodiscard]] std::string mobility_in_words(const TipNow& tip);

void print_text(const PoseReport& report);
void print_json(const PoseReport& report);

}  // namespace thenar
