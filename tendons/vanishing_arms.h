#pragma once

/// Joints at which straight runs of a path pass so close that a moment arm vanishes.

#include <string>
#include <vector>

#include "tendons/digit_tendons.h"

namespace thenar {

/// A moment arm that nearly vanishes, or changes sign, at a posture.
struct VanishingArm {
  std::string muscle, joint;
  double arm;   // here, flexion + [m/rad]
  double most;  // the largest one as this joint alone goes through its range [m/rad]
};

/// Returns arms of long flexors about flexion joints below a quarter of the largest arm that they
/// have as the joint alone goes through its range, if that is at least 3 mm: sheaths hold these
/// tendons off the joint. A rule of thumb. Wrapped paths have such arms, too, where the subject has
/// no surface at the joint; joints without a range are left out.
/// @param tendons  without a net
[[nodiscard]] std::vector<VanishingArm> vanishing_arms(const DigitTendons& tendons,
                                                       const Eigen::VectorXd& q);

}  // namespace thenar
