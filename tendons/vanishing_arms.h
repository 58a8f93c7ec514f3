#pragma once

/// Joints at which a path passes so close that a moment arm vanishes, or on the wrong side.

#include <string>
#include <vector>

#include "tendons/digit_tendons.h"

namespace thenar {

/// A moment arm of a long flexor that nearly vanishes at a posture.
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

/// A moment arm whose sign is against what the subject's arms_mm or the muscle's name says.
struct ReversedArm {
  std::string muscle, joint;
  double arm;  // here [m/rad]
};

/// Returns arms of the wrong sign by TendonDigit::actions and at least 0.5 mm, so that a tendon
/// that runs across its joint is not told.
/// @param R  moment arms at one posture (muscles, coordinates) [m/rad]
[[nodiscard]] std::vector<ReversedArm> reversed_arms(const TendonDigit& digit,
                                                     const Eigen::MatrixXd& R);

}  // namespace thenar
