#pragma once

/// Excess of joint values over the joint limits.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "dynamics/mechanism/mechanism.h"

namespace thenar {

/// Excess that still counts as at the limit; fixed steps leave as much when a joint lands [rad],
/// [m].
inline constexpr double kLimitAngleTolerance = 1e-3;
inline constexpr double kLimitLengthTolerance = 1e-4;

/// Updates the largest excess of each hinge and slide over its limits with those at a position.
/// @param q       positions (q)
/// @param excess  largest excess so far, 0 within the limits [rad] or [m] (joints); empty: none yet
void update_limit_excess(const Mechanism& mechanism, const MechanismLayout& layout,
                         const Eigen::VectorXd& q, Eigen::VectorXd& excess);

/// Sets `excess` to the larger entries of both. @param other, excess  as in update_limit_excess()
void keep_max_excess(const Eigen::VectorXd& other, Eigen::VectorXd& excess);

/// Joint that went beyond a limit.
struct PassedLimit {
  std::string joint;
  bool slides = false;  // slide, not hinge
  double excess = 0;    // largest excess [rad]; of a slide [m]
};

/// Returns the joints that exceeded a limit by more than the tolerances above.
/// @param excess  as in update_limit_excess()
[[nodiscard]] std::vector<PassedLimit> passed_limits(const Mechanism& mechanism,
                                                     const Eigen::VectorXd& excess);

}  // namespace thenar
