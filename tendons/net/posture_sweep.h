#pragma once

/// Postures of a sweep, and the start of a net at one of them.

#include <vector>

#include "tendons/net/net_continuation.h"

namespace thenar {

/// Interpolates postures between two, both included, evenly spaced. @param steps  intervals, > 0
[[nodiscard]] std::vector<Eigen::VectorXd> postures_between(const Eigen::VectorXd& from,
                                                            const Eigen::VectorXd& to, int steps);

/// Computes initial nodes at q by follow_from_straight(); empty for tendons without a net (3,
/// nodes).
[[nodiscard]] Eigen::Matrix3Xd start_from_straight(const DigitTendons& tendons,
                                                   const Eigen::VectorXd& q,
                                                   const Eigen::VectorXd& t);

}  // namespace thenar
