#pragma once

/// Tendons of a hand in a world, drawn as lines.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "hand/hand.h"
#include "live/strand_paths.h"

namespace thenar {

/// Path of one strand of a digit.
struct HandTendon {
  std::string name;             // name of the strand
  std::string digit;            // name of the digit
  std::size_t digit_index = 0;  // entry of TendonHand::digits()
  TendonPath<double> nodes;     // nodes of StrandPath
};

/// Returns strand_paths() of all digits of a tendon-driven hand; empty for other hands.
[[nodiscard]] std::vector<HandTendon> hand_tendons(const Hand& hand);

/// Computes the points of all lines in a posture, line after line, in the hand's frame [m].
/// @param q  posture (coordinates)
[[nodiscard]] std::vector<Eigen::Vector3d> tendon_points(const Hand& hand,
                                                         const std::vector<HandTendon>& tendons,
                                                         const Eigen::VectorXd& q);

}  // namespace thenar
