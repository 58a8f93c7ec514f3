#pragma once

/// Who makes and who bears the forces of contacts.

#include <vector>

#include <Eigen/Core>

#include "grasp/quality/wrench_set.h"
#include "hand/hand.h"

namespace thenar::internal {

/// The torques of x and p where held coordinates bear what they do not press.
struct Felt {
  Eigen::MatrixXd x;               // (coordinates, length of x)
  Eigen::MatrixXd p;               // (coordinates, length of p)
  std::vector<int> borne;          // as ForceSet
  std::vector<int> rows;           // coordinates that feel anything
  Eigen::RowVectorXd pushed_back;  // normal forces of structure less those of all others: <= 0
};

/// Splits what joints feel of contact forces between what their drives press and what held drives
/// and structure bear, as hand_forces() says.
/// @param T  torque_map()  (coordinates, length of x)
[[nodiscard]] Felt felt_by(const WrenchSet& set, const Eigen::MatrixXd& T,
                           const Reactions& reactions);

}  // namespace thenar::internal
