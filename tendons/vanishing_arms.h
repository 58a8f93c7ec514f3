#pragma once

/// Where straight runs between the points of a path cut through a joint.

#include <string>
#include <vector>

#include "tendons/digit_tendons.h"

namespace thenar {

/// An arm that all but vanishes, or turns over, at a posture.
struct VanishingArm {
  std::string muscle, joint;
  double arm;   // here, flexion + [m/rad]
  double most;  // the largest one as this joint alone goes through its range [m/rad]
};

/// Arms of long flexors about flexion joints that are below a quarter of the largest which they
/// have as the joint alone goes through its range, that being 3 mm at least: their sheaths hold
/// them off the joint. A rule of thumb. Wrapped paths have such arms too where the subject has no
/// surface at the joint; joints without a range have nothing to be compared with.
/// @param tendons  without a net
[[nodiscard]] std::vector<VanishingArm> vanishing_arms(const DigitTendons& tendons,
                                                       const Eigen::VectorXd& q);

}  // namespace thenar
