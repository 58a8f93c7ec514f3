#pragma once

/// Small robots for tests, with numbers that no decimal file would hold by chance.

#include <cmath>
#include <random>

#include "data/io/robot/robot.h"

namespace thenar::sample {

/// A number with all its bits in use. @param scale  its size
inline double odd_number(std::mt19937& rng, double scale) {
  return scale * (static_cast<double>(rng()) / 4294967296.0 - 0.5 + 1e-17);
}

inline Pose<double> random_pose(std::mt19937& rng) {
  const Eigen::Vector3d axis =
      Eigen::Vector3d(odd_number(rng, 1), odd_number(rng, 1), 1).normalized();
  return {rotation_about<double>(axis, odd_number(rng, 6)),
          {odd_number(rng, 1), odd_number(rng, 1e-3), odd_number(rng, 30)}};
}

inline RobotLink random_link(std::mt19937& rng, const std::string& name) {
  RobotLink link;
  link.name = name;
  link.mass = std::abs(odd_number(rng, 3));
  link.com = random_pose(rng).p;
  const Eigen::Matrix3d R = random_pose(rng).R;
  link.inertia = R * Eigen::Vector3d(2e-5, 3e-5, 4e-5).asDiagonal() * R.transpose();
  return link;
}

inline RobotJoint random_joint(std::mt19937& rng, const std::string& name, RobotJointKind kind) {
  RobotJoint joint;
  joint.name = name;
  joint.kind = kind;
  joint.X_PJ = random_pose(rng);
  joint.X_JC = random_pose(rng);
  joint.axis = random_pose(rng).R.col(1);
  joint.lower = -std::abs(odd_number(rng, 2));
  joint.upper = std::abs(odd_number(rng, 2));
  joint.damping = std::abs(odd_number(rng, 1e-9));
  joint.friction = std::abs(odd_number(rng, 1));
  joint.stiffness = std::abs(odd_number(rng, 1e5));
  joint.rest = odd_number(rng, 1);
  return joint;
}

/// Base, a coupled finger of two hinges on one motor, a slide on another, a fixed tip.
inline RobotSpec small_robot(unsigned seed = 1) {
  std::mt19937 rng(seed);
  RobotSpec robot;
  robot.name = "small \"robot\"";
  robot.description = "back\\slash\nand a second line";
  robot.source = "GraspIt, mine, its own/file.xml";
  robot.licence = "none";
  for (const char* name : {"base", "proximal", "distal", "jaw", "tip"})
    robot.links.push_back(random_link(rng, name));
  robot.links[1].digit = robot.links[2].digit = robot.links[4].digit = "finger 1";
  robot.links[3].material = "rubber";
  robot.dofs.resize(2);
  robot.dofs[0] = {"curl", DriveCoupling::kBreakaway, -0.1, 1.9, 1, 2.5, 0.5, 0, true, false, {}};
  robot.dofs[1] = {"slide", DriveCoupling::kRigid, -0.0, 0.05, -1, 80, 0, 0, true, false, {}};
  using Kind = RobotJointKind;
  robot.joints = {random_joint(rng, "J1", Kind::kRevolute),
                  random_joint(rng, "J2", Kind::kRevolute),
                  random_joint(rng, "J3", Kind::kPrismatic), random_joint(rng, "J4", Kind::kFixed)};
  const char* parents[] = {"base", "proximal", "base", "distal"};
  const char* children[] = {"proximal", "distal", "jaw", "tip"};
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    robot.joints[i].parent = parents[i];
    robot.joints[i].child = children[i];
  }
  robot.joints[0].dof = robot.joints[1].dof = "curl";
  robot.joints[1].ratio = 1.0 / 3;
  robot.joints[1].offset = odd_number(rng, 1);
  robot.joints[2].dof = "slide";
  robot.approach = {random_pose(rng).p, random_pose(rng).R.col(0)};
  robot.warnings = {"a \"spline\" was met"};
  return robot;
}

}  // namespace thenar::sample
