#pragma once

/// Classification of contact forces into active ones, which actuators press, and passive ones,
/// which joints, stops and structure support. Letters x, p, v, r, s as in ForceSet: active and
/// passive forces, efforts, reactions, forces of joint limits.

#include <vector>

#include <Eigen/Core>

#include "grasp/contact/wrench_set.h"
#include "grasp/limits/force_set.h"
#include "hand/hand.h"

namespace thenar::internal {

/// Source of the normal force of a contact.
enum class SupportKind {
  kEffort,           // efforts at joints away from their limits
  kNonBackdrivable,  // the drive of a non-backdrivable coordinate
  kJointLimit,       // a joint limit, against which efforts press
  kStructure         // rigid structure: nothing presses it, it only pushes back
};

/// Support of one contact.
struct ContactSupport {
  SupportKind kind = SupportKind::kStructure;
  /// Coordinate that presses a non-backdrivable or joint-limit contact; or -1.
  int pressing_coordinate = -1;
  Eigen::Index first = 0;  // entry of its normal force in x
  Eigen::Index size = 1;   // number of its forces in x
  Eigen::VectorXd levers;  // l of hand_forces() with the sign of T_jn, for coordinates that press
                           // the contact; 0 for others [m] (coordinates)
};

/// Joint torques of unit contact forces, and the support of each contact.
struct JointLoads {
  Eigen::MatrixXd x;                     // torque per active force [m] (coordinates, length of x)
  Eigen::MatrixXd p;                     // torque per passive force [m] (coordinates, length of p)
  std::vector<int> passive_contacts;     // contact of each passive force, as in ForceSet
  std::vector<int> rows;                 // coordinates that carry contact forces
  std::vector<ContactSupport> contacts;  // support of each contact, in the order of the set
};

/// Finds the support of each contact by the rules of hand_forces(), and splits the joint torques
/// between active forces and those that non-backdrivable drives, joint limits and structure
/// support.
/// @param T  torque_map()  (coordinates, length of x) [m]
[[nodiscard]] JointLoads find_contact_support(const WrenchSet& set, const Eigen::MatrixXd& T,
                                              const Reactions& reactions);

/// Limits the preload that joint limits and structure can give to what actuators press: adds
/// variables s and the limits of hand_forces() on what joint limits and structure push back.
/// @param forces  set of (x, p, v, r), with balanced torques
/// @param preload_slack  parameter of hand_forces() [1]
[[nodiscard]] ForceSet limit_preload(ForceSet forces, const JointLoads& joint_loads,
                                     const Actuation& actuation, double preload_slack);

}  // namespace thenar::internal
