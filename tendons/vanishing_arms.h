#pragma once

/// Detects joints at which a path passes so close that a moment arm vanishes, or on the wrong side.

#include <string>
#include <vector>

#include "tendons/digit_tendons.h"

namespace thenar {

/// Moment arm of a long flexor that nearly vanishes at a posture.
struct VanishingArm {
  std::string muscle, joint;
  double arm = 0;      // moment arm at this posture, flexion positive [m/rad]
  double max_arm = 0;  // largest arm as this joint alone moves through its range [m/rad]
};

/// Returns the arms of long flexors about flexion joints that are below a quarter of the largest
/// arm as the joint alone moves through its range, if that is at least 3 mm, since sheaths hold
/// these tendons off the joint. A rule of thumb. Wrapped paths also have such arms where the
/// subject has no surface at the joint. Joints without a range are left out.
/// @param tendons  tendons without a net
[[nodiscard]] std::vector<VanishingArm> vanishing_arms(const DigitTendons& tendons,
                                                       const Eigen::VectorXd& q);

/// Moment arm whose sign contradicts the subject's arms_mm or the muscle's name.
struct ReversedArm {
  std::string muscle, joint;
  double arm = 0;  // moment arm at this posture [m/rad]
};

/// Returns the arms that have the wrong sign by TendonDigit::actions and are at least 0.5 mm, so
/// that a tendon that runs straight across its joint is not reported.
/// @param R  moment arms at one posture (muscles, coordinates) [m/rad]
[[nodiscard]] std::vector<ReversedArm> reversed_arms(const TendonDigit& digit,
                                                     const Eigen::MatrixXd& R);

}  // namespace thenar
