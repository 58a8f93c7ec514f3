#pragma once

/// Directions in which the drives of a hand may close, suggested by its motors and tips.

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "hand/hand.h"

namespace thenar {

/// One combination of closing directions of the drives.
struct SenseOption {
  std::vector<double> speed;  // speed of every drive [rad/s] or [m/s]; 0: it does not move
  double penalty = 0;  // evidence against it from motor ranges and distances of tips, <= 0.6 [1]
};

/// Groups of drives that curl a digit together.
struct DriveGroups {
  std::vector<double> orientation;  // sign with which each drive curls in its group (drives)
  std::vector<int> group;           // group of each drive; -1: it does not curl (drives)
  std::vector<bool> slides{};  // whether each drive only translates, so that its zero says nothing
                               // about closing (jaws start open or closed); empty: all rotate
};

/// Finds the combinations of closing directions that are worth a trial: each group in the direction
/// of its larger range, each in the direction that brings the tips nearer, each doubtful group
/// reversed, and all reversed.
/// @param rest        posture from which the hand closes [rad] or [m] (coordinates)
/// @param separation  sum of distances between tips [m] with drives half-way in given directions
[[nodiscard]] std::vector<SenseOption> closing_options(
    const HandLayout& layout, const Eigen::VectorXd& rest, const DriveGroups& groups,
    const std::function<double(const std::vector<double>& senses)>& separation);

}  // namespace thenar
