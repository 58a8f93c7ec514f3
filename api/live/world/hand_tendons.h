#pragma once

/// Tendons of a hand in a world, as lines to look at.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "hand/hand.h"
#include "tendons/path.h"

namespace thenar {

/// Most points of a line, so that a frame stays small.
inline constexpr int kLinePoints = 8;

/// The path of one strand of a digit, from its end on the bone towards the muscle.
struct HandTendon {
  std::string name;  // of the strand
  std::string digit;
  std::size_t of = 0;        // entry of TendonHand::digits()
  TendonPath<double> nodes;  // 2 to kLinePoints of its via points, links of the digit's own tree
};

/// Tendons of a hand that tendons move, none of others. The muscle's way up the forearm ends at the
/// first point that no joint of the digit moves. Strands without a path are left out; on the rungs
/// `fitted` and `wrapped` lines run straight through via points, too.
[[nodiscard]] std::vector<HandTendon> hand_tendons(const Hand& hand);

/// Points of all lines in a posture, one line after the other, in the hand's frame [m].
/// @param q  (coordinates)
[[nodiscard]] std::vector<Eigen::Vector3d> tendon_points(const Hand& hand,
                                                         const std::vector<HandTendon>& tendons,
                                                         const Eigen::VectorXd& q);

}  // namespace thenar
