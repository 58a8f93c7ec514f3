#pragma once

/// Who makes and who bears the forces of contacts.

#include <vector>

#include <Eigen/Core>

#include "grasp/contact/wrench_set.h"
#include "grasp/limits/force_set.h"
#include "hand/hand.h"

namespace thenar::internal {

/// What makes the normal force of a contact.
enum class SupportKind {
  kEffort,           // efforts at joints off their stops
  kNonBackdrivable,  // the drive of a held coordinate
  kJointLimit,       // stops bear it, and efforts press it
  kStructure         // nothing presses it: it pushes back
};

/// Who carries one contact.
struct ContactSupport {
  SupportKind by = SupportKind::kStructure;
  int pressing_coordinate =
      -1;                  // coordinate whose effort presses what worms or stops bear; -1: none
  Eigen::Index first = 0;  // its normal force in x
  Eigen::Index size = 1;   // of its forces in x
  Eigen::VectorXd
      levers;  // what limits kEffort and kNonBackdrivable, as hand_forces(); signed (coordinates)
};

/// What joints feel of contacts, and who carries these.
struct JointLoads {
  Eigen::MatrixXd x;                     // (coordinates, length of x)
  Eigen::MatrixXd p;                     // (coordinates, length of p)
  std::vector<int> passive_contacts;     // as ForceSet
  std::vector<int> rows;                 // coordinates that feel anything
  std::vector<ContactSupport> contacts;  // in the order of the set
};

/// Tells who carries each contact, as hand_forces() says, and splits what joints feel between what
/// efforts press and what worms, stops and structure bear.
/// @param T  torque_map()  (coordinates, length of x)
[[nodiscard]] JointLoads find_contact_support(const WrenchSet& set, const Eigen::MatrixXd& T,
                                              const Reactions& reactions);

// No squeeze without effort: what limits the forces of contacts that stops and structure bear.

/// Adds variables s and the limits of hand_forces() on what stops and structure push back.
/// @param forces  of (x, p, v, r), torques in balance
[[nodiscard]] ForceSet limit_preload(ForceSet forces, const JointLoads& joint_loads,
                                     const Actuation& actuation);

}  // namespace thenar::internal
