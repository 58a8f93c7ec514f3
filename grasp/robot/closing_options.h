#pragma once

/// Senses in which the drives of a hand may close, by what its motors and tips suggest.

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "hand/hand.h"

namespace thenar {

/// One way in which drives may close.
struct SenseOption {
  std::vector<double> speed;  // of every drive [rad/s] or [m/s]; 0: it stands still
  double against = 0;         // evidence against it from ranges of motors and nearness of tips,
                              // at most 0.6 [1]
};

/// Drives that curl a digit together.
struct DriveGroups {
  std::vector<double> orientation;  // of each drive: the sign with which its group curls together
  std::vector<int> group;           // of each drive; -1: it does not curl
  std::vector<bool> slides{};       // of each drive, whether it turns nothing: how far it goes
                                    // from 0 tells nothing of closing, as jaws begin open or
                                    // closed; empty: all turn
};

/// Finds the ways to close that are worth a try: each group that turns in the sense of its larger
/// range, each
/// in the sense that brings the tips nearer, each doubtful group reversed, and all reversed.
/// @param rest   posture from which the hand closes [rad] or [m] (coordinates)
/// @param apart  sum of distances between tips [m] with drives half-way in these senses
[[nodiscard]] std::vector<SenseOption> closing_options(
    const HandLayout& layout, const Eigen::VectorXd& rest, const DriveGroups& groups,
    const std::function<double(const std::vector<double>& senses)>& apart);

}  // namespace thenar
