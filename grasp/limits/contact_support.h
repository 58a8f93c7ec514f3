#pragma once

/// Splits contact forces into active ones, which actuators press, and passive ones, which joints,
/// stops and structure support. Letters x, p, v, r, s as in ForceSet: active and passive forces,
/// efforts, reactions, push of joint limits.

#include <vector>

#include <Eigen/Core>

#include "grasp/contact/wrench_set.h"
#include "grasp/limits/force_set.h"
#include "hand/hand.h"

namespace thenar::internal {

/// Source of the normal force of a contact.
enum class SupportKind {
  kEffort,           // efforts at joints off their limits
  kNonBackdrivable,  // the drive of a non-backdrivable coordinate
  kJointLimit,       // a joint limit supports the contact, and efforts press against it
  kStructure         // rigid structure: nothing presses, it pushes back
};

/// Support of one contact.
struct ContactSupport {
  SupportKind by = SupportKind::kStructure;
  int pressing_coordinate = -1;  // presses a non-backdrivable or joint-limit contact; or -1
  Eigen::Index first = 0;        // its normal force in x
  Eigen::Index size = 1;         // of its forces in x
  Eigen::VectorXd levers;        // l of hand_forces() with the sign of T_jn, about coordinates that
                                 // press the contact; 0 elsewhere [m] (coordinates)
};

/// Joint torques of unit contact forces, and how each contact is supported.
struct JointLoads {
  Eigen::MatrixXd x;                     // torque per active force [m] (coordinates, length of x)
  Eigen::MatrixXd p;                     // torque per passive force [m] (coordinates, length of p)
  std::vector<int> passive_contacts;     // as ForceSet
  std::vector<int> rows;                 // coordinates that feel a contact
  std::vector<ContactSupport> contacts;  // in the order of the set
};

/// Finds how each contact is supported, by the rules of hand_forces(), and splits the joint torques
/// between active forces and those that non-backdrivable drives, joint limits and structure
/// support.
/// @param T  torque_map()  (coordinates, length of x) [m]
[[nodiscard]] JointLoads find_contact_support(const WrenchSet& set, const Eigen::MatrixXd& T,
                                              const Reactions& reactions);

/// Limits the preload that joint limits and structure can give: it never exceeds what actuators
/// press. Adds variables s and the limits of hand_forces() on what joint limits and structure push
/// back.
/// @param forces  set of (x, p, v, r), torques in balance
/// @param preload_slack  as of hand_forces()
[[nodiscard]] ForceSet limit_preload(ForceSet forces, const JointLoads& joint_loads,
                                     const Actuation& actuation, double preload_slack);

}  // namespace thenar::internal
