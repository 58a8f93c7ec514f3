#pragma once

/// Mechanism prepared for the recursions of multibody dynamics: welded bodies merged into links.

#include <vector>

#include <Eigen/Core>

#include "dynamics/mechanism/mechanism.h"

namespace thenar {

/// Link: a body with all bodies welded to it, on one movable joint.
struct TreeLink {
  JointKind kind = JointKind::kHinge;
  int parent = -1;                  // parent link; -1: the world
  int first_q = 0, first_v = 0;     // first entries of the joint in q and v
  bool shares_coordinate = false;   // its coordinate also moves other links
  Pose<double> X_PF;                // frame F in the parent link's frame M
  MechanismJoint joint;             // joint of the mechanism
  double mass = 0;                  // mass [kg]
  Eigen::Vector3d moment{0, 0, 0};  // mass times centre of mass, in M [kg m] (3)
  Eigen::Matrix3d inertia =
      Eigen::Matrix3d::Zero();  // inertia about the origin of M [kg m^2] (3, 3)
};

/// Pose of a body in its link.
struct BodyInLink {
  int link = -1;      // link; -1: welded to the world
  Pose<double> X_LB;  // pose of the body in the link's frame M, or in the world
};

/// Links of a mechanism; constant after construction.
struct TreeModel {
  std::vector<TreeLink> links;               // sorted by depth: parents precede children
  std::vector<BodyInLink> bodies;            // bodies of the mechanism
  std::vector<std::vector<int>> coupled_to;  // lower velocities with which each velocity may have
                                             // an entry in the factor of the mass matrix (v)
  MechanismLayout layout;
  bool has_couplings = false;  // a coordinate moves more than one link
};

/// Builds the tree model of a mechanism.
/// @throws InputError as check_mechanism(), or if a joint moves no mass.
[[nodiscard]] TreeModel tree_model(const Mechanism& mechanism);

}  // namespace thenar
