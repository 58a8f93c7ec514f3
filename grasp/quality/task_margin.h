#pragma once

/// Task margin: the share of a task's loads that a grasp resists.

#include <vector>

#include "grasp/quality/inscribed_ball.h"

namespace thenar {

/// The largest k for which the grasp resists every load of k T, T the loads of a task.
struct [[nodiscard]] TaskMargin {
  Status status;  // of the program that failed, otherwise kSolved
  double lower;   // the true k is in [lower, upper], each to within `residual` of 1 + itself [1]
  double upper;   // infinite if nothing limits the forces [1]
  ScaledWrench worst_load;  // of T, or on its boundary: the first that is not resisted (6)
  double residual;          // largest of the KKT conditions of its programs, recomputed [1]
};

/// Margin of a list of loads T: k = min over loads of load_margin(), one program each, between the
/// forces found and the bound of the multipliers. As the wrenches are convex, the grasp resists k T
/// with all loads between these and zero. Without loads k is infinite.
/// Source: [Pollard1994] for task wrench sets.
TaskMargin margin_of_loads(const ForceSet& forces, const std::vector<ScaledWrench>& loads);

/// Margin of a box of loads, at most 64 corners: that of the list of its corners.
/// @throws InputError if a lower bound exceeds its upper or is not finite
TaskMargin margin_of_box(const ForceSet& forces, const ScaledWrench& lower,
                         const ScaledWrench& upper);

/// Margin of an ellipsoid of loads about zero, { Q y : |y| <= 1 }. With six axes k is the radius of
/// the inscribed ball of Q^-1 W. With fewer it is that of the slice of W along Q, computed in the
/// product of the slice with a wider box, which changes nothing.
/// @param Q  semi-axes in columns, independent (6, 1..6) [N]
/// @throws InputError if they are dependent
/// Source: [Li1988].
TaskMargin margin_of_ellipsoid(const ForceSet& forces,
                               const Eigen::Matrix<double, 6, Eigen::Dynamic>& Q,
                               const BallOptions& options = {});

}  // namespace thenar
