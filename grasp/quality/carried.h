#pragma once

/// Who makes and who bears the forces of contacts.

#include <vector>

#include <Eigen/Core>

#include "grasp/quality/wrench_set.h"
#include "hand/hand.h"

namespace thenar::internal {

/// What makes the normal force of a contact.
enum class Carrier {
  kEffort,    // efforts at joints off their stops
  kWorm,      // the drive of a held coordinate
  kStop,      // stops bear it, and efforts press it
  kStructure  // nothing presses it: it pushes back
};

/// Who carries one contact.
struct Carried {
  Carrier by = Carrier::kStructure;
  int presser = -1;        // coordinate whose effort presses what worms or stops bear; -1: none
  Eigen::Index first = 0;  // its normal force in x
  Eigen::Index size = 1;   // of its forces in x
  Eigen::VectorXd levers;  // what limits kEffort and kWorm, as hand_forces(); signed (coordinates)
};

/// What joints feel of contacts, and who carries these.
struct Felt {
  Eigen::MatrixXd x;              // (coordinates, length of x)
  Eigen::MatrixXd p;              // (coordinates, length of p)
  std::vector<int> borne;         // as ForceSet
  std::vector<int> rows;          // coordinates that feel anything
  std::vector<Carried> contacts;  // in the order of the set
};

/// Tells who carries each contact, as hand_forces() says, and splits what joints feel between what
/// efforts press and what worms, stops and structure bear.
/// @param T  torque_map()  (coordinates, length of x)
[[nodiscard]] Felt felt_by(const WrenchSet& set, const Eigen::MatrixXd& T,
                           const Reactions& reactions);

}  // namespace thenar::internal
