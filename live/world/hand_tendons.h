#pragma once

/// Tendons of a hand in a world, as lines to look at.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "hand/hand.h"
#include "live/strand_paths.h"

namespace thenar {

/// The path of one strand of a digit.
struct HandTendon {
  std::string name;  // of the strand
  std::string digit;
  std::size_t of = 0;        // entry of TendonHand::digits()
  TendonPath<double> nodes;  // as StrandPath::nodes
};

/// Tendons of a hand that tendons move, none of others: strand_paths() of its digits.
[[nodiscard]] std::vector<HandTendon> hand_tendons(const Hand& hand);

/// Points of all lines in a posture, one line after the other, in the hand's frame [m].
/// @param q  (coordinates)
[[nodiscard]] std::vector<Eigen::Vector3d> tendon_points(const Hand& hand,
                                                         const std::vector<HandTendon>& tendons,
                                                         const Eigen::VectorXd& q);

}  // namespace thenar
