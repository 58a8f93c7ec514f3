#pragma once

/// A mechanism prepared for recursions: welded bodies are one link, masses stand at joints.

#include <vector>

#include <Eigen/Core>

#include "dynamics/mechanism/mechanism.h"

namespace thenar {

/// A link: a body with all that is welded to it, on one joint with motion.
struct TreeLink {
  JointKind kind = JointKind::kHinge;
  int parent = -1;                                    // link; -1: the world
  int q = 0, v = 0;                                   // where the joint's entries begin
  bool shares = false;                                // its coordinate moves other links, too
  Pose<double> X_PF;                                  // the joint's F in the parent link's M
  MechanismJoint joint;                               // value of hinges and slides, resistance
  double mass = 0;                                    // [kg]
  Eigen::Vector3d moment{0, 0, 0};                    // mass times its centre, in M [kg m] (3)
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about the origin of M [kg m^2] (3, 3)
};

/// Pose of a body in its link.
struct BodyInLink {
  int link = -1;      // -1: welded to the world
  Pose<double> X_LB;  // the body in the link's M, or in the world
};

/// All links, constant once built.
struct TreeModel {
  std::vector<TreeLink> links;               // by depth, so parents before children
  std::vector<BodyInLink> bodies;            // of the mechanism
  std::vector<std::vector<int>> coupled_to;  // of each speed, the lower ones with which it may have
                                             // an entry in the factor of the mass matrix
  MechanismLayout layout;
  bool has_couplings = false;  // some coordinate moves more than one link
};

/// @throws InputError as check_mechanism(), or if a joint moves nothing that has mass.
[[nodiscard]] TreeModel tree_model(const Mechanism& mechanism);

}  // namespace thenar
