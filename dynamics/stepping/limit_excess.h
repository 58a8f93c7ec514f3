#pragma once

/// Excess of joints beyond their limits.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "dynamics/mechanism/mechanism.h"

namespace thenar {

/// Beyond a limit by less is at it: what fixed steps leave over of a landing [rad], [m].
inline constexpr double kAtLimitTurn = 1e-3;
inline constexpr double kAtLimitWay = 1e-4;

/// Keeps the largest way of each hinge and slide beyond its limits, up to these positions.
/// @param q       (q)
/// @param beyond  [rad] or [m] (joints); changed: empty at the start, then 0 of joints within them
void note_limits(const Mechanism& mechanism, const MechanismLayout& layout,
                 const Eigen::VectorXd& q, Eigen::VectorXd& beyond);

/// Keeps the larger ones of two. @param other, beyond  as of note_limits(); `beyond` is changed
void keep_larger(const Eigen::VectorXd& other, Eigen::VectorXd& beyond);

/// A joint that went beyond a limit.
struct PassedLimit {
  std::string joint;
  bool slides = false;
  double beyond = 0;  // farthest [rad]; of a slide [m]
};

/// The joints that went beyond their limits by more than kAtLimitTurn or kAtLimitWay.
/// @param beyond  as of note_limits()
[[nodiscard]] std::vector<PassedLimit> passed_limits(const Mechanism& mechanism,
                                                     const Eigen::VectorXd& beyond);

}  // namespace thenar
